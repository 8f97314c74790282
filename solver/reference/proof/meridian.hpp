// Verifier of a meridian: what verify.hpp is for a cover. No search, only checks.
//
// Of bodies of revolution about one line o depends on the angle to it alone, so that a half circle of directions, a meridian,
// bounds it everywhere. Input that is so but for rounding counts as well: what the rounding changes is bounded and taken off.
#pragma once

#include <optional>

#include "solver/reference/proof/verify.hpp"

namespace plumb::reference {

[[nodiscard]] bool is_sphere(const Superellipsoid<double>& shape);

/// o of two spheres is r1 + r2 - n.c: lowest along the line of centres.
template <class I>
[[nodiscard]] I lowest_overlap_of_spheres(const EnclosedPair<I>& pair);

/// Upper bound of the difference of o between two directions at the same angle to the frame's third axis; zero where the
/// bodies' axes and the line of centres are that axis exactly, infinite where a body is not of revolution.
template <class I>
[[nodiscard]] I asymmetry(const Pair& pair, const FramedPair<I>& framed);

/// Part of the meridian F (x, 0, z), x >= 0: places along the cube of chart points, from 0 (the frame's third axis) to 4 (its
/// opposite), a corner of the cube at 1 and at 3.
struct Arc {
  double first, last;
};

/// The chart point at a place on the same side of the corners as `near`.
template <class T>
[[nodiscard]] Vec3<T> chart_at(const T& place, double near) {
  if (near <= 1) return {place, T(0.0), T(1.0)};
  if (near <= 3) return {T(1.0), T(0.0), T(T(2.0) - place)};
  return {T(T(4.0) - place), T(0.0), T(-1.0)};
}
template <class T>
[[nodiscard]] Vec3<T> chart_at(double place) {
  return chart_at<T>(T(place), place);
}

/// Lower bound of o on an arc without a corner inside, from the difference of two points of the bodies (points_apart); minus
/// infinity where they bound nothing.
template <class I>
[[nodiscard]] double least_on(const FramedPair<I>& framed, const Arc& arc, const IVec3<I>& apart);

/// Lower bound of o on the arc that a valley is, from o and its slope at the valley's place; nothing where o is not proved to
/// have one minimum at most there.
template <class I>
[[nodiscard]] std::optional<I> least_in(const FramedPair<I>& framed, const Valley& valley);

/// What a meridian proves.
template <class I>
struct MeridianProof {
  bool well_formed = false;  ///< the arcs make the half circle, and every witness lies in its body
  I least = I(-std::numeric_limits<double>::infinity());  ///< lower bound of o over all directions
};

/// `framed` encloses `pair` and the frame.
template <class I>
[[nodiscard]] MeridianProof<I> verify_meridian(const Pair& pair, const FramedPair<I>& framed, const Meridian& meridian);

}  // namespace plumb::reference
