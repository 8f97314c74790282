#include "solver/scene/effect/normal/linear.hpp"

#include "solver/scene/body/world.hpp"
#include "solver/scene/effect.hpp"
#include "solver/scene/facts.hpp"
#include "solver/scene/material/by_pair.hpp"

namespace plumb::scene {
namespace {

void press_linear(const ByPair<Linear>& laws, const ContactRange& range, Contacts& contacts) {
  for (const std::uint32_t c : range.pressing) {
    const double stiffness = laws.at(c).stiffness;
    (*contacts.normal_force)[c] = stiffness * (*contacts.overlap)[c];
    (*contacts.stiffness)[c] = stiffness;
  }
}

}  // namespace

Role role(const Linear& linear, const Scene& scene) {
  Role out;
  require_one_elastic_law(scene, Linear::name);
  if (linear.stiffness == 0) out.off = "the stiffness is 0";
  out.needs = {.contacts = true, .normal_force = true};
  out.needs.fastest = collision_time(scene);
  return out;
}

void install(const Linear& linear, World& world) {
  const ByPair<Linear> laws = by_pair(world, linear, &Effects::linear);
  world.contact_passes.push_back(
      {Linear::name, [laws, &world](const ContactRange& range) { press_linear(laws, range, world.contacts); }});
  world.energies.push_back({Linear::name, [laws, &world] {
                              double sum = 0;
                              for (const std::uint32_t c : world.contacts.pressing) {
                                const double overlap = (*world.contacts.overlap)[c];
                                sum += laws.at(c).stiffness * overlap * overlap / 2;
                              }
                              return sum;
                            }});
}

}  // namespace plumb::scene
