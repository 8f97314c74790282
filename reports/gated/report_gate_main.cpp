// plumb report-gate: does every method still reach what the table says, no less and no more?
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "fuzz/campaign/arguments.hpp"
#include "properties/generators/families.hpp"
#include "reports/gated/gate_cases.hpp"
#include "reports/gated/gate_compare.hpp"
#include "reports/gated/gate_measure.hpp"
#include "solver/method/methods.hpp"

namespace plumb::reports {
namespace {

namespace fs = std::filesystem;

struct Options {
  bool check = false, update = false;
  std::string table = PLUMB_SOURCE_DIR "/reports/gated/accuracy.txt";
  std::string family = "all", method = "all", frozen;
  std::uint64_t cases = 0;
  unsigned threads = default_threads();
};

void declare(CommandLine& app, Options& options) {
  auto* check = app.add_flag("--check", options.check,
                             "a line for each deviation from the table; exit 1: there is one (default)");
  auto* update = app.add_flag("--update", options.update, "write what is measured into the table")->excludes(check);
  app.add_option("--table", options.table, "default: reports/gated/accuracy.txt of the sources");
  app.add_option("--frozen", options.frozen, "with --update: a new table, of the ladders that are kept in this folder")
      ->needs(update);
  auto* cases = app.add_option("--cases", options.cases, "with --update: so many cases of each family from now on");
  cases->check(refuse_count)->needs(update);
  app.add_option("--family", options.family, "NAME,.. or all (plumb families lists them)")->capture_default_str();
  app.add_option("--method", options.method, "NAME,.. of plumb's own or all")->capture_default_str()->excludes(cases);
  app.add_option("--threads", options.threads, "changes nothing but the time")->in_range(1, 1024);
}

/// Which peers there are depends on the machine: they are not held to anything.
std::vector<Solver> solvers_of(const Options& options) {
  std::vector<Solver> solvers = find_solvers(options.method);
  const auto is_peer = [](const Solver& solver) { return find_method(solver.name) == nullptr; };
  if (options.method == "all") std::erase_if(solvers, is_peer);
  const auto peer = std::find_if(solvers.begin(), solvers.end(), is_peer);
  if (peer != solvers.end()) throw InputFailure("--method", 0, peer->name, "a peer has no row in the table");
  return solvers;
}

GateTable first_table(const std::string& frozen) {
  GateTable table;
  table.frozen = frozen;
  if (table.is_frozen()) {
    if (gate_families(table).empty()) throw InputFailure("--frozen", 0, frozen, "is no folder of ladders");
    return table;
  }
  for (const Family& family : families()) table.cases[std::string(family.name)] = family.gated;
  return table;
}

std::string text_of(const fs::path& table) {
  const std::string here = fs::proximate(table).string();
  return here.starts_with("..") ? table.string() : here;
}

int check(const Options& options) {
  const GateTable table = read_gate_table(options.table);
  const auto rows = measure_rows(chosen_families(table, options.family), solvers_of(options), table, options.threads);
  std::vector<std::string> lines;
  for (const GateRow& row : rows) {
    const GateRow* wanted = table.find(row.family, row.method);
    const auto of_row = wanted != nullptr
                            ? deviations(*wanted, row)
                            : std::vector{fmt::format("{} {}: not in the table, plumb report-gate --update adds it",
                                                      row.family, row.method)};
    lines.insert(lines.end(), of_row.begin(), of_row.end());
  }
  if (interrupted()) return exit_interrupted;
  for (const std::string& line : lines) print_line(line);
  print_line(fmt::format("{} rows, {} deviations from {}", rows.size(), lines.size(), text_of(options.table)));
  return lines.empty() ? exit_done : exit_finding;
}

/// In the order of `plumb families` and `plumb methods`.
std::vector<GateRow> sorted_rows(const GateTable& table) {
  std::vector<GateRow> out;
  for (const std::string& family : gate_families(table))
    for (const Method& method : methods())
      for (const GateRow& row : table.rows)
        if (row.family == family && row.method == method.name) out.push_back(row);
  return out;
}

int update(const Options& options) {
  GateTable table = fs::exists(options.table) ? read_gate_table(options.table) : first_table(options.frozen);
  const auto chosen = chosen_families(table, options.family);
  for (const std::string& family : chosen)
    if (options.cases > 0 || table.is_frozen())
      table.cases[family] = table.is_frozen() ? count_kept(table, family) : options.cases;
  const auto rows = measure_rows(chosen, solvers_of(options), table, options.threads);
  if (interrupted()) return exit_interrupted;
  for (const GateRow& row : rows) {
    const GateRow wanted = updated(table.find(row.family, row.method), row);
    std::erase_if(table.rows, [&](const GateRow& r) { return r.family == row.family && r.method == row.method; });
    table.rows.push_back(wanted);
  }
  table.rows = sorted_rows(table);
  write_file(options.table, gate_table_text(table));
  print_line(fmt::format("{} rows written to {}", rows.size(), text_of(options.table)));
  return exit_done;
}

}  // namespace
}  // namespace plumb::reports

int main(int argc, char** argv) {
  plumb::reports::Options options;
  plumb::CommandLine app(
      "Every method on every family against the table of what it must reach: nothing changes unannounced.",
      "plumb report-gate");
  plumb::reports::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] {
    return options.update ? plumb::reports::update(options) : plumb::reports::check(options);
  });
}
