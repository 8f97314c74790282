// Dumps as text, written by hand after the formats' documentation (corpus/formats/dumps.md), and what is read from them.
#pragma once

#include <fmt/format.h>

#include <sstream>
#include <string>
#include <vector>

#include "corpus/dump/dump_pairs.hpp"
#include "corpus/dump/dump_reader.hpp"

namespace plumb {

inline const std::string open_box = "ITEM: BOX BOUNDS ff ff ff\n-10 10\n-10 10\n-10 10\n";
inline const std::string lammps_columns = "id type x y z quatw quati quatj quatk shapex shapey shapez block1 block2";

struct DumpText {
  std::string columns = lammps_columns;
  std::vector<std::string> rows;
  std::string box = open_box;
  std::string step = "100";
  std::string before{};  ///< items before the step

  [[nodiscard]] std::string text() const {
    std::string out = before + "ITEM: TIMESTEP\n" + step + "\nITEM: NUMBER OF ATOMS\n" + std::to_string(rows.size());
    out += "\n" + box + "ITEM: ATOMS " + columns + " \n";  // LAMMPS ends its lines with a blank
    for (const std::string& row : rows) out += row + " \n";
    return out;
  }
};

inline std::vector<DumpFrame> frames_of(const std::string& text, const DumpOptions& options = {}) {
  std::istringstream in(text);
  DumpReader reader(in, "d.dump", options);
  std::vector<DumpFrame> out;
  while (auto frame = reader.next([](std::int64_t) { return true; })) out.push_back(std::move(*frame));
  return out;
}

inline std::vector<DumpPair> pairs_of(const DumpFrame& frame, double gap = 0) {
  std::vector<DumpPair> out;
  each_touching_pair(frame, gap, [&](const DumpPair& pair) { out.push_back(pair); });
  return out;
}

}  // namespace plumb
