// Dumps of particles as text, one frame after the other: the one reader of them. Formats: corpus/formats/dumps.md.
#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/dump/dump_columns.hpp"
#include "corpus/dump/dump_frame.hpp"
#include "corpus/file/text_input.hpp"

namespace plumb {

/// Holds one frame at a time. Every function throws InputFailure (corpus/case/case.hpp), with the line.
class DumpReader {
 public:
  /// "-" is standard input.
  DumpReader(const std::string& path, DumpOptions options);
  /// `name` stands for the file in errors.
  DumpReader(std::istream& in, std::string name, DumpOptions options);
  DumpReader(const DumpReader&) = delete;
  DumpReader& operator=(const DumpReader&) = delete;

  /// The next frame whose step is wanted, nullopt at the end. Rows of the others are passed over unread.
  [[nodiscard]] std::optional<DumpFrame> next(const std::function<bool(std::int64_t)>& is_wanted);
  [[nodiscard]] const std::string& file() const { return in_.file(); }
  /// What was taken for what so far, each once.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

 private:
  struct Items;
  struct Head;

  [[noreturn]] void fail(const std::string& field, const std::string& reason) const;
  [[nodiscard]] bool read_line();
  void need_line(const char* what);
  [[nodiscard]] std::optional<Head> read_head();
  void read_item(Items& head);
  void read_box(Items& head, std::string_view words);
  void read_atoms(Items& head, std::string_view names) const;
  void pass_over(const Head& head);
  [[nodiscard]] DumpFrame read_rows(const Head& head);
  void sort_particles(DumpFrame& frame) const;
  void note(const std::vector<std::string>& notes);
  [[nodiscard]] std::int64_t whole_number(std::string_view text, const std::string& field) const;
  [[nodiscard]] double number(std::string_view text, const std::string& field) const;
  /// A number that is no larger than any length may be.
  [[nodiscard]] double length(std::string_view text, const std::string& field) const;
  [[nodiscard]] std::optional<DumpParticle> read_particle(const Head& head,
                                                          const std::vector<std::string_view>& row) const;
  [[nodiscard]] std::optional<Superellipsoid<double>> read_shape(const DumpColumns& columns,
                                                                 const std::vector<std::string_view>& row) const;

  TextInput in_;
  DumpOptions options_;
  std::string line_, units_;
  std::vector<std::string> notes_;
};

}  // namespace plumb
