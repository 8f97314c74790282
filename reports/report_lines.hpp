// What a report leaves beside its tables: JSON objects, one a line, printed in their place where that is asked for, and kept for a file.
#pragma once

#include <string>
#include <vector>

#include "corpus/case/case.hpp"
#include "corpus/command/build_info.hpp"
#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"

namespace plumb::reports {

/// A table as text, a line each with its heading, and the same as JSON objects.
struct ReportTable {
  std::vector<std::string> lines;
  std::vector<Json> rows;

  void add(const std::string& line, const Json& row) {
    lines.push_back(line);
    rows.push_back(row);
  }
};

class ReportLines {
 public:
  /// --json, with what it says, and --out.
  void declare(CommandLine& app, const std::string& printed = "the JSON objects in the place of the tables") {
    app.add_flag("--json", is_json_, printed);
    app.add_option("--out", file_, "file for the JSON objects, one a line");
  }

  [[nodiscard]] bool is_json() const { return is_json_; }

  void add(const Json& line) {
    const std::string text = write_json(line);
    text_ += text + "\n";
    if (is_json_) print_line(text);
  }
  /// The first line: what repeats the report, and where it ran.
  void add_run(const std::string& command) { add({{"kind", "run"}, {"command", command}, {"host", host_json()}}); }
  /// The last line, after Ctrl-C.
  void add_end() {
    if (interrupted()) add({{"kind", "interrupted"}});
  }

  void print_table(const std::string& text) const {
    if (!is_json_) print_line(text);
  }

  /// A table under its title.
  void add(const std::string& title, const ReportTable& table) {
    std::string text = title + "\n";
    for (const std::string& line : table.lines) text += "  " + line + "\n";
    print_table(text);
    for (const Json& row : table.rows) add(row);
    flush_output();
  }

  void write() const {
    if (!file_.empty()) write_file(file_, text_);
  }

 private:
  bool is_json_ = false;
  std::string file_, text_;
};

}  // namespace plumb::reports
