#include "solver/scene/effect/rolling.hpp"

#include "solver/scene/effect.hpp"
#include "solver/scene/effect/couple.hpp"
#include "solver/scene/facts.hpp"

namespace plumb::scene {
namespace {

/// What of a rotation is across the normal.
constexpr auto rolling_part = [](const Vec3<double>& v, const Vec3<double>& normal) -> Vec3<double> {
  return v - normal.dot(v) * normal;
};

}  // namespace

Role role(const Rolling& rolling, const Scene& scene) {
  Role out;
  require_elastic_force(scene, Rolling::name, "is a share of a normal force");
  if (!has_elastic_force(scene)) out.off = "the elastic force is 0";
  if (rolling.coefficient == 0) out.off = "the coefficient is 0";
  out.needs = {
      .contacts = true, .points = true, .spin = true, .normal_force = true, .normal_mass = true, .radius = true};
  out.needs.fastest = couple_time(rolling, scene);
  return out;
}

void install(const Rolling& rolling, World& world) {
  Column& springs = world.columns.add("rolling_spring", Rolling::name, history(3));
  world.contact_passes.push_back(
      {Rolling::name, [rolling, &springs, &world] { resist(rolling, springs, world, rolling_part); }});
  world.energies.push_back(
      {Rolling::name, [rolling, &springs, &world] { return spring_energy(rolling, springs, world); }});
}

}  // namespace plumb::scene
