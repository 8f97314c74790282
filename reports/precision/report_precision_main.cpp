// plumb report-precision: what accuracy costs. Every method in each of its scalars at each tolerance: time against error, and
// how often there is no answer, or none near the truth.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "corpus/command/build_info.hpp"
#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "reports/precision/precision_table.hpp"
#include "reports/report_lines.hpp"

namespace plumb::reports {
namespace {

struct Options {
  std::vector<std::string> sets;
  std::string method = "all";
  ReportLines lines;
  std::int64_t count = 200;
  std::uint64_t seed = 1;
  int repeat = 5;
};

void declare(CommandLine& app, Options& options) {
  app.add_option("--set", options.sets,
                 "spheroid, ellipsoid, exponents-8, whole, exponents-40, hard; default: all of them")
      ->delimiter(',');
  app.add_option("--method", options.method, "NAME,.. or all (plumb methods lists them)")->capture_default_str();
  app.add_option("--cases", options.count, "pairs of each set")->capture_default_str()->check(refuse_count);
  declare_seed(app, options.seed, "same seed, same pairs");
  app.add_option("--repeat", options.repeat, "time each pair so often; the least counts")
      ->capture_default_str()
      ->in_range(1, 1000);
  options.lines.declare(app);
}

/// nullopt after Ctrl-C.
std::optional<SetResults> measured(const PairSet& set, const std::vector<Solver>& solvers, const Options& options) {
  const std::vector<Case> cases = draw(set, static_cast<std::size_t>(options.count), options.seed);
  const Truths truths = truths_of(cases);
  if (interrupted()) return std::nullopt;
  const std::vector<Truth>& of_normals = truths.at(Problem::common_normal);
  SetResults out;
  out.set = set;
  out.pairs = cases.size();
  out.known = static_cast<std::size_t>(
      std::count_if(of_normals.begin(), of_normals.end(), [](const Truth& truth) { return truth.known; }));
  out.envelopes = envelopes(of_normals);
  out.points = points_of(variants(solvers), cases, truths, options.repeat);
  out.front = front_of(out.points);
  out.paths = paths_of(solvers, cases, truths);
  out.arguments = fmt::format("--cases {} --seed {} --repeat {}", options.count, options.seed, options.repeat);
  if (interrupted()) return std::nullopt;
  return out;
}

std::string arguments_of(const Options& options) {
  std::string sets;
  for (const std::string& set : options.sets) sets += (sets.empty() ? " --set " : ",") + set;
  const std::string methods = options.method == "all" ? "" : " --method " + options.method;
  return sets + methods + fmt::format(" --cases {} --seed {} --repeat {}", options.count, options.seed, options.repeat);
}

/// What is done is kept; which sets are not is said on stderr, and in the table or the last line.
void say_what_is_left_out(const std::vector<PairSet>& sets, std::size_t done, ReportLines& lines) {
  Json names = Json::array();
  std::string text = "interrupted: incomplete, without";
  for (std::size_t i = done; i < sets.size(); ++i) {
    names.push_back(sets[i].name);
    text += (i == done ? " " : ", ") + std::string(sets[i].name);
  }
  (void)std::fprintf(stderr, "%s\n", text.c_str());
  lines.print_table(text);
  lines.add({{"kind", "interrupted"}, {"without", names}});
}

int report(Options& options) {
  const std::vector<PairSet> sets = find_sets(sets_with_hard(), options.sets);
  const std::vector<Solver> solvers = find_solvers(options.method);
  ReportLines& lines = options.lines;
  lines.add_run("plumb report-precision" + arguments_of(options));
  std::size_t done = 0;
  for (; done < sets.size() && !interrupted(); ++done) {
    const std::optional<SetResults> results = measured(sets[done], solvers, options);
    if (!results) break;
    for (const Json& line : json_lines(*results)) lines.add(line);
    if (!lines.is_json()) print_table(*results);
    flush_output();
  }
  if (done < sets.size()) say_what_is_left_out(sets, done, lines);
  lines.write();
  return exit_done;
}

}  // namespace
}  // namespace plumb::reports

int main(int argc, char** argv) {
  plumb::reports::Options options;
  plumb::CommandLine app(
      "What accuracy costs in time: every method, scalar and tolerance, against the certified reference.",
      "plumb report-precision");
  plumb::reports::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::reports::report(options); });
}
