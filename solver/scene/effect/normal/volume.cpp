#include "solver/scene/effect/normal/volume.hpp"

#include <algorithm>

#include "solver/scene/body/world.hpp"
#include "solver/scene/effect.hpp"
#include "solver/scene/facts.hpp"

namespace plumb::scene {
namespace {

/// Where the volume grows as overlap^q, q = area * overlap / volume, the force grows as overlap^(q exponent - 1).
double slope_of(const Volume& law, double force, double overlap, double volume, double area) {
  const double q = area * overlap / volume;
  return force / overlap * std::max(1.0, q * law.exponent - 1);
}

/// The force along the patch's normal, which acts with all others of that kind, and the couple of its moment.
void press(const Volume& law, const ContactRange& range, Contacts& contacts) {
  for (const std::uint32_t c : range.pressing) {
    const double volume = (*contacts.volume)[c], area = (*contacts.area)[c];
    const double pressure = volume > 0 ? law.pressure(volume) : 0, force = pressure * area;
    (*contacts.normal_force)[c] = force;
    (*contacts.stiffness)[c] = force > 0 ? slope_of(law, force, (*contacts.overlap)[c], volume, area) : 0;
    if (contacts.arm1 != nullptr) range.action(c).turn(pressure * contacts.area_moment->vector(c));
  }
}

}  // namespace

Role role(const Volume& volume, const Scene& scene) {
  Role out;
  require_one_elastic_law(scene, Volume::name);
  if (volume.stiffness == 0) out.off = "the stiffness is 0";
  out.needs = {.contacts = true, .points = true, .patch = true, .normal_force = true};
  out.needs.fastest = collision_time(scene);
  return out;
}

void install(const Volume& volume, World& world) {
  world.contact_passes.push_back(
      {Volume::name, [volume, &world](const ContactRange& range) { press(volume, range, world.contacts); }});
  world.energies.push_back({Volume::name, [volume, &world] {
                              double sum = 0;
                              for (const std::uint32_t c : world.contacts.pressing)
                                sum += volume.energy((*world.contacts.volume)[c]);
                              return sum;
                            }});
}

}  // namespace plumb::scene
