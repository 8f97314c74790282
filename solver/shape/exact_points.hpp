// Points of doubles whose orientations are decided exactly: by floating point where its proved error bound allows, by integers
// otherwise.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "solver/contact.hpp"

namespace plumb::detail {

/// Finite points, no two equal. Indices are those of the points.
class ExactPoints {
 public:
  explicit ExactPoints(std::vector<Vec3<double>> points);

  [[nodiscard]] int count() const { return static_cast<int>(points_.size()); }
  [[nodiscard]] const Vec3<double>& operator[](int i) const { return points_[static_cast<std::size_t>(i)]; }

  /// Sign of ((b - a) x (c - a)).(d - a).
  [[nodiscard]] int orientation(int a, int b, int c, int d) const;
  /// Sign of component `axis` of (b - a) x (c - a).
  [[nodiscard]] int turn(int axis, int a, int b, int c) const;
  [[nodiscard]] bool are_collinear(int a, int b, int c) const;
  /// (b - a) x (c - a) over its length, within two units in the last place; the three are not collinear.
  [[nodiscard]] Vec3<double> unit_normal(int a, int b, int c) const;

 private:
  using Integer = boost::multiprecision::cpp_int;
  using Integers = std::array<Integer, 3>;

  [[nodiscard]] Integers difference(int to, int from) const;
  [[nodiscard]] Integer component(int axis, int a, int b, int c) const;
  [[nodiscard]] Integers normal(int a, int b, int c) const;

  std::vector<Vec3<double>> points_;
  std::vector<Vec3<double>> scaled_;  ///< by a power of two, to at most 1
  std::vector<Integers> integers_;    ///< by another one, all whole
};

}  // namespace plumb::detail
