// Twisting resistance: a couple against the relative rotation about the normal, the same spring as that of rolling.hpp.
#pragma once

#include "solver/contact.hpp"
#include "solver/scene/effect/across/couple.hpp"

namespace plumb::scene {

/// The part of a rotation about a contact's normal.
struct AboutNormal {
  static constexpr std::string_view name = "twisting";
  /// `normal`: a unit vector.
  [[nodiscard]] static Vec3<double> of(const Vec3<double>& v, const Vec3<double>& normal) {
    return normal.dot(v) * normal;
  }
};

/// Resistance to turning about the normal. The head of twisting.hpp has the law.
using Twisting = Couple<AboutNormal>;

[[nodiscard]] Role role(const Twisting& twisting, const Scene& scene);
void install(const Twisting& twisting, World& world);

}  // namespace plumb::scene
