// Contacts on a plane: of a half-space, of the flat end of a frustum, whose points are no mixture of a few support points, and of a face.
#pragma once

#include "solver/method/convex/descent.hpp"
#include "solver/method/convex/edges.hpp"

namespace plumb::detail {

/// The middle of the face of a core that is farthest along u: of its support points a little to all sides of u, those that are as far to
/// rounding.
[[nodiscard]] inline Vec3<double> middle_of_face(const PlacedCore& core, const Vec3<double>& u, double size) {
  constexpr double aside = 0x1p-40, rounding = 16 * std::numeric_limits<double>::epsilon();
  constexpr int sides = 8;
  const Vec3<double> s = u.unitOrthogonal(), t = u.cross(s), at = core.support(u).point;
  Vec3<double> sum = Vec3<double>::Zero();
  int count = 0;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * static_cast<double>(EIGEN_PI) * k / sides;
    const Vec3<double> x = core.support(u + aside * (std::cos(angle) * s + std::sin(angle) * t)).point;
    if ((at - x).dot(u) <= rounding * size) sum += x, ++count;
  }
  return count > 0 ? Vec3<double>(sum / count) : at;
}

/// With a plane through a point, of the first body or of the second, along its outward unit normal.
[[nodiscard]] inline CommonNormal contact_on_plane(const PlacedCores& pair, bool is_first, const Vec3<double>& point,
                                                   const Vec3<double>& outward) {
  const Vec3<double> lowest = middle_of_face(is_first ? pair.body2 : pair.body1, -outward, pair.size);
  const double depth = (point - lowest).dot(outward);
  const Vec3<double> on_plane = lowest + depth * outward;
  if (is_first) return {outward, depth, on_plane, lowest};
  return {-outward, depth, lowest, on_plane};
}

/// The outward normal, the frame's axes, of the flat face of a core that lies across u the most; nullopt: it has none.
[[nodiscard]] inline std::optional<Vec3<double>> face_across(const PlacedCore& body, const Vec3<double>& u) {
  const Vec3<double> own = body.rotation.transpose() * u;
  std::optional<Vec3<double>> out;
  const auto consider = [&](const Vec3<double>& n) {
    if (!out || n.dot(own) > out->dot(own)) out = n;
  };
  if (const auto* frustum = std::get_if<FrustumCore>(&body.core))
    for (std::size_t end = 0; end < 2; ++end)
      if (frustum->radii[end] > 0) consider(Vec3<double>::UnitZ() * (end == 1 ? 1 : -1));
  (void)with_edges(body.core, [&](const auto& polytope) {
    for (int face = 0; face < polytope.faces(); ++face) consider(polytope.face_normal(face));
  });
  if (out) out = body.rotation * *out;
  return out;
}

/// A contact on a face that is no higher than `level`, or the best itself: where that is exact, or there is none.
[[nodiscard]] inline CommonNormal settled_on_a_face(const PlacedCores& pair, const Descent& descent,
                                                    const CommonNormal& best, double level) {
  for (const bool is_first : {true, false}) {
    if (descent.is_exact(best)) break;
    const PlacedCore& body = is_first ? pair.body1 : pair.body2;
    const auto outward = face_across(body, is_first ? best.normal : Vec3<double>(-best.normal));
    if (!outward) continue;
    const CommonNormal found = contact_on_plane(pair, is_first, body.support(*outward).point, *outward);
    const bool is_held = body.holds(is_first ? found.point1 : found.point2, pair.rounding());
    if (is_held && found.overlap <= level && descent.is_exact(found)) return found;
  }
  return best;
}

}  // namespace plumb::detail
