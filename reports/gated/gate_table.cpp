#include "reports/gated/gate_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "corpus/case/case.hpp"
#include "corpus/case/contract_words.hpp"
#include "corpus/command/text_table.hpp"
#include "corpus/file/text_input.hpp"
#include "corpus/json/number_text.hpp"
#include "reports/gated/gate_cases.hpp"
#include "solver/method/methods.hpp"

namespace plumb::reports {
namespace {

constexpr std::string_view header =
    "# plumb report-gate --update writes this table; reports/gate, which CI runs, holds plumb's methods to it.\n"
    "# judged, converged, FINDING=COUNT: exactly so many of the family's cases. The rest are bounds e of errors, which "
    "are to "
    "lie in\n"
    "# (e/2, e]: median and p99 of the answers that converged; angle: degrees to the certified common normal; overlap, "
    "points:\n"
    "# relative to the size, against the method's own problem; -: no answer could be judged.\n";

constexpr std::string_view frozen_header = "# frozen: every case of the ladders kept there, the easiest step first; "
                                           "lets_go=STEP: the easiest with a finding.\n";

/// The words of one line, taken one after the other.
class Words {
 public:
  Words(const std::string& line, std::string file, int number)
      : words_(line), file_(std::move(file)), number_(number) {}

  [[noreturn]] void refuse(const std::string& field, const std::string& reason) const {
    throw InputFailure(file_, number_, field, reason);
  }
  /// Empty at the end.
  [[nodiscard]] std::string next() {
    std::string word;
    words_ >> word;
    return word;
  }
  [[nodiscard]] std::uint64_t count(const std::string& field, std::uint64_t most) {
    const std::string word = next();
    const auto number = number_from<std::uint64_t>(word);
    if (!number || *number > most) refuse(field, fmt::format("'{}' is not a whole number up to {}", word, most));
    return *number;
  }
  [[nodiscard]] double error(const std::string& field) {
    const std::string word = next();
    if (word == "-") return std::numeric_limits<double>::quiet_NaN();
    const auto number = number_from<double>(word);
    if (!number || !std::isfinite(*number) || *number < 0)
      refuse(field, "'" + word + "' is no error, 0 or more, nor -");
    return *number;
  }
  void end() {
    if (const std::string word = next(); !word.empty()) refuse(word, "is one word too many");
  }

