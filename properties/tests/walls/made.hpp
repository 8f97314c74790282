// Walls of triangles that the tests of walls share.
#pragma once

#include <vector>

#include "properties/tests/scene/made.hpp"
#include "solver/scene/wall/mesh.hpp"

namespace plumb::scene::made {

[[nodiscard]] inline MeshWall mesh_of(std::vector<Triangle> triangles, double smooth_deg = 30) {
  return {std::make_shared<const Mesh>(std::move(triangles)), {}, smooth_deg};
}

/// Both triangles of a quadrangle, cut along one diagonal or the other.
inline void add_quadrangle(std::vector<Triangle>& out, const std::array<Vec, 4>& q, bool other = false) {
  if (other) {
    out.push_back({q[1], q[2], q[3]});
    out.push_back({q[1], q[3], q[0]});
  } else {
    out.push_back({q[0], q[1], q[2]});
    out.push_back({q[0], q[2], q[3]});
  }
}

/// n x n squares over origin + [0, 1] along + [0, 1] across, their diagonals and their windings at random.
[[nodiscard]] inline std::vector<Triangle> sheet(int n, const Vec& origin, const Vec& along, const Vec& across) {
  std::vector<Triangle> out;
  Stream draws("sheet", 7, 0);
  const auto at = [&](int i, int j) -> Vec { return origin + along * (double(i) / n) + across * (double(j) / n); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      add_quadrangle(out, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, draws.chance(0.5));
  for (Triangle& t : out)
    if (draws.chance(0.5)) std::swap(t[1], t[2]);
  return out;
}

/// The six sides of a box about the origin, n x n squares each.
[[nodiscard]] inline std::vector<Triangle> box_sheets(const Vec& half, int n) {
  std::vector<Triangle> out;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      const Vec a = Vec::Unit((axis + 1) % 3).cwiseProduct(half), b = Vec::Unit((axis + 2) % 3).cwiseProduct(half);
      const Vec side = sign * Vec::Unit(axis).cwiseProduct(half);
      const auto more = sheet(n, side - a - b, 2 * a, 2 * b);
      out.insert(out.end(), more.begin(), more.end());
    }
  return out;
}

/// A strip that follows points of the plane y = 0, from y = -1 to 1.
[[nodiscard]] inline std::vector<Triangle> strip(const std::vector<Vec>& points, double half_width = 1) {
  std::vector<Triangle> out;
  const Vec side(0, half_width, 0);
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    add_quadrangle(out, {points[k] - side, points[k + 1] - side, points[k + 1] + side, points[k] + side});
  return out;
}

[[nodiscard]] inline Wall wall_of(WallShape shape, const Vec& at = Vec::Zero()) {
  Wall out;
  out.point = at;
  out.shape = std::move(shape);
  return out;
}

[[nodiscard]] inline const std::vector<std::uint32_t>& touching(const Simulation& run) {
  return run.world().contacts.touching;
}
[[nodiscard]] inline Vec normal(const Simulation& run, std::uint32_t contact) {
  return run.world().contacts.normal->vector(contact);
}

}  // namespace plumb::scene::made
