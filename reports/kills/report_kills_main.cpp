// plumb report-kills: the harness tested. Which engine kills which seeded bug (fuzz/bugs), in how many runs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <thread>

#include "corpus/certificate/reference_store.hpp"
#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "properties/generators/draft.hpp"
#include "properties/generators/families.hpp"
#include "properties/generators/paths.hpp"
#include "properties/generators/shapes.hpp"
#include "reports/kills/table.hpp"

namespace plumb::reports {
namespace {

struct Options {
  std::string library = PLUMB_SOURCE_DIR "/build/bugs/bin/seeded_bugs.so";
  std::string bugs, engines = "corpus,motions,work,modes,families,hard,shapes";
  std::size_t cases = 1000, seeds = 6;
  std::uint64_t seed = 1;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  std::string cache, out;
  std::string fuzzers = PLUMB_SOURCE_DIR "/build/fuzz-fast/bin";
  std::string fuzzed_library = PLUMB_SOURCE_DIR "/build/bugs-fuzz/bin/seeded_bugs.so";
  std::uint64_t inputs = 2000;
  bool list = false;
};

void declare(CommandLine& app, Options& options) {
  app.add_option("--library", options.library, "what `cmake --build --preset bugs` built")->capture_default_str();
  app.add_option("--bugs", options.bugs, "NAME,.. in the place of all");
  app.add_option("--engines", options.engines, "which of them, in the order of the table's columns")
      ->capture_default_str();
  app.add_option("--cases", options.cases, "random cases of each seed, by each engine that draws")
      ->capture_default_str()
      ->check(refuse_count);
  app.add_option("--seeds", options.seeds, "how many; of 6 the least and the greatest hold the median in 96.9 %")
      ->capture_default_str()
      ->check(refuse_count);
  declare_seed(app, options.seed, "the first of them");
  app.add_option(
         "--inputs", options.inputs,
         "of each seed, by each fuzz-TARGET or plain-TARGET among the engines; NAME:code goes without the thermometers")
      ->capture_default_str()
      ->check(refuse_count);
  app.add_option("--fuzzers", options.fuzzers, "folder of the programs fuzz-TARGET")->capture_default_str();
  app.add_option("--fuzzed-library", options.fuzzed_library, "what `cmake --build --preset bugs-fuzz` built")
      ->capture_default_str();
  app.add_option("--threads", options.threads, "changes nothing but the time")->in_range(1, 1024);
  app.add_option("--cache", options.cache, cache_help);
  app.add_option("--out", options.out, "file for JSON lines: the engines, the bugs");
  app.add_flag("--list", options.list, "list the bugs");
}

const std::filesystem::path kCases = std::filesystem::path(PLUMB_SOURCE_DIR) / "corpus/cases";

/// Of superellipsoids.
std::vector<Case> read_cases(const std::filesystem::path& file) {
  std::vector<Case> out;
  CaseReader reader(file.string(), CaseShapes::every);
  while (std::optional<Case> c = reader.next())
    if (!c->convex) out.push_back(std::move(*c));
  return out;
}

bool is_motion(const std::filesystem::path& file) {
  return file.parent_path().filename() == "paths";
}

/// Each file's; motions are another engine's.
std::vector<WorkSet> kept_cases() {
  std::vector<WorkSet> out;
  for (const auto& file : find_case_files({kCases.string()})) {
    if (is_motion(file)) continue;
    WorkSet& set = out.emplace_back(WorkSet{file.stem().string(), {}});
    for (const Case& c : read_cases(file)) set.pairs.push_back(c.pair);
    if (set.pairs.empty()) out.pop_back();
  }
  return out;
}

EngineHunts hunt_corpus(const Quarry& quarry, const Options& /*options*/) {
  std::vector<Case> cases;
  for (const WorkSet& set : kept_cases())
    for (const Pair& pair : set.pairs) cases.push_back({set.name, pair, {}, {}, {}});
  return {"corpus", "cases", {hunt_cases(quarry, cases.size(), [&](std::size_t i) { return cases[i]; })}};
}

std::vector<WorkSet> motions() {
  std::vector<WorkSet> out;
  for (const auto& file : find_case_files({(kCases / "hard/paths").string()})) {
    WorkSet& motion = out.emplace_back(WorkSet{file.stem().string(), {}, true});
    for (const Case& step : read_cases(file)) motion.pairs.push_back(step.pair);
  }
  return out;
}

EngineHunts hunt_along_motions(const Quarry& quarry, const Options& /*options*/) {
  std::vector<Track> tracks;
  for (WorkSet& motion : motions()) tracks.push_back(std::move(motion.pairs));
  return {"motions", "steps", {hunt_motions(quarry, tracks)}};
}

/// Axes tilted by any angle, exponents about the axis alone: what the proofs of the search over directions are asked for most.
Pair deep_bodies_of_revolution(std::uint64_t seed, std::uint64_t index) {
  Stream stream("deep bodies of revolution", seed, index);
  const auto shape = [&] {
    const double across = stream.uniform(0.3, 1), along = stream.uniform(0.3, 1);
    return Superellipsoid<double>{{across, across, along}, stream.log_uniform(1.3, 8), 2};
  };
  const auto rotation = random_rotation(stream);
  const auto tilted = product(rotation, turn(random_direction(stream), stream.log_uniform(1e-4, 1)));
  const Vec3<double> apart = random_direction(stream) * stream.uniform(0.05, 0.3);
  return {{shape(), Vec3<double>::Zero(), rotation}, {shape(), apart, tilted}};
}

EngineHunts hunt_by_work(const Quarry& quarry, const Options& options) {
  constexpr std::size_t pairs_of_each = 300;
  std::vector<WorkSet> sets;
  for (const Family& family : families()) {
    WorkSet& set = sets.emplace_back(WorkSet{std::string(family.name), {}});
    for (std::size_t i = 0; i < pairs_of_each; ++i) set.pairs.push_back(generate(family.name, options.seed, i).pair);
  }
  for (const std::string_view generator : hard_generators()) {
    WorkSet& set = sets.emplace_back(WorkSet{"hard/" + std::string(generator), {}});
    for (std::size_t i = 0; i < pairs_of_each; ++i) set.pairs.push_back(generate_hard(generator, options.seed, i).pair);
  }
  WorkSet& deep = sets.emplace_back(WorkSet{"bodies of revolution deep in each other", {}});
  for (std::size_t i = 0; i < pairs_of_each; ++i) deep.pairs.push_back(deep_bodies_of_revolution(options.seed, i));
  std::ranges::move(kept_cases(), std::back_inserter(sets));
  std::ranges::move(motions(), std::back_inserter(sets));
  return {"work", "solves", {hunt_work(quarry, sets)}};
}

EngineHunts hunt_in_modes_of_hosts(const Quarry& quarry, const Options& options) {
  constexpr std::size_t pairs_of_each = 20;
  std::vector<Pair> pairs;
  for (const Family& family : families())
    for (std::size_t i = 0; i < pairs_of_each; ++i) pairs.push_back(generate(family.name, options.seed, i).pair);
  return {"modes", "solves", {hunt_in_modes(quarry, pairs)}};
}

/// Cases of the families in turn.
EngineHunts hunt_drawn(const Quarry& quarry, const Options& options, const char* name,
                       const std::vector<std::string_view>& drawn) {
  EngineHunts out{name, "cases", {}};
  for (std::uint64_t seed = options.seed; seed < options.seed + options.seeds && !interrupted(); ++seed)
    out.hunts.push_back(hunt_cases(quarry, options.cases, [&](std::size_t i) {
      return generate(drawn[i % drawn.size()], seed, i / drawn.size());
    }));
  return out;
}

std::vector<std::string_view> names_of_families(bool of_generators) {
  std::vector<std::string_view> names;
  for (const Family& family : families())
    if ((family.generators != nullptr) == of_generators) names.push_back(family.name);
  return names;
}

EngineHunts hunt_families(const Quarry& quarry, const Options& options) {
  return hunt_drawn(quarry, options, "families", names_of_families(false));
}

EngineHunts hunt_hard(const Quarry& quarry, const Options& options) {
  return hunt_drawn(quarry, options, "hard", names_of_families(true));
}

/// Each two shapes in turn. A pair takes a tenth of a case's time.
EngineHunts hunt_each_two_shapes(const Quarry& quarry, const Options& options) {
  constexpr std::size_t pairs_a_case = 10;
  EngineHunts out{"shapes", "pairs", {}};
  for (std::uint64_t seed = options.seed; seed < options.seed + options.seeds && !interrupted(); ++seed)
    out.hunts.push_back(hunt_shapes(quarry, pairs_a_case * options.cases, [&](std::size_t i) {
      Stream stream("shapes", seed, i);
      return draw_shape_pair(shape_kinds(i % shape_pair_count), stream);
    }));
  return out;
}

/// "fuzz-contact", "plain-contact:code": the program, and whether it sees code alone; its seeds are its target's.
EngineHunts hunt_with_fuzzer(const std::string& name, const Quarry& quarry, const Options& options) {
  const std::filesystem::path source = PLUMB_SOURCE_DIR;
  const std::string program = name.substr(0, name.find(':')), target = program.substr(program.find('-') + 1);
  for (const auto& file :
       {std::filesystem::path(options.fuzzers) / program, std::filesystem::path(options.fuzzed_library)})
    if (!std::filesystem::exists(file))
      throw InputFailure("--engines", 0, name, file.string() + " is not there: build fuzz-fast and bugs-fuzz");
  EngineHunts out{name, "inputs", {}};
  for (std::uint64_t seed = options.seed; seed < options.seed + options.seeds && !interrupted(); ++seed)
    out.hunts.push_back(hunt_with({std::filesystem::path(options.fuzzers) / program, options.fuzzed_library,
                                   source / "fuzz/seeds" / target, source / "build/kills" / name, options.inputs, seed,
                                   name.ends_with(":code")},
                                  quarry));
  return out;
}

struct Engine {
  std::string name;
  std::function<EngineHunts(const Quarry&, const Options&)> hunt;
  bool is_of_shapes = false;
};

bool is_of_shapes(const SeededBug& bug) {
  return bug.file.starts_with("method/convex");
}

/// Of the bugs that an engine's cases can meet; the others are not killed by it.
EngineHunts hunt_met(const Engine& engine, const Quarry& quarry, const Options& options) {
  Quarry met{quarry.seeded, {}, quarry.threads, quarry.source};
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < quarry.bugs.size(); ++i)
    if (is_of_shapes(quarry.seeded.bugs[quarry.bugs[i] - 1]) == engine.is_of_shapes) {
      met.bugs.push_back(quarry.bugs[i]);
      places.push_back(i);
    }
  EngineHunts out = engine.hunt(met, options);
  for (Hunt& hunt : out.hunts) {
    std::vector<Kill> all(quarry.bugs.size());
    for (std::size_t k = 0; k < places.size(); ++k) all[places[k]] = std::move(hunt.kills[k]);
    hunt.kills = std::move(all);
  }
  return out;
}

/// nullopt where there is none of that name; any fuzz-TARGET is one, and plain-TARGET, which is without its mutator.
std::optional<Engine> find_engine(const std::string& name) {
  if (name.starts_with("fuzz-") || name.starts_with("plain-"))
    return Engine{name, [name](const Quarry& q, const Options& o) { return hunt_with_fuzzer(name, q, o); }};
  const std::array<Engine, 7> engines{{{"corpus", hunt_corpus},
                                       {"motions", hunt_along_motions},
                                       {"work", hunt_by_work},
                                       {"modes", hunt_in_modes_of_hosts},
                                       {"families", hunt_families},
                                       {"hard", hunt_hard},
                                       {"shapes", hunt_each_two_shapes, true}}};
  const auto found = std::ranges::find(engines, name, &Engine::name);
  return found == engines.end() ? std::nullopt : std::optional(*found);
}

/// Of a list with commas, in its order; throws InputFailure for a name that `find` does not know.
template <class Find>
void each_name(const std::string& option, const std::string& names, const Find& find) {
  std::istringstream list(names);
  for (std::string name; std::getline(list, name, ',');)
    if (!find(name)) throw InputFailure(option, 0, name, "there is none of that name");
}

std::vector<std::size_t> bugs_asked(const SeededSolver& seeded, const std::string& names) {
  std::vector<std::size_t> out;
  if (names.empty())
    for (std::size_t i = 1; i <= seeded.bugs.size(); ++i) out.push_back(i);
  each_name("--bugs", names, [&](const std::string& name) {
    const auto found = std::ranges::find(seeded.bugs, name, &SeededBug::name);
    if (found == seeded.bugs.end()) return false;
    out.push_back(static_cast<std::size_t>(found - seeded.bugs.begin()) + 1);
    return true;
  });
  return out;
}

std::vector<Engine> engines_asked(const std::string& names) {
  std::vector<Engine> out;
  each_name("--engines", names, [&](const std::string& name) {
    const std::optional<Engine> found = find_engine(name);
    if (found) out.push_back(*found);
    return found.has_value();
  });
  if (out.empty()) throw InputFailure("--engines", 0, "", "names none");
  return out;
}

int list_bugs(const SeededSolver& seeded) {
  for (const SeededBug& bug : seeded.bugs) print_line(fmt::format("{:<36}{:<20}{}", bug.name, bug.kind, bug.seen));
  return exit_done;
}

int report(const Options& options) {
  const SeededSolver seeded = load_seeded(options.library);
  if (options.list) return list_bugs(seeded);
  const std::vector<Engine> engines = engines_asked(options.engines);
  const Quarry quarry{seeded, bugs_asked(seeded, options.bugs), options.threads,
                      references_of(open_store(options.cache))};
  Bugs bugs;
  for (const std::size_t bug : quarry.bugs) bugs.push_back(seeded.bugs[bug - 1]);
  std::vector<EngineHunts> done;
  for (const Engine& engine : engines) {
    EngineHunts hunts = hunt_met(engine, quarry, options);
    if (interrupted()) break;  // who was not killed may have been later
    done.push_back(std::move(hunts));
  }
  if (done.empty()) return exit_interrupted;
  print_line(kill_table(bugs, done));
  if (!options.out.empty()) write_file(options.out, kill_lines(bugs, done));
  if (interrupted()) return exit_interrupted;
  const std::vector<std::string> wrong = complaints(bugs, done);
  for (const std::string& line : wrong) print_line(line);
  return wrong.empty() ? exit_done : exit_finding;
}

int run(const Options& options) {
  try {
    return report(options);
  } catch (const ControlDiffers& error) {
    print_line(error.what());
    return exit_finding;
  }
}

}  // namespace
}  // namespace plumb::reports

int main(int argc, char** argv) {
  plumb::reports::Options options;
  plumb::CommandLine app("Which engine kills which seeded bug of the solver, in how many runs.", "plumb report-kills");
  plumb::reports::declare(app, options);
  return plumb::run_command(app, argc, argv, [&] { return plumb::reports::run(options); });
}
