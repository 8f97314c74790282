// The core of a convex body: the body without the radius by which it is swept, in its own axes and an enclosed unit of length. A
// capsule's core is its segment, a sphere's a point. Six kinds cover all shapes but the half-space.
//
// Trusted: support_of and proved_point, and what makes a core. Not trusted: farthest and near, which only guess.
#pragma once

#include <limits>
#include <variant>
#include <vector>

#include "solver/reference/interval/enclosure.hpp"
#include "solver/reference/interval/interval_double.hpp"
#include "solver/shape/convex.hpp"

namespace plumb::reference::cores {

using I = DoubleInterval;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Octants of superellipsoids; of a superellipsoid all alike.
struct OctantsCore {
  std::array<I, 6> semi_axes;  ///< in PolySuperellipsoid's order
  double n1, n2;
};

/// The hull of two discs at z = bottom and z = top. The origin lies inside.
struct DiscsCore {
  I bottom, top, bottom_radius, top_radius;
};

/// Points within both balls that a tablet's caps are of, and within its radius of the axis. The origin lies inside.
struct TabletCore {
  I half_length, radius, cap_height;
  I ball;  ///< the radius of the balls
};

/// A body by functions, whose enclosures are believed, and that no point of it is beyond the bound.
struct ForeignCore {
  ForeignShape shape;
  int exponent;
  I bound;
};

/// Half-extents that may be 0: a segment or a point as well.
struct BoxCore {
  IVec3<I> half_extents;
};

/// The hull of points.
struct CornersCore {
  std::vector<IVec3<I>> corners;
  std::vector<Vec3<double>> rough;
};

using Core = std::variant<OctantsCore, DiscsCore, TabletCore, BoxCore, CornersCore, ForeignCore>;

/// A point in body axes that is thought to belong to a core; of CornersCore one of its corners, of ForeignCore the farthest one along a
/// direction.
struct CorePoint {
  Vec3<double> at;
  int corner = -1;
  Vec3<double> along = Vec3<double>::Zero();
};

/// Of any shape but a half-space, lengths over 2^exponent.
[[nodiscard]] Core core_of(const Shape& shape, int exponent);
/// What the shape is more than its core.
[[nodiscard]] I radius_about_core(const Shape& shape, int exponent);

/// Whether its support is known in intervals: not that of a foreign shape without enclosures.
[[nodiscard]] bool is_enclosed(const ConvexBody& body);

/// max of u.x over the core, for every u of the box.
[[nodiscard]] I support_of(const Core& core, const IVec3<I>& u);
/// A box that holds a point of the core: the given one, drawn in where it does not prove to be inside.
[[nodiscard]] IVec3<I> proved_point(const Core& core, const CorePoint& point);
/// Where u.x is greatest, rounded.
[[nodiscard]] CorePoint farthest(const Core& core, const Vec3<double>& u);
/// A point of the core near x, rounded: as near as rounding where x lies on the core's surface; of corners the nearest.
[[nodiscard]] CorePoint near(const Core& core, const Vec3<double>& x);

}  // namespace plumb::reference::cores
