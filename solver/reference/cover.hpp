// The stored proof that a common normal is the global one: a cover of all directions, with a reason for each part of it.
//
// Directions are v = F (chart point), F an invertible 3x3 frame of doubles and the chart point on the cube's face `axis`,
// `sign`: component `axis` is sign, the two that follow it are u and v. Each face is a quadtree, written in preorder.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "solver/contact.hpp"

namespace plumb::reference {

/// Of the doubles that a cover is written in.
inline constexpr double machine_epsilon = std::numeric_limits<double>::epsilon();

/// A square of directions on one face of the cube; it may reach beyond [-1, 1].
struct Cell {
  int axis;
  double sign, u, v, half;

  [[nodiscard]] Vec3<double> at(double du, double dv) const {
    Vec3<double> out;
    out[axis] = sign;
    out[(axis + 1) % 3] = u + du * half;
    out[(axis + 2) % 3] = v + dv * half;
    return out;
  }
  [[nodiscard]] Cell quarter(int which) const {
    const double h = half / 2;
    return {axis, sign, u + (which % 2 == 0 ? -h : h), v + (which / 2 == 0 ? -h : h), h};
  }
};

/// A point of each body, body axes over 2^exponent. o(n) >= n.(p1 - p2) for every n, whatever the points are.
struct Witness {
  Vec3<double> point1, point2;
};

enum class Leaf : std::uint8_t {
  split,     ///< four quarters follow
  excluded,  ///< its witness shows that o is higher there than at the solution
  open,      ///< its witness bounds o from below, not well enough to exclude it
  bounded,   ///< the same, inside one of the regions where o has one minimum
  convex     ///< inside such a region, whose minimum itself bounds o well enough
};

struct Cover {
  Mat3<double> frame = Mat3<double>::Identity();
  std::vector<Leaf> tree;          ///< six faces: axis 0 sign -1, axis 0 sign +1, axis 1 ..
  std::vector<Witness> witnesses;  ///< of the leaves that are not convex, in the tree's order
  std::vector<int> regions_of;     ///< of the leaves bounded and convex, in the tree's order
  std::vector<Cell> regions;       ///< the first is that of the solution
};

/// Part of a meridian where o has one minimum at most: near the place high + low.
struct Valley {
  double first, last, high, low;
};

/// A half circle of directions in the place of a cover (meridian.hpp): a pair of points for each arc between two places.
struct Meridian {
  std::vector<double> places;
  std::vector<Witness> witnesses;
  std::vector<Valley> valleys;  ///< the arcs inside one are bounded by its lowest place as well
};

/// The six faces in the order of Cover::tree.
[[nodiscard]] inline Cell face_of_cube(int index) {
  return {index / 2, index % 2 == 0 ? -1.0 : 1.0, 0, 0, 1};
}

}  // namespace plumb::reference
