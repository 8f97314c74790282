#include "properties/laws/motion/scene.hpp"

#include <fmt/format.h>

namespace plumb::scene {
namespace {

using Hashes = std::map<std::string, std::uint64_t>;

void go_to(Simulation& run, std::int64_t step) {
  while (run.steps() < step && !run.is_done()) run.step();
}

void go_to_end(Simulation& run) {
  go_to(run, run.plan().steps);
}

/// What differs of what both carry; positions and velocities at least are that.
std::string find_difference(const Hashes& a, const Hashes& b) {
  std::size_t common = 0;
  for (const auto& [name, hash] : a) {
    const auto found = b.find(name);
    if (found == b.end()) continue;
    if (found->second != hash) return name;
    ++common;
  }
  return common < 2 ? "all, as it were: they have nothing in common" : "";
}

bool is_left_alone(const Scene& scene) {
  return scene.bodies.size() == 2 && scene.walls.empty() && !scene.effects.gravity && !scene.effects.drag;
}

}  // namespace

std::string find_neutral_change(const Scene& absent, const Scene& present, std::string_view effect) {
  PlanOptions options;
  options.forced.emplace(effect);
  Simulation without(absent, make_plan(absent)), with(present, make_plan(present, options));
  if (without.plan().is_on(effect)) return fmt::format("{} is on where it is to be absent", effect);
  if (!with.plan().is_on(effect)) return fmt::format("{} is off, though forced", effect);
  go_to_end(without);
  go_to_end(with);
  const std::string column = find_difference(without.hashes(), with.hashes());
  return column.empty() ? "" : fmt::format("{} forced on changes {}", effect, column);
}

std::string find_snapshot_change(const Scene& scene, std::int64_t step) {
  const Plan plan = make_plan(scene);
  Simulation whole(scene, plan), resumed(scene, plan);
  go_to(whole, step);
  const Snapshot snapshot = whole.snapshot();
  go_to_end(whole);
  if (!resumed.restore(snapshot)) return "its own snapshot does not fit";
  resumed.observe([](std::span<const SolveNote>) {});
  go_to_end(resumed);
  const std::string column = find_difference(whole.hashes(), resumed.hashes());
  if (!column.empty()) return fmt::format("resumed at step {}, {} differs", snapshot.step, column);
  const Totals a = whole.totals(), b = resumed.totals();
  const bool same_work = a.solves == b.solves && a.evaluations == b.evaluations && a.failed == b.failed;
  return same_work ? "" : fmt::format("resumed at step {}, the solver did other work", snapshot.step);
}

std::string find_force_without_opposite(const Scene& scene) {
  if (!is_left_alone(scene)) return {};
  Simulation run(scene, make_plan(scene));
  const auto force = [&](std::size_t i) { return Vec3<double>(run.world().state.force->vector(i)); };
  for (; !run.is_done(); run.step())
    if (force(0) != -force(1)) return fmt::format("at step {} the bodies' forces are not opposite", run.steps());
  return {};
}

std::string find_lost_body(const Scene& scene) {
  Simulation run(scene, make_plan(scene));
  if (run.plan().time_step * 8 > run.plan().needs.fastest) return {};
  go_to_end(run);
  const std::optional<std::size_t> lost = run.lost_body();
  return lost ? fmt::format("body {} is lost", *lost) : "";
}

}  // namespace plumb::scene
