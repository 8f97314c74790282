#include "solver/scene/effect/conduction.hpp"

#include <algorithm>
#include <string>

#include "solver/scene/body/world.hpp"
#include "solver/scene/effect.hpp"
#include "solver/scene/facts.hpp"

namespace plumb::scene {
namespace {

/// Heat that each contact carries in a step, from the warmer body to the colder.
void conduct(const Conduction& conduction, Column& temperature, Column& heat, World& world) {
  const Contacts& contacts = world.contacts;
  heat.fill(0);
  for (const std::uint32_t c : contacts.pressing) {
    const auto [i, j] = contacts.pairs[c];
    const auto curvature = contacts.curvature->entry(c);
    const double overlap = (*contacts.overlap)[c];
    const double patch = std::sqrt(overlap / (2 * std::sqrt(curvature[0] * curvature[1])));
    const double flow = 2 * conduction.conductivity * patch * (temperature[i] - temperature[j]) * world.time_step;
    heat[i] -= flow;
    heat[j] += flow;
  }
  for (const std::uint32_t i : world.bodies.movable)
    temperature[i] += heat[i] / (world.bodies.mass[i] * conduction.heat_capacity);
}

void require_temperature(const std::optional<double>& temperature, const char* list, std::size_t index) {
  if (temperature && std::isfinite(*temperature)) return;
  throw SceneError(list + ("[" + std::to_string(index)) + "].temperature",
                   "conduction needs a temperature of each body and wall");
}

}  // namespace

Role role(const Conduction& conduction, const Scene& scene) {
  Role out;
  for (std::size_t i = 0; i < scene.bodies.size() && conduction.conductivity > 0; ++i)
    require_temperature(scene.bodies[i].temperature, "bodies", i);
  for (std::size_t i = 0; i < scene.walls.size() && conduction.conductivity > 0; ++i)
    require_temperature(scene.walls[i].temperature, "walls", i);
  if (conduction.conductivity == 0) out.off = "the conductivity is 0";
  out.needs = {.contacts = true, .curvature = true, .curvature_each_step = true};
  // A body equalises no faster than through patches as large as itself; contacts are smaller, and several share this.
  const double capacity = 2 * least_contact_mass(scene) * conduction.heat_capacity;
  out.needs.fastest = capacity / (2 * conduction.conductivity * longest_axis(scene));
  return out;
}

void install(const Conduction& conduction, World& world) {
  Column& temperature = world.columns.add("temperature", Conduction::name, {ColumnKind::body, 1, true});
  Column& heat = world.columns.add("heat", Conduction::name, {ColumnKind::body, 1});
  world.starts.push_back([&temperature](const Scene& scene) {
    std::size_t i = 0;
    for (const SceneBody& b : scene.bodies) temperature[i++] = b.temperature.value_or(0);
    for (const Wall& wall : scene.walls) temperature[i++] = wall.temperature.value_or(0);
  });
  world.body_passes.push_back(
      {Conduction::name, [conduction, &temperature, &heat, &world] { conduct(conduction, temperature, heat, world); }});
}

}  // namespace plumb::scene
