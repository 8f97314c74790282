// The convex hull of points, with exact decisions: which points are corners, and which corners share a face, follows from the
// doubles by rational arithmetic.
#pragma once

#include <span>
#include <vector>

#include "solver/shape/convex.hpp"

namespace plumb {

/// A face: its corners, counterclockwise as seen from outside, and its unit normal, rounded from the exact one.
struct HullFace {
  std::vector<int> corners;
  Vec3<double> normal;
};

/// Two corners and the two faces that meet there.
struct HullEdge {
  std::array<int, 2> corners;
  std::array<int, 2> faces;
};

/// A polygon in space has two faces, of opposite normals, that meet at each edge; a segment has an edge and no face (faces -1), a point
/// neither.
struct Hull {
  std::vector<Vec3<double>> corners;  ///< in the order in which they were given
  std::vector<HullEdge> edges;
  std::vector<HullFace> faces;
  double reach = 0;  ///< the greatest distance of a corner from the origin
};

/// Of any number of finite points, repeated ones among them; throws std::invalid_argument where there is none or one is not finite.
[[nodiscard]] Polyhedron make_polyhedron(std::span<const Vec3<double>> points);

}  // namespace plumb