 private:
  std::istringstream words_;
  std::string file_;
  int number_;
};

bool is_family(const std::string& word, const GateTable& table) {
  const auto known = gate_families(table);
  return std::find(known.begin(), known.end(), word) != known.end();
}

void refuse_family(const Words& words, const std::string& field, const GateTable& table, const std::string& reason) {
  words.refuse(field, reason + (table.is_frozen() ? table.frozen + " has the ladders" : "plumb families lists them"));
}

FindingKind kind_of(const Words& words, const std::string& word) {
  const auto known = finding_words();
  const auto found = std::find(known.begin(), known.end() - 1, word);  // "none", the last, is not counted
  if (found == known.end() - 1) words.refuse(word, "no such finding");
  return static_cast<FindingKind>(found - known.begin());
}

std::uint64_t read_step(const Words& words, const std::string& text) {
  const auto step = number_from<std::uint64_t>(text);
  if (!step || *step == 0) words.refuse("lets_go", fmt::format("'{}' is no step", text));
  return *step;
}

/// FINDING=COUNT and lets_go=STEP, up to the end of the line.
void read_findings(Words& words, GateRow& row, std::uint64_t cases) {
  for (std::string word = words.next(); !word.empty(); word = words.next()) {
    const std::size_t sign = std::min(word.find('='), word.size());
    const std::string name = word.substr(0, sign);
    if (name == "lets_go" && row.lets_go == 0) {
      row.lets_go = read_step(words, word.substr(std::min(sign + 1, word.size())));
      continue;
    }
    const FindingKind kind = kind_of(words, name);
    const auto count = number_from<std::uint64_t>(word.substr(std::min(sign + 1, word.size())));
    if (!count || *count == 0 || *count > cases)
      words.refuse(name, fmt::format("'{}' is no count up to {}", word, cases));
    if (!row.findings.emplace(kind, *count).second) words.refuse(name, "stands there twice");
  }
}

void read_cases(Words& words, GateTable& table) {
  const std::string family = words.next();
  if (!is_family(family, table)) refuse_family(words, "cases", table, "no family '" + family + "'; ");
  constexpr std::uint64_t most = 1'000'000'000;
  const std::uint64_t count = words.count("cases", most);
  if (count == 0) words.refuse("cases", "is 0");
  if (!table.cases.emplace(family, count).second) words.refuse("cases", family + " stands there twice");
  words.end();
}

void read_seed(Words& words, GateTable& table) {
  table.seed = words.count("seed", std::numeric_limits<std::uint64_t>::max());
  words.end();
}

void read_frozen(Words& words, GateTable& table) {
  table.frozen = words.next();
  if (table.frozen.empty() || gate_families(table).empty())
    words.refuse("frozen", "'" + table.frozen + "' is no folder of ladders");
  words.end();
}

void read_row(Words& words, const std::string& family, GateTable& table) {
  if (!is_family(family, table)) refuse_family(words, family, table, "is neither seed nor cases nor a family; ");
  if (!table.cases.contains(family)) words.refuse(family, "has no line 'cases' above");
  const std::uint64_t cases = table.cases.at(family);
  GateRow row{family, words.next(), 0, 0, {}, {}, 0};
  if (find_method(row.method) == nullptr) words.refuse("method", "plumb has no method '" + row.method + "'");
  if (table.find(family, row.method) != nullptr) words.refuse(family, row.method + " stands there twice");
  row.judged = words.count("judged", cases);
  row.converged = words.count("converged", cases);
  for (std::size_t i = 0; i < error_names.size(); ++i) row.errors[i] = words.error(std::string(error_names[i]));
  read_findings(words, row, cases);
  table.rows.push_back(std::move(row));
}

void read_line(Words& words, GateTable& table) {
  const std::string first = words.next();
  if (first == "seed")
    read_seed(words, table);
  else if (first == "frozen")
    read_frozen(words, table);
  else if (first == "cases")
    read_cases(words, table);
  else if (!first.empty() && !first.starts_with('#'))
    read_row(words, first, table);
}

TextTable columns_of(const GateTable& table) {
  std::vector<Column> columns{
      {"# family", table.is_frozen() ? "<26" : "<13"}, {"method", "<27"}, {"judged", ">7"}, {"converged", ">10"}};
  for (const std::string_view error : error_names) columns.push_back({std::string(error), ">12"});
  columns.push_back({"  findings", ""});
  return TextTable(columns);
}

std::string row_text(const GateRow& row, const TextTable& columns) {
  std::vector<std::string> cells{row.family, row.method, std::to_string(row.judged), std::to_string(row.converged)};
  for (const double error : row.errors) cells.push_back(error_text(error));
  cells.emplace_back();
  for (const auto& [kind, count] : row.findings) cells.back() += fmt::format("  {}={}", name(kind), count);
  if (row.lets_go > 0) cells.back() += fmt::format("  lets_go={}", row.lets_go);
  return columns.row_of(cells) + "\n";
}

}  // namespace

const GateRow* GateTable::find(const std::string& family, const std::string& method) const {
  const auto is_it = [&](const GateRow& row) { return row.family == family && row.method == method; };
  const auto found = std::find_if(rows.begin(), rows.end(), is_it);
  return found == rows.end() ? nullptr : &*found;
}

GateTable read_gate_table(const std::filesystem::path& file) {
  TextInput in(file.string());
  GateTable table;
  for (std::string line; in.next_line(line);) {
    Words words(line, file.string(), in.line());
    read_line(words, table);
  }
  for (const std::string& family : gate_families(table))
    if (!table.cases.contains(family))
      throw InputFailure(file.string(), 0, "cases", fmt::format("{} has no line", family));
  return table;
}

std::string gate_table_text(const GateTable& table) {
  std::string text(header);
  text += table.is_frozen() ? fmt::format("{}frozen {}\n", frozen_header, table.frozen)
                            : fmt::format("seed {}\n", table.seed);
  for (const std::string& family : gate_families(table))
    text += fmt::format("cases {} {}\n", family, table.cases.at(family));
  const TextTable columns = columns_of(table);
  text += columns.head() + "\n";
  for (const GateRow& row : table.rows) text += row_text(row, columns);
  return text;
}

std::string error_text(double error) {
  return std::isnan(error) ? "-" : fmt::format("{}", error);
}

}  // namespace plumb::reports
