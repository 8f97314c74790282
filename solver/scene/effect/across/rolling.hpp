// Rolling resistance: a couple against the relative rotation across the normal, a spring that sticks up to
// coefficient * radius * normal force and slips beyond (elastic-plastic spring, Ai et al. 2011, model C, but that its dashpot slips
// with it: stick_slip.hpp).
// `radius` is 1 / (1/r1 + 1/r2) of the distances from the contact to the centres; r2 of a wall is infinite.
#pragma once

#include "solver/contact.hpp"
#include "solver/scene/effect/across/couple.hpp"

namespace plumb::scene {

/// The part of a rotation across a contact's normal.
struct AcrossNormal {
  static constexpr std::string_view name = "rolling";
  /// `normal`: a unit vector.
  [[nodiscard]] static Vec3<double> of(const Vec3<double>& v, const Vec3<double>& normal) {
    return v - normal.dot(v) * normal;
  }
};

/// Resistance to rolling. The head of rolling.hpp has the law.
using Rolling = Couple<AcrossNormal>;

[[nodiscard]] Role role(const Rolling& rolling, const Scene& scene);
void install(const Rolling& rolling, World& world);

}  // namespace plumb::scene
