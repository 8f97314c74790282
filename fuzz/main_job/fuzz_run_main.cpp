// plumb fuzz-run: what ./fuzz/run runs - real pairs, the families, then the coverage-guided targets; a verdict in words.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>

#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/command/progress.hpp"
#include "corpus/solvers/host/shell_words.hpp"
#include "fuzz/campaign/arguments.hpp"
#include "fuzz/campaign/out_folder.hpp"
#include "fuzz/main_job/engine_run.hpp"
#include "fuzz/main_job/verdict.hpp"
#include "fuzz/results/ranking.hpp"
#include "fuzz/results/table.hpp"
#include "properties/generators/families.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReal = "real";  // the family of no campaign

struct Arguments {
  double minutes = 5;
  std::uint64_t seed = 1;
  bool force = false;
  unsigned threads = default_threads();
  std::string out = "build/fuzz-run", fuzzers;
  bool first = false;
  std::string real = PLUMB_SOURCE_DIR "/corpus/cases/real", seeds = PLUMB_SOURCE_DIR "/fuzz/seeds";
};

/// How many a minute: a measure of work, from the speed of two cores. Counts and not a clock end this program, so that a
/// second machine finds the same; ./fuzz/run says by which minutes it asked.
struct Rate {
  const char* what;
  double per_minute;
};
constexpr Rate kTargets[] = {{"pair", 150}, {"contact", 10000}, {"methods", 1000}, {"scalars", 1000}, {"shapes", 300}};

/// Of the families, before anything else: some 2000 pairs.
constexpr double minutes_of_the_first = 0.14;

std::uint64_t scaled(double per_minute, double minutes) {
  return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(per_minute * minutes)));
}

/// Names its cases by their place in the folder, which the seed does not change.
Source real_source(const std::string& folder) {
  std::vector<Case> cases;
  for (const fs::path& path : find_case_files({folder})) {
    CaseReader reader(path.string());
    while (auto c = reader.next()) {
      if (!c->provenance.is_object()) c->provenance = Json::object();
      c->provenance["family"] = kReal;
      c->provenance["index"] = cases.size();
      cases.push_back(std::move(*c));
    }
  }
  if (cases.empty()) throw InputFailure(folder, 0, "--real", "holds no case");
  const std::uint64_t count = cases.size();
  return {kReal, count, [cases = std::move(cases)](std::uint64_t i) { return cases[i]; }, "plumb fuzz-run"};
}

std::vector<Source> sources_of(const Arguments& args) {
  std::vector<Source> sources{real_source(args.real)};
  const double minutes = args.first ? minutes_of_the_first : args.minutes;
  for (const Family& family : families())
    sources.push_back(
        family_source(std::string(family.name), scaled(family.per_minute, minutes), args.seed, " --method all"));
  return sources;
}

fs::path seeds_of(const Arguments& args, const Rate& target) {
  return fs::path(args.seeds) / target.what;
}

std::string engine_text(const std::vector<EngineRun>& runs) {
  std::string text;
  for (const EngineRun& run : runs)
    text +=
        fmt::format("{}{} {} inputs, {}", text.empty() ? "auto, coverage-guided, under sanitizers: " : "; ", run.target,
                    grouped(run.inputs), run.found.empty() ? "no wrong answer" : "STOPPED: " + run.found);
  return text.empty() ? text : text + "\n";
}

bool has_stopped(const std::vector<EngineRun>& runs) {
  return std::any_of(runs.begin(), runs.end(), [](const EngineRun& run) { return !run.found.empty(); });
}

/// What to do with what is there. After a first verdict there are no commands yet.
std::string next_steps(const std::vector<ShownFailure>& failures, const Arguments& args) {
  const fs::path out = args.out;
  const std::string table = fmt::format("every method, family and finding: {}\n", (out / "table.txt").string());
  if (args.first)
    return table + "These commands are there once everything is built; the verdict on more pairs follows.\n";
  std::string text = fmt::format("next\n  the page of all this: {}\n  {}", (out / "report.html").string(), table);
  if (!failures.empty())
    text += fmt::format("  what matters in a failure: {} shrink {}\n", plumb_command(),
                        shell_word((out / "failures" / failures.front().file).string()));
  return text +
         fmt::format("  your own solver, on 2 000 pairs of each family: {} campaign --family all --cases 2000 --seed 1 "
                     "--solver ./yours.so\n",
                     plumb_command());
}

