// plumb scene: a scene's plan, and its run.
#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "corpus/case/case.hpp"
#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/json/number_text.hpp"
#include "corpus/scene/scene_file.hpp"
#include "corpus/scene/scene_report.hpp"
#include "corpus/scene/scene_run.hpp"
#include "corpus/scene/scene_view.hpp"

namespace plumb::scene {
namespace {

struct Arguments {
  std::string scene;
  std::string out;
  std::vector<std::string> forced;
  std::optional<double> accuracy;
  RunOptions run;
  bool plan = false;
  bool json = false;
};

std::string refuse_accuracy(const std::string& text) {
  const auto accuracy = number_from<double>(text);
  return accuracy && *accuracy > 0 && *accuracy < 1 ? "" : "must be a number between 0 and 1";
}

std::string refuse_empty(const std::string& text) {
  return text.empty() ? "names no folder" : "";
}

std::vector<std::string> effect_names() {
  std::vector<std::string> out;
  for (const Effect& effect : effects()) out.emplace_back(effect.name);
  return out;
}

void declare(CommandLine& app, Arguments& arguments) {
  app.add_option("SCENE", arguments.scene, "scene file, or - for standard input")->required();
  app.add_flag("--plan", arguments.plan, "which effects run, why, what each costs; nothing is simulated");
  auto* out = app.add_option("--out", arguments.out, "folder for what the scene writes, checkpoints and run.json");
  out->check(refuse_empty);
  app.add_flag("--resume", arguments.run.resume, "go on with the run in the folder")->needs(out);
  app.add_option("--threads", arguments.run.threads, "for the solver; as many as the scene can use")->in_range(1, 1024);
  app.add_flag("--record", arguments.run.record, "keep hard contacts as cases in the folder")->needs(out);
  app.add_option("--force", arguments.forced, "an effect to be on even where it changes nothing; for tests")
      ->is_one_of("effect", effect_names());
  app.add_option("--accuracy", arguments.accuracy, "instead of the scene's own")->check(refuse_accuracy);
  app.add_option("--checkpoint", arguments.run.checkpoint, "steps between two checkpoints")->check(refuse_count);
  app.add_flag("--json", arguments.json, "one JSON object instead of a table");
}

void print(const std::string& text) {
  print_line(text.ends_with('\n') ? text.substr(0, text.size() - 1) : text);
}

std::string energies_text(const Json& energies) {
  std::string out;
  for (const auto& [owner, energy] : energies.items()) out += fmt::format("  {} {:.9g}", owner, energy.get<double>());
  return out;
}

std::string summary(const SceneRun& run) {
  const Simulation& simulation = run.simulation();
  const Totals totals = simulation.totals();
  const Json json = run.json();
  std::string out =
      fmt::format("{} steps, time {:.9g}; {} solves, {} evaluations, {} failed ({} when warm); {:.3g} s\n",
                  simulation.steps(), simulation.time(), totals.solves, totals.evaluations, totals.failed,
                  totals.failed_warm, json["timing"]["seconds"].get<double>());
  if (simulation.plan().analysis == Analysis::motion) {
    out += "energy at the start " + energies_text(json["energy"]["first"]) + "\n";
    out += "energy at the end   " + energies_text(json["energy"]["last"]) + "\n";
  }
  return out + "hash " + hash_text(simulation.hash());
}

void print_plan(const Scene& scene, const Plan& plan, bool as_json) {
  print(as_json ? write_json(plan_json(scene, plan, {})) : plan_table(scene, plan, {}));
}

Json static_json(const Simulation& run) {
  return run.plan().analysis == Analysis::touching ? touching_json(run) : contacts_json(run);
}

void print_run(const Scene& scene, const SceneRun& run, bool as_json) {
  const Simulation& simulation = run.simulation();
  const bool is_static = simulation.plan().analysis != Analysis::motion;
  if (as_json) {
    Json json = run.json();
    if (is_static) json["found"] = static_json(simulation);
    print(write_json(json));
    return;
  }
  print(plan_table(scene, simulation.plan(), run.seconds()));
  if (is_static) print(contacts_table(simulation));
  print(summary(run));
}

/// Refuses frames that the disk cannot hold.
void require_room(const Scene& scene, const Plan& plan, std::filesystem::path folder, const std::string& file) {
  while (!exists(folder)) folder = absolute(folder).parent_path();
  const double bytes = expected_bytes(scene, plan), room = static_cast<double>(space(folder).available);
  if (bytes <= room) return;
  throw InputFailure(file, 0, "run.outputs.every",
                     fmt::format("asks for {} frames, {}; {} has room for {}", frames_of(plan), size_text(bytes),
                                 folder.string(), size_text(room)));
}

int run_scene(const Scene& scene, const Plan& plan, const Arguments& arguments) {
  SceneRun run(scene, plan, arguments.run);
  run.go();
  const Simulation& simulation = run.simulation();
  if (const auto lost = run.lost_body()) {
    fmt::print(stderr,
               "{}: run.time_step: body {} is at no finite place after step {}: {:.3g} is too long for the forces\n",
               arguments.scene, *lost, simulation.steps(), plan.time_step);
    return exit_finding;
  }
  if (!simulation.is_done()) {
    const char* hint = arguments.out.empty() ? "" : "; --resume goes on from here";
    fmt::print(stderr, "interrupted at step {} of {}{}\n", simulation.steps(), plan.steps, hint);
    return exit_interrupted;
  }
  print_run(scene, run, arguments.json);
  return simulation.totals().failed > 0 ? exit_finding : exit_done;
}

int scene_command(Arguments& arguments) {
  SceneFile file = read_scene(arguments.scene);
  if (arguments.accuracy) file.scene.run.accuracy = *arguments.accuracy;
  const PlanOptions options{{arguments.forced.begin(), arguments.forced.end()}};
  const std::string name = arguments.scene == "-" ? "standard input" : arguments.scene;
  const Plan plan = plan_scene(file.scene, options, name);
  arguments.run.out = arguments.out;
  if (!arguments.plan && !arguments.out.empty() && !arguments.run.resume)
    require_room(file.scene, plan, arguments.out, name);
  if (!arguments.plan) return run_scene(file.scene, plan, arguments);
  print_plan(file.scene, plan, arguments.json);
  return exit_done;
}

}  // namespace
}  // namespace plumb::scene

int main(int argc, char** argv) {
  plumb::scene::Arguments arguments;
  plumb::CommandLine app("Simulate the effects that a scene calls for, and nothing else.", "plumb scene");
  plumb::scene::declare(app, arguments);
  return plumb::run_command(app, argc, argv, [&] { return plumb::scene::scene_command(arguments); });
}
