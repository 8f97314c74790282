// The core of a convex body: the body without the radius by which it is swept, in its own axes and an enclosed unit of length. A
// capsule's core is its segment, a sphere's a point.
//
// Trusted: support_of and proved_point, and what makes a core. Not trusted: farthest and near, which only guess.
#pragma once

#include <limits>
#include <memory>

#include "solver/reference/interval/enclosure.hpp"
#include "solver/reference/interval/interval_double.hpp"
#include "solver/shape/convex.hpp"

namespace plumb::reference::cores {

using I = DoubleInterval;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// One of the kinds in core.cpp.
struct KindOfCore;
using Core = std::shared_ptr<const KindOfCore>;

/// A point in body axes that is thought to belong to a core; of a hull of points one of them, of a foreign body the farthest
/// one along a direction.
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