/// "2 100 pairs (1 680 spheroid, 280 ellipsoid, ..)"
std::string pairs_text(const Results& results) {
  std::string families;
  for (const std::string& family : family_order(results))
    families +=
        fmt::format("{}{} {}", families.empty() ? "" : ", ", grouped(results.families.at(family).cases), family);
  return fmt::format("{} pairs ({})", grouped(results.cases()), families);
}

/// What the run ends with: 25 lines at most.
std::string verdict_text(const Results& results, const std::vector<EngineRun>& runs,
                         const std::vector<ShownFailure>& failures, const Arguments& args) {
  return fmt::format(
      "\n{}{}; right: to within rounding; error: of the normal, to the certified common normal\n{}{}{}{}{}",
      args.first ? "A first verdict: " : "", pairs_text(results), methods_in_words(results), engine_text(runs),
      in_words(failures, args.out), bottom_line(results, has_stopped(runs)), next_steps(failures, args));
}

/// Target after target; a finding of one does not keep the others from being asked.
std::vector<EngineRun> run_targets(const Arguments& args) {
  std::vector<EngineRun> runs;
  if (args.first || args.fuzzers.empty()) return runs;
  const fs::path out = args.out;
  for (const Rate& target : kTargets) {
    if (interrupted()) break;
    runs.push_back(run_engine({fs::path(args.fuzzers) / (std::string("fuzz-") + target.what), seeds_of(args, target),
                               out / "fuzzers" / target.what, out / "failures", scaled(target.per_minute, args.minutes),
                               args.seed}));
  }
  return runs;
}

/// A run of other minutes is replaced: the folder is this command's own.
void require_replaceable(const Arguments& args, const Asked& asked) {
  const auto earlier = asked_in(args.out);
  const bool is_own = earlier && earlier->cases.contains(kReal);
  require_replaceable(args.out, is_own ? *earlier : asked, false);
}

/// The campaign's files and the table.
void leave_files(const Results& results, const fs::path& out) {
  write_results(results, out);
  write_file(out / "table.txt", table_text(results) + kept_text(results, out));
}

void leave_shrunk(const std::vector<ShownFailure>& failures, const fs::path& out) {
  for (const ShownFailure& failure : failures)
    if (failure.shrunk) write_file(out / "failures" / failure.file, format_case(*failure.shrunk) + "\n");
}

int fuzz_run(const Arguments& args) {
  if (!args.fuzzers.empty())
    for (const Rate& target : kTargets) require_seeds(seeds_of(args, target));
  const std::vector<Source> sources = sources_of(args);
  const CampaignOptions options{all_solvers(), args.seed, args.threads, {}};
  const FolderLock lock = lock_out(args.out);
  if (!args.force) require_replaceable(args, asked_of(sources, options));
  prepare_folder(args.out);
  const Results results = run_campaign(sources, options);
  const std::exception_ptr failed = failure_to([&] { leave_files(results, args.out); });
  const std::vector<EngineRun> runs = failed ? std::vector<EngineRun>() : run_targets(args);
  const std::vector<ShownFailure> failures = worth_a_look(results, options.solvers);
  if (!failed) leave_shrunk(failures, args.out);
  const std::string verdict = verdict_text(results, runs, failures, args);
  print_line(verdict);
  if (failed) std::rethrow_exception(failed);
  add_to_summary(runs, args.out);
  write_file(fs::path(args.out) / "verdict.txt", verdict + "\n");
  return std::max(exit_code(results), has_stopped(runs) ? 1 : 0);
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::Arguments args;
  plumb::CommandLine app("Real pairs, random families and the coverage-guided targets, judged; one table",
                         "plumb fuzz-run");
  app.add_option("--minutes", args.minutes, "sizes the run: counts, not a clock")
      ->check(plumb::refuse_minutes)
      ->capture_default_str();
  app.add_flag("--first", args.first, "a first verdict: the real pairs and some random ones, no target");
  plumb::declare_seed(app, args.seed);
  app.add_option("--threads", args.threads, "default: one for each processor")->in_range(1, 1024);
  app.add_option("--out", args.out, "folder for summary.json, failures/ and fuzzers/")->capture_default_str();
  app.add_flag("--force", args.force, plumb::kForceHelp);
  app.add_option("--fuzzers", args.fuzzers, "folder of the programs fuzz-TARGET; without it that part is left out");
  app.add_option("--real", args.real, "cases that go through every method first")->capture_default_str();
  app.add_option("--seeds", args.seeds, "folder of the folders of inputs from which the targets start")
      ->capture_default_str();
  return plumb::run_command(app, argc, argv, [&] { return plumb::fuzz_run(args); });
}
