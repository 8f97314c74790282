#include "solver/scene/effect/normal/dmt.hpp"

#include <numbers>

#include "solver/scene/body/world.hpp"
#include "solver/scene/effect.hpp"
#include "solver/scene/facts.hpp"
#include "solver/scene/material/by_pair.hpp"

namespace plumb::scene {
namespace {

/// `pulls`: of each contact's life; 0 of one that has just begun.
void pull(const ByPair<Dmt>& laws, Column& pulls, const ContactRange& range, Contacts& contacts) {
  for (const std::uint32_t c : range.pressing) {
    if (pulls[c] == 0) {
      const auto curvature = contacts.curvature->entry(c);
      pulls[c] = std::numbers::pi * laws.at(c).work_of_adhesion / std::sqrt(curvature[0] * curvature[1]);
    }
    (*contacts.normal_force)[c] -= pulls[c];
  }
}

double stored(const Column& pulls, const Contacts& contacts) {
  double sum = 0;
  for (const std::uint32_t c : contacts.pressing) sum -= pulls[c] * (*contacts.overlap)[c];
  return sum;
}

}  // namespace

Role role(const Dmt& dmt, const Scene& scene) {
  Role out;
  require_elastic_force(scene, Dmt::name, "pulls bodies into each other until an elastic force stops them");
  if (dmt.work_of_adhesion == 0)
    out.off = "the work of adhesion is 0";
  else if (!has_elastic_force(scene.effects))
    throw SceneError("effects.dmt", "pulls bodies into each other, and the elastic force is 0");
  out.needs = {.contacts = true, .curvature = true, .normal_force = true};
  return out;
}

void install(const Dmt& dmt, World& world) {
  Column& pulls = world.columns.add("dmt_pull", Dmt::name, history(1));
  world.contact_passes.push_back(
      {Dmt::name, [laws = by_pair(world, dmt, &Effects::dmt), &pulls, &world](const ContactRange& range) {
         pull(laws, pulls, range, world.contacts);
       }});
  world.energies.push_back({Dmt::name, [&pulls, &world] { return stored(pulls, world.contacts); }});
}

}  // namespace plumb::scene
