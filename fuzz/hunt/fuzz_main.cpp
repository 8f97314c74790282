// plumb fuzz: guided fuzzing of a solver until a finding, which is shrunk and explained.
#include <fmt/format.h>

#include <filesystem>

#include "corpus/command/command.hpp"

#include "fuzz/campaign/arguments.hpp"
#include "fuzz/campaign/out_folder.hpp"
#include "fuzz/hunt/engine.hpp"
#include "fuzz/hunt/told.hpp"
#include "fuzz/results/bucket.hpp"
#include "fuzz/results/failure_store.hpp"
#include "fuzz/results/ranking.hpp"
#include "properties/laws/accuracy_option.hpp"

namespace plumb::hunting {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  ForeignOption foreign;
  std::string method, accuracy = "rounding", kinds = "wrong", out = "plumb-fuzz";
  std::string engine, seeds;
  double minutes = 5;
  std::uint64_t seed = 1, inputs = 0;
};

void declare(CommandLine& app, Arguments& args) {
  auto* method = app.add_option("--method", args.method, "one of plumb's own in the place of a foreign solver");
  declare_solver(app, args.foreign, "the solver: a shared library (solver/plumb_solver.h)", method);
  app.add_option("--minutes", args.minutes, "how long to look where nothing is found")
      ->check(refuse_minutes)
      ->capture_default_str();
  app.add_option("--inputs", args.inputs, "so many inputs in the place of minutes: the same find the same")
      ->check(refuse_count);
  declare_seed(app, args.seed, "same seed and inputs, same finding");
  declare_accuracy(app, args.accuracy);
  app.add_option("--kinds", args.kinds, "findings that end it: wrong, all, or some, comma-separated")
      ->capture_default_str();
  app.add_option("--out", args.out, "folder whose failures/ gets the case")->capture_default_str();
  auto* engine = app.add_option("--engine", args.engine,
                                "libFuzzer's program of a target (fuzz-contact, fuzz-pair), "
                                "which looks in the place of plumb's own loop");
  app.add_option("--seeds", args.seeds, "inputs from which that starts; default: those of its target in the sources")
      ->needs(engine);
}

AbortRule kinds_of(const std::string& words) {
  try {
    return AbortRule(words);
  } catch (const InputFailure& e) {
    throw InputFailure("--kinds", 0, "", e.what());
  }
}

HuntOptions options_of(const Arguments& args) {
  HuntOptions out;
  out.seed = args.seed;
  if (args.inputs > 0) out.inputs = args.inputs;
  out.time = std::chrono::duration<double, std::ratio<60>>(args.minutes);
  out.kinds = kinds_of(args.kinds);
  out.accuracy = parse_accuracy(args.accuracy);
  return out;
}

std::string bucket_of(const Case& c, const std::string& finding, const std::string& solver) {
  return bucket(finding, solver, c.pair, Judge(c.pair).reference());
}

/// The case as it was found, and the shrunk one beside it, whose path comes back.
fs::path keep(const Case& fuzzed, const Hunted& hunted, const Explained& explained, const Solver& solver,
              const fs::path& out) {
  const Finding& finding = hunted.judged.judgement.finding;
  const std::string file = bucket_of(fuzzed, std::string(name(finding.kind)), solver.name);
  const Case found = failing_case(fuzzed, solver.name, finding, explained.shrunk.accuracy, "plumb fuzz");
  const fs::path folder = out / "failures", shrunk = folder / (file + std::string(kShrunk));
  fs::create_directories(folder);
  write_file(folder / (file + "--fuzzed.json"), format_case(found) + "\n");
  write_file(shrunk, format_case(kept_shrunk(found, explained, solver.name)) + "\n");
  return shrunk;
}

/// One that hangs is not asked any more after a while: its case stays as it was found.
Explained explained_as_far(const Pair& pair, const Hunted& hunted, const Solver& solver, const Accuracy& accuracy) {
  try {
    return shrink_and_explain(pair, solver, accuracy);
  } catch (const NoAnswer&) {
    Explained out;
    out.shrunk = {accuracy, hunted.judged, {pair, {}, {}}, pair, hunted.judged, {}, true};
    out.sentence = sentence(out.shrunk, {}, solver.name);
    return out;
  }
}

int leave(const Case& fuzzed, const Hunted& hunted, const Solver& solver, const Arguments& args) {
  const Explained explained = explained_as_far(fuzzed.pair, hunted, solver, parse_accuracy(args.accuracy));
  const fs::path kept = keep(fuzzed, hunted, explained, solver, args.out);
  const std::string options = solver.option + accuracy_option(args.accuracy);
  print_line(explained.sentence + "\n" + expected_and_got(explained, solver));
  print_line(fmt::format("found after {} inputs, {} pairs answered, {} judged\nkept: {}\nreplay: {}", hunted.inputs,
                         hunted.answered, hunted.judged_pairs, kept.string(), replay_command(kept, options)));
  return exit_finding;
}

/// "fuzz-contact" -> the seeds of contact.
fs::path seeds_of(const Arguments& args) {
  if (!args.seeds.empty()) return args.seeds;
  const std::string program = fs::path(args.engine).filename().string();
  return fs::path(PLUMB_SOURCE_DIR "/fuzz/seeds") / program.substr(program.find('-') + 1);
}

/// For target_settings.hpp.
std::string who_is_asked(const Arguments& args) {
  if (!args.foreign.commands.empty()) return "PLUMB_FUZZ_SOLVER_COMMAND=" + args.foreign.commands.front();
  if (args.foreign.libraries.empty()) return "PLUMB_FUZZ_METHOD=" + args.method;
  return "PLUMB_FUZZ_SOLVER=" + fs::absolute(args.foreign.libraries.front()).string();
}

Hunted hunt_as_asked(const Solver& solver, const Arguments& args) {
  const HuntOptions options = options_of(args);
  if (args.engine.empty()) return hunt(solver, options);
  return hunt_by_engine(solver, options, {args.engine, seeds_of(args), fs::path(args.out) / "engine"},
                        {who_is_asked(args), "PLUMB_FUZZ_ABORT=" + args.kinds});
}

int fuzz(const Arguments& args) {
  (void)options_of(args);  // refused before a solver is started
  const std::optional<Solver> solver = solver_instead(args.foreign, args.method, "fuzz");
  if (!solver) throw InputFailure("plumb fuzz", 0, "--solver", "is missing: which solver?");
  const FolderLock lock = lock_out(args.out);
  const Hunted hunted = hunt_as_asked(*solver, args);
  if (hunted.found) return leave(*hunted.found, hunted, *solver, args);
  print_line(nothing_text(hunted, solver->name));
  return exit_done;
}

}  // namespace
}  // namespace plumb::hunting

int main(int argc, char** argv) {
  plumb::hunting::Arguments args;
  plumb::CommandLine app(
      "Inputs made from those that came nearest to a wrong answer, until one is found: 1, shrunk and "
      "explained; 0 where nothing is.",
      "plumb fuzz");
  plumb::hunting::declare(app, args);
  return plumb::run_command(app, argc, argv, [&] { return plumb::hunting::fuzz(args); });
}
