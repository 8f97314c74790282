#include "fuzz/hunt/engine.hpp"

#include <limits>
#include <utility>

#include "corpus/command/interrupt.hpp"
#include "fuzz/main_job/engine_run.hpp"

namespace plumb::hunting {
namespace {

namespace fs = std::filesystem;

/// libFuzzer's counts are int.
constexpr std::uint64_t kMostRuns = std::numeric_limits<int>::max();

/// The case that the target kept; none where it was something else that ended the engine.
std::optional<Case> case_in(const fs::path& folder) {
  if (!fs::is_directory(folder)) return std::nullopt;
  for (const fs::path& path : find_case_files({folder.string()})) return CaseReader(path.string()).next();
  return std::nullopt;
}

}  // namespace

Hunted hunt_by_engine(const Solver& solver, const HuntOptions& options, const Engine& engine,
                      std::vector<std::string> environment) {
  require_seeds(engine.seeds);
  environment.push_back("PLUMB_FUZZ_ACCURACY=" + accuracy_text(options.accuracy));
  const fs::path failures = engine.folder / "failures";
  const double seconds = options.inputs ? 0 : options.time.count();
  const EngineRun run = run_engine({engine.program, engine.seeds, engine.folder, failures,
                                    options.inputs.value_or(kMostRuns), options.seed, std::move(environment), seconds});
  Hunted out;
  out.inputs = run.inputs;
  out.found = case_in(failures);
  if (!out.found && !run.found.empty() && !interrupted())
    throw InputFailure(engine.program.string(), 0, "--engine", run.found);
  if (out.found) {
    Judge judge(out.found->pair);
    out.judged = solve_and_judge(judge, out.found->pair, solver, options.accuracy);
  }
  return out;
}

}  // namespace plumb::hunting
