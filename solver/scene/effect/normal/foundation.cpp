#include "solver/scene/effect/normal/foundation.hpp"

#include "solver/scene/body/world.hpp"
#include "solver/scene/effect.hpp"
#include "solver/scene/facts.hpp"

namespace plumb::scene {
namespace {

/// The force at the centre of the volume, which acts with all others along normals, and the couple that moves it on.
void press(const Foundation& law, const ContactRange& range, Contacts& contacts) {
  for (const std::uint32_t c : range.pressing) {
    const double area = (*contacts.area)[c];  // 0 of a body within another, which nothing pushes out
    const double force = area > 0 ? law.stiffness * (*contacts.volume)[c] : 0;
    (*contacts.normal_force)[c] = force;
    (*contacts.stiffness)[c] = law.stiffness * area;
    if (law.tilt_ratio != 1 && force > 0 && contacts.arm1 != nullptr)
      range.action(c).turn((1 - law.tilt_ratio) * force / area * contacts.area_moment->vector(c));
  }
}

/// int depth^2 dA / 2, of a patch whose volume grows as overlap^q, q = area * overlap / volume.
double stored(const Foundation& law, const Contacts& contacts, std::size_t c) {
  const double volume = (*contacts.volume)[c], overlap = (*contacts.overlap)[c];
  return volume > 0 ? law.stiffness * volume * volume * overlap / (volume + (*contacts.area)[c] * overlap) : 0;
}

}  // namespace

Role role(const Foundation& foundation, const Scene& scene) {
  Role out;
  require_one_elastic_law(scene, Foundation::name);
  if (foundation.stiffness == 0) out.off = "the stiffness is 0";
  out.needs = {.contacts = true, .points = true, .patch = true, .normal_force = true};
  out.needs.fastest = collision_time(scene);
  return out;
}

void install(const Foundation& foundation, World& world) {
  world.contact_passes.push_back({Foundation::name, [foundation, &world](const ContactRange& range) {
                                    press(foundation, range, world.contacts);
                                  }});
  world.energies.push_back({Foundation::name, [foundation, &world] {
                              double sum = 0;
                              for (const std::uint32_t c : world.contacts.pressing)
                                sum += stored(foundation, world.contacts, c);
                              return sum;
                            }});
}

}  // namespace plumb::scene
