#include "solver/scene/effect/linear.hpp"

#include <numbers>

#include "solver/scene/effect.hpp"
#include "solver/scene/facts.hpp"
#include "solver/scene/world.hpp"

namespace plumb::scene {
namespace {

void press_linear(const Linear& linear, Contacts& contacts) {
  for (const std::uint32_t c : contacts.touching) {
    (*contacts.normal_force)[c] = linear.stiffness * std::max(0.0, (*contacts.overlap)[c]);
    (*contacts.stiffness)[c] = linear.stiffness;
  }
}

}  // namespace

Role role(const Linear& linear, const Scene& scene) {
  Role out;
  if (scene.effects.hertz) throw SceneError("effects.linear", "there is one elastic law: linear or hertz, not both");
  if (linear.stiffness == 0) out.off = "the stiffness is 0";
  out.needs = {.contacts = true, .normal_force = true};
  out.needs.fastest = std::numbers::pi * std::sqrt(least_contact_mass(scene) / linear.stiffness);
  return out;
}

void install(const Linear& linear, World& world) {
  world.contact_passes.push_back({Linear::name, [linear, &world] { press_linear(linear, world.contacts); }});
  world.energies.push_back({Linear::name, [linear, &world] {
                              double sum = 0;
                              for (const std::uint32_t c : world.contacts.touching) {
                                const double overlap = std::max(0.0, (*world.contacts.overlap)[c]);
                                sum += linear.stiffness * overlap * overlap / 2;
                              }
                              return sum;
                            }});
}

}  // namespace plumb::scene
