#include "solver/scene/effect/normal/cohesion.hpp"

#include "solver/scene/body/world.hpp"
#include "solver/scene/effect.hpp"
#include "solver/scene/facts.hpp"
#include "solver/scene/material/by_pair.hpp"

namespace plumb::scene {
namespace {

/// Share of the pull that is left at an overlap.
double share(const Cohesion& cohesion, double overlap) {
  return overlap >= 0 ? 1 : std::max(0.0, 1 + overlap / cohesion.range);
}

/// Work to part from this overlap.
double stored(const Cohesion& cohesion, double overlap) {
  const double left = share(cohesion, overlap);
  return -cohesion.pull_off * (std::max(0.0, overlap) + cohesion.range * left * left / 2);
}

}  // namespace

Role role(const Cohesion& cohesion, const Scene& scene) {
  Role out;
  require_elastic_force(scene, Cohesion::name, "pulls bodies into each other until an elastic force stops them");
  if (cohesion.pull_off == 0)
    out.off = "the pull is 0";
  else if (!has_elastic_force(scene.effects))
    throw SceneError("effects.cohesion", "pulls bodies into each other, and the elastic force is 0");
  out.needs = {.contacts = true, .normal_force = true, .range = cohesion.pull_off > 0 ? cohesion.range : 0};
  return out;
}

void install(const Cohesion& cohesion, World& world) {
  const ByPair<Cohesion> laws = by_pair(world, cohesion, &Effects::cohesion);
  world.contact_passes.push_back({Cohesion::name, [laws, &world](const ContactRange& range) {
                                    Contacts& contacts = world.contacts;
                                    for (const std::uint32_t c : range.touching)
                                      (*contacts.normal_force)[c] -=
                                          laws.at(c).pull_off * share(laws.at(c), (*contacts.overlap)[c]);
                                  }});
  world.energies.push_back({Cohesion::name, [laws, &world] {
                              double sum = 0;
                              for (const std::uint32_t c : world.contacts.touching)
                                sum += stored(laws.at(c), (*world.contacts.overlap)[c]);
                              return sum;
                            }});
}

}  // namespace plumb::scene
