#include "solver/scene/effect/twisting.hpp"

#include "solver/scene/effect.hpp"
#include "solver/scene/effect/couple.hpp"
#include "solver/scene/facts.hpp"

namespace plumb::scene {
namespace {

/// What of a rotation is about the normal.
constexpr auto twisting_part = [](const Vec3<double>& v, const Vec3<double>& normal) -> Vec3<double> {
  return normal.dot(v) * normal;
};

}  // namespace

Role role(const Twisting& twisting, const Scene& scene) {
  Role out;
  require_elastic_force(scene, Twisting::name, "is a share of a normal force");
  if (!has_elastic_force(scene)) out.off = "the elastic force is 0";
  if (twisting.coefficient == 0) out.off = "the coefficient is 0";
  out.needs = {
      .contacts = true, .points = true, .spin = true, .normal_force = true, .normal_mass = true, .radius = true};
  out.needs.fastest = couple_time(twisting, scene);
  return out;
}

void install(const Twisting& twisting, World& world) {
  Column& springs = world.columns.add("twisting_spring", Twisting::name, history(3));
  world.contact_passes.push_back(
      {Twisting::name, [twisting, &springs, &world] { resist(twisting, springs, world, twisting_part); }});
  world.energies.push_back(
      {Twisting::name, [twisting, &springs, &world] { return spring_energy(twisting, springs, world); }});
}

}  // namespace plumb::scene
