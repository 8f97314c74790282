#include "solver/scene/effect/normal/hertz.hpp"

#include "solver/scene/body/world.hpp"
#include "solver/scene/contact/hertz_contact.hpp"
#include "solver/scene/effect.hpp"
#include "solver/scene/facts.hpp"
#include "solver/scene/material/by_pair.hpp"

namespace plumb::scene {
namespace {

/// Of pairs that have the law. `factors`: hertz_contact's, of each contact's life; 0 of one that has just begun.
void press_hertz(const ByPair<double>& moduli, Column& factors, const ContactRange& range, Contacts& contacts) {
  for (const std::uint32_t c : range.pressing) {
    if (moduli.at(c) == 0) continue;
    if (!(factors[c] > 0)) {
      const auto curvature = contacts.curvature->entry(c);
      factors[c] = hertz_contact(curvature[0], curvature[1]).force_factor;
    }
    const double overlap = (*contacts.overlap)[c];
    const double slope = moduli.at(c) * factors[c] * std::sqrt(overlap);
    (*contacts.normal_force)[c] = slope * overlap;
    (*contacts.stiffness)[c] = 1.5 * slope;
  }
}

}  // namespace

Role role(const Hertz& hertz, const Scene& scene) {
  Role out;
  if (hertz.youngs_modulus == 0) out.off = "Young's modulus is 0";
  out.needs = {.contacts = true, .curvature = true, .normal_force = true};
  out.needs.fastest = collision_time(scene);
  return out;
}

void install(const Hertz& hertz, World& world) {
  const ByPair<double> moduli(world, hertz, &Effects::hertz,
                              [](const Hertz& of_pair) { return of_pair.contact_modulus(); });
  Column& factors = world.columns.add("hertz_factor", Hertz::name, history(1));
  world.contact_passes.push_back({Hertz::name, [moduli, &factors, &world](const ContactRange& range) {
                                    press_hertz(moduli, factors, range, world.contacts);
                                  }});
  world.energies.push_back({Hertz::name, [moduli, &factors, &world] {
                              double sum = 0;
                              for (const std::uint32_t c : world.contacts.pressing)
                                sum += 0.4 * moduli.at(c) * factors[c] * std::pow((*world.contacts.overlap)[c], 2.5);
                              return sum;
                            }});
}

}  // namespace plumb::scene
