#include "corpus/command/interrupt.hpp"
#include "corpus/command/text_table.hpp"
#include "reports/scenes/tables.hpp"
#include "reports/scenes/timing.hpp"
#include "solver/scene/named.hpp"

namespace plumb::reports {
namespace {

using scene::Scene;
using scene::Simulation;

constexpr int crowded = 64;
/// Part of the pile's duration after which it is dense.
constexpr double dense_at = 0.5;
constexpr std::int64_t cost_steps = 400;

/// The pile with every effect, each weak enough to leave it the pile that it is.
Scene everything() {
  Scene scene = scene::find_named_scene("pile")->make(crowded);
  scene.run.outputs = {};
  scene::Effects& effects = scene.effects;
  effects.damping = scene::Damping{0.5};
  effects.friction = scene::Friction{.coefficient = 0.4};
  effects.rolling = scene::Rolling{.coefficient = 1e-3};
  effects.twisting = scene::Twisting{.coefficient = 1e-3};
  effects.cohesion = scene::Cohesion{.pull_off = 1e-9};
  effects.drag = scene::Drag{.viscosity = 1e-9};
  effects.conduction = scene::Conduction{.conductivity = 1};
  effects.moving_walls = scene::MovingWalls{{{.wall = 0, .velocity = {0, 0, 1e-9}}}};
  for (scene::SceneBody& b : scene.bodies) b.temperature = 300;
  for (scene::Wall& wall : scene.walls) wall.temperature = 310;
  return scene;
}

/// Of a snapshot, what a run that keeps less has a place for.
scene::Snapshot fitted(const scene::Snapshot& from, const Simulation& to) {
  scene::Snapshot out = from;
  const auto mine = to.snapshot().columns;
  std::erase_if(out.columns, [&](const auto& column) {
    return std::ranges::none_of(mine, [&](const auto& kept) { return kept.first == column.first; });
  });
  return out;
}

/// Seconds of the same steps from the same state, the least of several.
double seconds_from(const scene::Snapshot& start, const Scene& scene, int repeat) {
  double least = std::numeric_limits<double>::infinity();
  Simulation run(scene, scene::make_plan(scene));
  for (int k = 0; k < repeat; ++k) {
    if (!run.restore(fitted(start, run))) return std::numeric_limits<double>::quiet_NaN();
    least = std::min(least, time_steps(run, cost_steps));
  }
  return least;
}

}  // namespace

ReportTable effect_costs(const SceneOptions& options) {
  ReportTable table;
  const TextTable columns(
      {{"effect", "<14"}, {"step with / without", ">22.3f"}, {"bytes, body", ">14"}, {"contact", ">12"}});
  table.lines.push_back(columns.head());
  const Scene all = everything();
  Simulation run(all, scene::make_plan(all));
  const auto memory = scene::memory_of(all, run.plan());
  run_until(run, dense_at);
  const scene::Snapshot dense = run.snapshot();
  const double with = seconds_from(dense, all, options.repeat);
  scene::each_effect(all.effects, [&](const auto& effect) {
    using Parameters = typename std::remove_cvref_t<decltype(effect)>::value_type;
    // Others stand on the one, and without the other the pile flies apart.
    const bool is_needed = Parameters::name == scene::Linear::name || Parameters::name == scene::Gravity::name;
    if (!effect || is_needed || interrupted()) return;
    Scene less = all;
    scene::each_effect(less.effects, [](auto& other) {
      if (std::is_same_v<typename std::remove_cvref_t<decltype(other)>::value_type, Parameters>) other.reset();
    });
    const double ratio = with / seconds_from(dense, less, options.repeat);
    const std::string name(Parameters::name);
    const auto found = memory.find(name);
    const scene::Memory bytes = found == memory.end() ? scene::Memory{} : found->second;
    table.add(columns.row(name, ratio, bytes.body, bytes.pair), {{"kind", "effect"},
                                                                 {"effect", name},
                                                                 {"time_ratio", ratio},
                                                                 {"bytes_per_body", bytes.body},
                                                                 {"bytes_per_contact", bytes.pair}});
  });
  return table;
}

}  // namespace plumb::reports
