#include "solver/shape/hull.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "solver/shape/exact_points.hpp"

namespace plumb {
namespace {

using detail::ExactPoints;
using Polygon = std::vector<int>;
using Link = std::array<int, 2>;
using Plane = std::array<int, 3>;

bool is_before(const Vec3<double>& p, const Vec3<double>& q) {
  return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
}

/// Each point once, in the order of their first places.
std::vector<Vec3<double>> distinct(std::span<const Vec3<double>> points) {
  std::vector<Vec3<double>> out;
  std::set<std::array<double, 3>> seen;
  for (const Vec3<double>& p : points)
    if (seen.insert({p[0], p[1], p[2]}).second) out.push_back(p);
  return out;
}

void refuse_illegal(std::span<const Vec3<double>> points) {
  if (points.empty()) throw std::invalid_argument("a polyhedron needs a point");
  for (const Vec3<double>& p : points)
    if (!p.allFinite()) throw std::invalid_argument("a polyhedron's points must be finite");
}

/// The corners of points in the plane of three of them, counterclockwise as those three (Andrew's chain).
Polygon polygon_of(const ExactPoints& points, Polygon inside, const Plane& plane) {
  int axis = 0;
  while (points.turn(axis, plane[0], plane[1], plane[2]) == 0) ++axis;
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  std::sort(inside.begin(), inside.end(), [&](int p, int q) {
    return std::array{points[p][i], points[p][j]} < std::array{points[q][i], points[q][j]};
  });
  Polygon out;
  const auto chain = [&](auto first, auto last) {
    const std::size_t start = out.size();
    for (auto at = first; at != last; ++at) {
      while (out.size() > start + 1 && points.turn(axis, out[out.size() - 2], out.back(), *at) <= 0) out.pop_back();
      out.push_back(*at);
    }
    out.pop_back();
  };
  chain(inside.begin(), inside.end());
  chain(inside.rbegin(), inside.rend());
  if (points.turn(axis, plane[0], plane[1], plane[2]) < 0) std::reverse(out.begin(), out.end());
  return out;
}

/// Gift wrapping: from one face over its edges to all others, each with every point that lies in its plane.
class Wrapping {
 public:
  explicit Wrapping(const ExactPoints& points) : points_(points) {}

  [[nodiscard]] std::vector<Polygon> run() {
    add(first_plane());
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const Polygon face = faces_[f];
      for (std::size_t i = 0; i < face.size(); ++i) {
        const int from = face[i], to = face[(i + 1) % face.size()];
        if (!links_.contains({to, from})) add(beyond(from, to, beside_[f]));
      }
    }
    return faces_;
  }

 private:
  /// Of the first point in lexicographic order and the z-axis: the plane through them that has all points on one side.
  [[nodiscard]] Plane first_plane() const {
    int a = 0, b = -1;
    for (int i = 1; i < points_.count(); ++i)
      if (is_before(points_[i], points_[a])) a = i;
    const auto is_above = [&](int i) { return points_[i][0] == points_[a][0] && points_[i][1] == points_[a][1]; };
    for (int i = 0; i < points_.count(); ++i)
      if (!is_above(i) && (b < 0 || points_.turn(2, a, b, i) < 0)) b = i;
    int beside = -1;
    for (int i = 0; i < points_.count(); ++i) {
      if (points_.turn(2, a, b, i) != 0)
        beside = i;
      else if (!points_.are_collinear(a, b, i))
        return {a, b, i};
    }
    return beyond(a, b, beside);  // the plane holds but the edge a b
  }

  /// The face at the edge from `from` to `to` of a face whose plane does not hold `beside`.
  [[nodiscard]] Plane beyond(int from, int to, int beside) const {
    int c = beside;
    for (int i = 0; i < points_.count(); ++i)
      if (points_.orientation(to, from, c, i) > 0) c = i;
    return {to, from, c};
  }

  void add(Plane plane) {
    Polygon inside;
    int beside = -1;
    for (int i = 0; i < points_.count(); ++i) {
      const int side = points_.orientation(plane[0], plane[1], plane[2], i);
      if (side == 0)
        inside.push_back(i);
      else
        beside = i;
      if (side > 0) std::swap(plane[0], plane[1]);
    }
    faces_.push_back(polygon_of(points_, inside, plane));
    beside_.push_back(beside);
    const Polygon& face = faces_.back();
    for (std::size_t i = 0; i < face.size(); ++i) links_.insert({face[i], face[(i + 1) % face.size()]});
  }

  const ExactPoints& points_;
  std::vector<Polygon> faces_;
  std::vector<int> beside_;  ///< of each face a point that is not in its plane
  std::set<Link> links_;     ///< of neighbouring corners, as each face runs through them
};

/// Edges of faces whose corners have their last numbers.
std::vector<HullEdge> edges_of(const std::vector<HullFace>& faces) {
  std::map<Link, int> face_of;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Polygon& corners = faces[f].corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
      face_of[{corners[i], corners[(i + 1) % corners.size()]}] = static_cast<int>(f);
  }
  std::vector<HullEdge> out;
  for (const auto& [link, face] : face_of)
    if (link[0] < link[1]) out.push_back({link, {face, face_of.at({link[1], link[0]})}});
  return out;
}

Hull hull_of_faces(const ExactPoints& points, std::vector<Polygon> polygons) {
  std::map<int, int> number_of;
  for (const Polygon& polygon : polygons)
    for (const int i : polygon) number_of[i] = 0;
  Hull out;
  for (auto& [i, number] : number_of) {
    number = static_cast<int>(out.corners.size());
    out.corners.push_back(points[i]);
  }
  for (Polygon& polygon : polygons) {
    const Vec3<double> normal = points.unit_normal(polygon[0], polygon[1], polygon[2]);
    for (int& i : polygon) i = number_of[i];
    out.faces.push_back({std::move(polygon), normal});
  }
  out.edges = edges_of(out.faces);
  return out;
}

/// Of points on one line, at least two: the ends are the extremes of any coordinate that changes.
Hull hull_of_segment(const ExactPoints& points) {
  int low = 0, high = 0;
  for (int i = 1; i < points.count(); ++i) {
    if (is_before(points[i], points[low])) low = i;
    if (is_before(points[high], points[i])) high = i;
  }
  const auto [first, second] = std::minmax({low, high});
  return {{points[first], points[second]}, {{{0, 1}, {-1, -1}}}, {}};
}

Hull hull_of_polygon(const ExactPoints& points, const Plane& plane) {
  Polygon all;
  for (int i = 0; i < points.count(); ++i) all.push_back(i);
  const Polygon front = polygon_of(points, all, plane), back(front.rbegin(), front.rend());
  return hull_of_faces(points, {front, back});
}

Hull hull_of(const ExactPoints& points) {
  if (points.count() == 1) return {{points[0]}, {}, {}};
  int c = 2, d = 2;
  while (c < points.count() && points.are_collinear(0, 1, c)) ++c;
  if (c == points.count()) return hull_of_segment(points);
  while (d < points.count() && points.orientation(0, 1, c, d) == 0) ++d;
  if (d == points.count()) return hull_of_polygon(points, {0, 1, c});
  return hull_of_faces(points, Wrapping(points).run());
}

}  // namespace

Polyhedron make_polyhedron(std::span<const Vec3<double>> points) {
  refuse_illegal(points);
  Hull hull = hull_of(ExactPoints(distinct(points)));
  for (const Vec3<double>& corner : hull.corners) hull.reach = std::max(hull.reach, corner.stableNorm());
  return {std::make_shared<const Hull>(std::move(hull))};
}

}  // namespace plumb
