#include "solver/scene/effect/linear.hpp"

#include "solver/scene/body/world.hpp"
#include "solver/scene/effect.hpp"
#include "solver/scene/facts.hpp"

namespace plumb::scene {
namespace {

void press_linear(const Linear& linear, Contacts& contacts) {
  for (const std::uint32_t c : contacts.pressing) {
    (*contacts.normal_force)[c] = linear.stiffness * (*contacts.overlap)[c];
    (*contacts.stiffness)[c] = linear.stiffness;
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
  world.contact_passes.push_back({Linear::name, [linear, &world] { press_linear(linear, world.contacts); }});
  world.energies.push_back({Linear::name, [linear, &world] {
                              double sum = 0;
                              for (const std::uint32_t c : world.contacts.pressing) {
                                const double overlap = (*world.contacts.overlap)[c];
                                sum += linear.stiffness * overlap * overlap / 2;
                              }
                              return sum;
                            }});
}

}  // namespace plumb::scene
