// The second opinion asked from a test: lines in, verdicts out.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "properties/tests/corpus/programs.hpp"

namespace plumb {

struct SecondOpinions {
  int code;
  std::vector<Json> said;
};

inline SecondOpinions ask_second_opinion(const std::vector<Json>& lines) {
  const fs::path file = fs::temp_directory_path() / ("plumb-second-" + std::to_string(::getpid()) + ".jsonl");
  std::string text;
  for (const Json& line : lines) text += line.dump() + "\n";
  write_file(file, text);
  const Ran ran = run(PLUMB_BINARY_DIR "/bin/second-opinion " + file.string() + " 2>&1");
  fs::remove(file);
  return {ran.code, ran.code == 2 ? std::vector<Json>{Json(ran.out)} : lines_of(ran.out)};
}

}  // namespace plumb
