#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "corpus/command/text_table.hpp"
#include "fuzz/results/table.hpp"

namespace plumb {
namespace {

constexpr std::size_t kWidth = 11;

/// "geometric_potential_midway" in lines that fit: "geometric", "_potential", "_midway".
std::vector<std::string> heading_lines(const std::string& method) {
  std::vector<std::string> lines;
  std::stringstream parts(method);
  for (std::string part; std::getline(parts, part, '_');) {
    if (!lines.empty()) part.insert(0, 1, '_');
    if (!lines.empty() && lines.back().size() + part.size() < kWidth)
      lines.back() += part;
    else
      lines.push_back(part.substr(0, kWidth - 1));
  }
  return lines;
}

/// A cell more than `cells`: the first.
std::string line_of(const std::string& head, std::vector<std::string> cells) {
  std::vector<Column> columns(cells.size() + 1, {"", fmt::format(">{}", kWidth)});
  columns.front().spec = "<25";
  cells.insert(cells.begin(), head);
  return TextTable(columns, " ").row_of(cells) + "\n";
}

/// The names stand on one foot.
std::string ladder_heading(const std::vector<std::string>& methods) {
  std::vector<std::vector<std::string>> names;
  std::size_t height = 0;
  for (const std::string& method : methods) {
    names.push_back(heading_lines(method));
    height = std::max(height, names.back().size());
  }
  std::string text;
  for (std::size_t line = 0; line < height; ++line) {
    std::vector<std::string> cells;
    for (const auto& name : names) {
      const std::size_t above = height - name.size();
      cells.push_back(line < above ? "" : name[line - above]);
    }
    text += line_of(line + 1 == height ? "lets go at" : "", cells);
  }
  return text;
}

std::string knob_value(double x) {
  return x >= 1e3 && x < 1e6 ? fmt::format("{:.0f}", x) : fmt::format("{:.3g}", x);
}

std::string lets_go_text(const Ladder& ladder, const std::string& method) {
  const auto row = ladder.methods.find(method);
  if (row == ladder.methods.end()) return "";
  const auto step = lets_go(row->second);
  return step ? knob_value(ladder.steps[*step]) : "-";
}

}  // namespace

std::string ladders_text(const FamilyResults& family) {
  if (family.ladders.empty()) return "";
  const std::vector<std::string> methods = method_order(family.methods);
  std::string text = "\n" + ladder_heading(methods);
  for (const std::string& name : ladder_order(family.ladders)) {
    const Ladder& ladder = family.ladders.at(name);
    std::vector<std::string> cells;
    for (const std::string& method : methods) cells.push_back(lets_go_text(ladder, method));
    text += line_of(name, cells);
  }
  return text + "  lets go at: the value of the ladder's easiest step with a finding; -: no step has one.\n";
}

}  // namespace plumb
