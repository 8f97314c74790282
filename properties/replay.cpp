// plumb replay: every kept case against what it expects.
#include <fmt/format.h>

#include "corpus/command.hpp"
#include "corpus/interrupt.hpp"
#include "corpus/reference_store.hpp"
#include "properties/replay_case.hpp"
#include "properties/replay_reports.hpp"

namespace plumb {
namespace {

struct Options {
  std::vector<std::string> paths;
  std::string method;
  std::string library;
  std::string junit;
  std::string sarif;
  std::string cache;
  bool quiet = false;
};

void declare(CLI::App& app, Options& options) {
  app.add_option("PATH", options.paths, "case files, and folders of them")->required();
  auto* method = app.add_option("--method", options.method, "instead of the method that each case names");
  app.add_option("--solver", options.library, "the same, a shared library (solver/plumb_solver.h)")->excludes(method);
  app.add_option("--junit", options.junit, "write JUnit XML to this file");
  app.add_option("--sarif", options.sarif, "write SARIF 2.1.0 to this file");
  app.add_option("--cache", options.cache, cache_help);
  app.add_flag("--quiet", options.quiet, "print the cases that differ or were not judged, and the last line, only");
}

std::optional<Solver> solver_instead(const Options& options) {
  if (!options.library.empty()) return load_solver(options.library);
  if (options.method.empty()) return std::nullopt;
  const std::vector<Solver> solvers = find_solvers(options.method);
  if (solvers.size() != 1) throw InputFailure("--method", 0, options.method, "replay takes one method");
  return solvers.front();
}

/// How every case is replayed.
struct By {
  std::optional<Solver> instead;
  ReferenceSource source;
};

void replay_file(std::vector<Replayed>& done, const std::string& file, const By& by, bool quiet) {
  CaseReader reader(file);
  while (!interrupted()) {
    const std::optional<Case> c = reader.next();
    if (!c) return;
    done.push_back(replay_case(*c, file, reader.line(), by.instead, by.source));
    if (!quiet || outcome(done.back()) != Outcome::as_expected) print_line(replay_line(done.back()));
  }
}

void write_reports(const Options& options, const std::vector<Replayed>& done) {
  if (!options.junit.empty()) write_file(options.junit, junit_report(done, !interrupted()));
  if (!options.sarif.empty()) write_file(options.sarif, sarif_report(done, !interrupted()));
}

int replay(const Options& options) {
  const auto store = open_store(options.cache);
  const By by{solver_instead(options), references_of(store)};
  std::vector<Replayed> done;
  for (const auto& file : find_case_files(options.paths)) replay_file(done, file.string(), by, options.quiet);
  if (done.empty() && !interrupted()) throw InputFailure(options.paths.front(), 0, "", "holds no case");
  write_reports(options, done);
  if (store) fmt::print(stderr, "{}\n", in_words(store->counts()));
  print_line(replay_total(done, !interrupted()));
  return count_of(done, Outcome::differs) > 0 ? exit_finding : exit_done;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Options options;
  CLI::App app("Run kept cases against what they expect; 1 when one differs.", "plumb replay");
  plumb::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::replay(options); });
}
