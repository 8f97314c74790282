// The lowest common normal of two polytopes by their faces, edges and corners.
#pragma once

#include "solver/method/convex/descent.hpp"
#include "solver/method/convex/nearest_corner.hpp"
#include "solver/method/convex/polytopes.hpp"
#include "solver/method/convex/shared_face.hpp"

namespace plumb::detail {

/// A common normal, whether it is known to be the lowest, and what that took.
struct Lowest {
  CommonNormal contact;
  bool is_proved;
  int cells;
};

/// The contact along the lowest normal of a face or of two edges that cross, or along what of them is as low; nullopt: none is exact.
[[nodiscard]] inline std::optional<CommonNormal> contact_of_features(const PlacedCores& pair, const Descent& descent,
                                                                     const PolytopeMinimum& minimum,
                                                                     const Vec3<double>& lowest) {
  for (const auto& n : {minimum.face_as_low(), std::optional(lowest)}) {
    if (!n) continue;
    if (const auto shared = SharedFace(pair, *n).contact(); shared && descent.is_exact(*shared)) return shared;
    if (const CommonNormal found = descent.along(*n); descent.is_exact(found)) return found;
  }
  return std::nullopt;
}

/// Of polytopes that overlap by more than rounding; nullopt: of others.
[[nodiscard]] inline std::optional<Lowest> lowest_of_polytopes(const PlacedCores& pair, const Vec3<double>& line) {
  if (!pair.are_polytopes()) return std::nullopt;
  const Descent descent(pair);
  const Vec3<double> low = pair.has_hull() ? descent.a_step_from(line) : line;
  if (!(pair.overlap(low) > 0)) return std::nullopt;
  PolytopeMinimum minimum(pair, low);
  const auto normal = minimum.lowest();
  if (!normal || !(pair.overlap(*normal) > pair.rounding())) return std::nullopt;
  if (const auto found = contact_of_features(pair, descent, minimum, *normal)) return Lowest{*found, true, 0};
  const CommonNormal beside = descent.from(*normal);
  if (!descent.is_exact(beside) || beside.overlap > pair.overlap(*normal) + pair.rounding()) return std::nullopt;
  return Lowest{beside, true, 0};
}

/// Of polytopes that were not solved and are apart, or overlap by rounding: there is one common normal alone. nullopt: it is not that of features.
[[nodiscard]] inline std::optional<Lowest> nearest_features(const PlacedCores& pair, const Vec3<double>& low) {
  if (!pair.are_polytopes()) return std::nullopt;
  const Descent descent(pair);
  PolytopeMinimum minimum(pair, low);
  if (const auto normal = minimum.lowest(); normal && pair.overlap(*normal) <= pair.rounding())
    if (const auto found = contact_of_features(pair, descent, minimum, *normal)) return Lowest{*found, true, 0};
  const auto corner = NearestCorner(pair).contact();
  const bool is_normal =
      corner && descent.is_exact(*corner) && pair.overlap(corner->normal) <= corner->overlap + pair.rounding();
  return is_normal ? std::optional(Lowest{*corner, true, 0}) : std::nullopt;
}

}  // namespace plumb::detail
