// plumb report-stability: do answers keep their digits? The frozen hard cases solved in every arithmetic - float to 50 digits, all
// rounding modes, stochastic rounding, other compilers and options - each held against its certificate.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <thread>
#include <utility>

#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/command/text_table.hpp"
#include "corpus/json/nearest_word.hpp"
#include "corpus/solvers/solver.hpp"
#include "reports/report_lines.hpp"
#include "reports/stability/rows.hpp"

namespace plumb::reports {
namespace {

struct Options {
  std::vector<std::string> paths, arithmetic;
  std::string method;
  ReportLines lines;
  ForeignOption foreign;
  std::uint64_t samples = 5, cases = 0;  // 0 cases: all
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  bool list = false;
};

void declare(CommandLine& app, Options& options) {
  app.add_option("PATH", options.paths,
                 "frozen ladders (plumb ladder --write), and folders of them; motions are left out")
      ->required();
  app.add_option("--method", options.method, "common-normal methods: NAME,.. or all; default auto without --solver");
  declare_solver(app, options.foreign,
                 "a shared library behind solver/plumb_solver.h, in its own arithmetic; any number");
  app.add_option("--arithmetic", options.arithmetic, "NAME,..; default: all that this build has")->delimiter(';');
  app.add_option("--samples", options.samples, "solves of each case in stochastic rounding")
      ->capture_default_str()
      ->check(refuse_count);
  app.add_option("--cases", options.cases, "the first so many of each step; default: all")->check(refuse_count);
  app.add_option("--threads", options.threads, "changes nothing but the time")->in_range(1, 1024);
  app.add_flag("--list", options.list, "every answer that is lost or wrong, a line each, also of published methods");
  options.lines.declare(app);
}

std::string own_methods(const Options& options) {
  return options.method.empty() && options.foreign.empty() ? "auto" : options.method;
}

std::vector<std::string> methods_of(const Options& options, const std::vector<Solver>& foreign) {
  std::vector<std::string> out;
  for (const Solver& solver : foreign) out.push_back(solver.name);
  if (own_methods(options).empty()) return out;
  for (const Solver& solver : find_solvers(own_methods(options))) {
    const bool is_one = solver.abilities.problem == Problem::common_normal && !solver.name.starts_with("peer");
    if (!is_one && options.method != "all")
      throw InputFailure("--method", 0, solver.name, "is no common-normal method of plumb's");
    if (is_one) out.push_back(solver.name);
  }
  return out;
}

std::vector<Arithmetic> arithmetics_of(const Options& options) {
  std::vector<Arithmetic> known = arithmetics(options.samples);
  if (options.arithmetic.empty()) return known;
  std::vector<Arithmetic> out;
  for (const std::string& name : options.arithmetic) {
    const auto found = std::find_if(known.begin(), known.end(), [&](const Arithmetic& a) { return a.name == name; });
    const bool is_there = std::any_of(out.begin(), out.end(), [&](const Arithmetic& a) { return a.name == name; });
    if (found != known.end()) {
      if (!is_there) out.push_back(*found);
      continue;
    }
    std::vector<std::string> names;
    for (const Arithmetic& one : known) names.push_back(one.name);
    throw InputFailure("--arithmetic", 0, name, no_such("arithmetic of this build", name, names));
  }
  return out;
}

/// A step of a motion is judged by plumb path.
bool is_of_motion(const Case& c) {
  return c.provenance.is_object() && c.provenance.contains("path");
}

std::vector<CertifiedCase> cases_of(const Options& options) {
  std::vector<CertifiedCase> out;
  std::map<std::pair<std::string, std::size_t>, std::uint64_t> of_step;
  for (const auto& file : find_case_files(options.paths)) {
    CaseReader reader(file.string());
    for (std::optional<Case> c = reader.next(); c; c = reader.next()) {
      if (is_of_motion(*c)) continue;
      CertifiedCase read = read_certified(*std::move(c), file.string(), reader.line());
      const std::uint64_t place = ++of_step[{read.ladder, read.step}];
      if (options.cases == 0 || place <= options.cases) out.push_back(std::move(read));
    }
  }
  if (out.empty()) throw InputFailure(options.paths.front(), 0, "", "holds no case");
  return out;
}

Json json_of(const StabilityRow& row) {
  const auto counts = [&](std::uint64_t StepCounts::* which) {
    Json out = Json::array();
    for (const StepCounts& step : row.steps) out.push_back(step.*which);
    return out;
  };
  Json out{{"kind", "row"},       {"ladder", row.ladder}, {"knob", row.knob},
           {"steps", row.values}, {"method", row.method}, {"arithmetic", row.arithmetic}};
  out["cases"] = counts(&StepCounts::answers);
  out["right"] = counts(&StepCounts::right);
  out["lost"] = counts(&StepCounts::lost);
  out["wrong"] = counts(&StepCounts::wrong);
  const auto digits = [&](double error) {
    return row.total().right > 0 ? Json(digits_of(error, row.epsilon)) : Json();
  };
  out["digits"] = {{"overlap", digits(row.largest.overlap)},
                   {"normal", digits(row.largest.normal)},
                   {"points", digits(row.largest.points)}};
  out["lets_go"] = row.lets_go() > 0 ? Json(row.lets_go()) : Json();
  return out;
}

void add_lines(const StabilityResults& results, Options& options, const std::vector<Solver>& foreign) {
  const std::string fewer = options.cases > 0 ? fmt::format(" --cases {}", options.cases) : "";
  std::string who = own_methods(options).empty() ? "" : " --method " + own_methods(options);
  for (const Solver& solver : foreign) who += solver.option;
  const std::string command = fmt::format("plumb report-stability {}{} --samples {}{}", fmt::join(options.paths, " "),
                                          who, options.samples, fewer);
  options.lines.add_run(command);
  for (const StabilityRow& row : results.rows) options.lines.add(json_of(row));
  options.lines.add_end();
}

/// The rows of a method in an arithmetic as one.
StabilityRow joined(const std::vector<StabilityRow>& rows, const std::string& method, const std::string& arithmetic) {
  StabilityRow out;
  out.steps.emplace_back();
  for (const StabilityRow& row : rows) {
    if (row.method != method || row.arithmetic != arithmetic) continue;
    const StepCounts total = row.total();
    out.epsilon = row.epsilon;
    out.steps[0].answers += total.answers;
    out.steps[0].right += total.right;
    out.steps[0].lost += total.lost;
    out.steps[0].wrong += total.wrong;
    out.largest = {std::max(out.largest.overlap, row.largest.overlap), std::max(out.largest.normal, row.largest.normal),
                   std::max(out.largest.points, row.largest.points)};
  }
  return out;
}

/// Of the answers that are right.
std::string digits_text(const StabilityRow& row, double error) {
  return row.total().right > 0 ? fmt::format("{:.1f}", digits_of(error, row.epsilon)) : "-";
}

void print_arithmetics(const StabilityResults& results, const std::vector<std::string>& methods,
                       const std::vector<Arithmetic>& of) {
  const TextTable columns({{"method", "<18"},
                           {"arithmetic", "<52"},
                           {"answers", ">9"},
                           {"right", ">8"},
                           {"lost", ">7"},
                           {"wrong", ">7"},
                           {"overlap digits", ">16"}});
  print_line(columns.head());
  for (const std::string& method : methods)
    for (const Arithmetic& arithmetic : of) {
      const StabilityRow row = joined(results.rows, method, arithmetic.name);
      const StepCounts n = row.total();
      if (n.answers > 0)
        print_line(columns.row(method, arithmetic.name, n.answers, n.right, n.lost, n.wrong,
                               digits_text(row, row.largest.overlap)));
    }
}

std::string step_text(const StabilityRow& row) {
  const std::uint64_t step = row.lets_go();
  return step == 0 ? "-" : fmt::format("{} ({:g})", step, row.values[step - 1]);
}

/// In double, where each method lets go.
void print_ladders(const StabilityResults& results) {
  const TextTable columns({{"ladder, in double", "<27"},
                           {"knob", "<16"},
                           {"method", "<18"},
                           {"right", ">6", "/"},
                           {"of", "<5"},
                           {"overlap", ">9"},
                           {"normal", ">8"},
                           {"points", ">8", "  "},
                           {"lets go at step", ""}});
  print_line("\n" + columns.head());
  for (const StabilityRow& row : results.rows) {
    if (row.arithmetic != "double") continue;
    const StepCounts n = row.total();
    print_line(columns.row(row.ladder, row.knob, row.method, n.right, n.answers, digits_text(row, row.largest.overlap),
                           digits_text(row, row.largest.normal), digits_text(row, row.largest.points), step_text(row)));
  }
}

int report(Options& options) {
  const std::vector<Solver> foreign = load_solvers(options.foreign);
  const std::vector<std::string> methods = methods_of(options, foreign);
  std::vector<Arithmetic> of = arithmetics_of(options);
  for (Arithmetic& arithmetic : of)
    if (arithmetic.name == "double") arithmetic = with_foreign(arithmetic, foreign);
  const StabilityResults results = measure_stability(cases_of(options), methods, of, options.threads);
  add_lines(results, options, foreign);
  options.lines.write();
  if (!options.lines.is_json()) {
    print_arithmetics(results, methods, of);
    print_ladders(results);
  }
  std::size_t failures = 0;
  for (const Unstable& one : results.unstable) {
    failures += one.is_failure ? 1 : 0;
    if (one.is_failure || options.list) options.lines.print_table(one.line);
  }
  return failures > 0 ? exit_finding : exit_done;
}

}  // namespace
}  // namespace plumb::reports

int main(int argc, char** argv) {
  plumb::reports::Options options;
  plumb::CommandLine app("The frozen hard cases in every arithmetic, against their certificates.",
                         "plumb report-stability");
  plumb::reports::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::reports::report(options); });
}
