// Two cores in one frame: origin at body 1's position, world axes, lengths over 2^exponent. All that bound_overlap asks of a pair.
//
// A = core 1 - core 2 (Minkowski): o(n) of the cores is its support function, and a point w of A bounds o(n) >= n.w for every n.
#pragma once

#include "solver/reference/convex/core.hpp"

namespace plumb::reference::cores {

/// A point of each core, and w = point1 - point2, rounded.
struct Atom {
  CorePoint point1, point2;
  Vec3<double> w;
};

class PlacedCores {
 public:
  explicit PlacedCores(const ConvexPair& pair);

  /// World length = 2^exponent times the frame's.
  [[nodiscard]] int exponent() const { return exponent_; }
  /// By which both bodies are more than their cores.
  [[nodiscard]] const I& radii() const { return radii_; }
  /// Of body 2's position, rounded.
  [[nodiscard]] const Vec3<double>& rough_centre() const { return rough_centre_; }

  /// |v| o(v/|v|) of the cores, for every v of the box.
  [[nodiscard]] I support(const IVec3<I>& v) const;
  /// o(v/|v|) of the cores.
  [[nodiscard]] I overlap_at(const Vec3<double>& v) const;
  /// A box that holds a point of A.
  [[nodiscard]] IVec3<I> proved(const Atom& atom) const;

  /// The farthest along v, rounded.
  [[nodiscard]] Atom farthest(const Vec3<double>& v) const;
  /// Body 2 being a point on body 1's surface with outward normal n: that point, less the radii along n. w is not computed.
  [[nodiscard]] Atom on_surface(const Vec3<double>& n) const;

 private:
  int exponent_;
  Core core1_, core2_;
  IMat3<I> rotation1_, rotation2_;
  Mat3<double> rough1_, rough2_;
  IVec3<I> centre_;
  Vec3<double> rough_centre_;
  I radii_;
};

/// The rotation of a quaternion.
[[nodiscard]] IMat3<I> enclosed_rotation_of(const std::array<double, 4>& quaternion);
/// The exponent of a unit in which neither bodies nor the distance between them are large.
[[nodiscard]] int exponent_of(const ConvexPair& pair);
/// (to - from) 2^-exponent.
[[nodiscard]] IVec3<I> enclosed_difference(const Vec3<double>& to, const Vec3<double>& from, int exponent);
/// m v, and m's transpose times v.
[[nodiscard]] IVec3<I> times(const IMat3<I>& m, const IVec3<I>& v);
[[nodiscard]] IVec3<I> times_transpose(const IMat3<I>& m, const IVec3<I>& v);

}  // namespace plumb::reference::cores
