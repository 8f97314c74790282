// The faces and edges of polytopes, in body axes.
#pragma once

#include "solver/method/convex/placed_cores.hpp"

namespace plumb::detail {

/// The numbers of an edge's corners.
struct Ends {
  int from, to;
};

/// The numbers of the two faces that meet at an edge; -1: it has none.
struct Sides {
  int first, second;
};

/// An edge from corner to corner, and the normals of its two faces; a segment's has none.
struct EdgeOfCore {
  Vec3<double> from, to;
  std::array<Vec3<double>, 2> normals;
  bool has_faces;

  [[nodiscard]] Vec3<double> direction() const { return to - from; }
};

/// Whose edges have few directions, each at every corner: a box, a segment.
template <class Edges>
concept HasDirections = requires(const Edges& edges) { edges.directions(); };

/// Across both, of any length: across what of `other` is across `along`, for the product of two that are nearly parallel would be known
/// to rounding over their angle alone.
[[nodiscard]] inline Vec3<double> crossing_of(const Vec3<double>& along, const Vec3<double>& other) {
  return along.cross(other - other.dot(along) / along.squaredNorm() * along);
}

inline const std::array<Vec3<double>, 2> none{Vec3<double>::Zero(), Vec3<double>::Zero()};

struct SegmentEdges {
  const SegmentCore& core;

  [[nodiscard]] static int faces() { return 0; }
  [[nodiscard]] static Vec3<double> face_normal(int) { return Vec3<double>::Zero(); }
  [[nodiscard]] int edges() const { return core.half_length > 0 ? 1 : 0; }
  [[nodiscard]] static Ends ends(int) { return {0, 1}; }
  [[nodiscard]] static Sides sides(int) { return {-1, -1}; }
  [[nodiscard]] EdgeOfCore edge(int) const { return {core.corner(0), core.corner(1), none, false}; }
  [[nodiscard]] int directions() const { return edges(); }
  [[nodiscard]] static Vec3<double> direction(int) { return Vec3<double>::UnitZ(); }
};

struct BoxEdges {
  const BoxCore& core;

  [[nodiscard]] static int faces() { return 6; }
  [[nodiscard]] static Vec3<double> face_normal(int k) { return (k % 2 == 0 ? -1.0 : 1.0) * Vec3<double>::Unit(k / 2); }
  [[nodiscard]] static int edges() { return 12; }
  /// Four along each axis.
  [[nodiscard]] static Ends ends(int k) {
    const int axis = k / 4, from = (k % 2 << second(axis)) + (k / 2 % 2 << third(axis));
    return {from, from + (1 << axis)};
  }
  [[nodiscard]] static Sides sides(int k) {
    const int axis = k / 4;
    return {2 * second(axis) + k % 2, 2 * third(axis) + k / 2 % 2};
  }
  [[nodiscard]] EdgeOfCore edge(int k) const {
    const int axis = k / 4;
    const Vec3<double> n2 = (k % 2 == 0 ? -1.0 : 1.0) * Vec3<double>::Unit(second(axis)),
                       n3 = (k / 2 % 2 == 0 ? -1.0 : 1.0) * Vec3<double>::Unit(third(axis));
    return {core.corner(ends(k).from), core.corner(ends(k).to), {n2, n3}, true};
  }
  [[nodiscard]] static int directions() { return 3; }
  [[nodiscard]] static Vec3<double> direction(int axis) { return Vec3<double>::Unit(axis); }

 private:
  [[nodiscard]] static int second(int axis) { return (axis + 1) % 3; }
  [[nodiscard]] static int third(int axis) { return (axis + 2) % 3; }
};

struct HullEdges {
  const HullCore& core;

  [[nodiscard]] int faces() const { return static_cast<int>(core.hull->faces.size()); }
  [[nodiscard]] const Vec3<double>& face_normal(int k) const {
    return core.hull->faces[static_cast<std::size_t>(k)].normal;
  }
  [[nodiscard]] int edges() const { return static_cast<int>(core.hull->edges.size()); }
  [[nodiscard]] Ends ends(int k) const {
    const auto& corners = core.hull->edges[static_cast<std::size_t>(k)].corners;
    return {corners[0], corners[1]};
  }
  [[nodiscard]] Sides sides(int k) const {
    const auto& faces = core.hull->edges[static_cast<std::size_t>(k)].faces;
    return {faces[0], faces[1]};
  }
  [[nodiscard]] EdgeOfCore edge(int k) const {
    const HullEdge& e = core.hull->edges[static_cast<std::size_t>(k)];
    const Vec3<double> from = core.corner(ends(k).from), to = core.corner(ends(k).to);
    if (e.faces[0] < 0) return {from, to, none, false};
    return {from, to, {face_normal(e.faces[0]), face_normal(e.faces[1])}, true};
  }
};

/// False: it is no polytope, and `use` is not called.
template <class F>
bool with_edges(const Core& core, const F& use) {
  if (const auto* segment = std::get_if<SegmentCore>(&core)) return use(SegmentEdges{*segment}), true;
  if (const auto* box = std::get_if<BoxCore>(&core)) return use(BoxEdges{*box}), true;
  if (const auto* hull = std::get_if<HullCore>(&core)) return use(HullEdges{*hull}), true;
  return false;
}

/// In the pair's frame, its normals times a sign.
[[nodiscard]] inline EdgeOfCore placed(const PlacedCore& body, const EdgeOfCore& edge, double sign) {
  const Mat3<double>& r = body.rotation;
  return {r * edge.from + body.centre,
          r * edge.to + body.centre,
          {sign * (r * edge.normals[0]), sign * (r * edge.normals[1])},
          edge.has_faces};
}

}  // namespace plumb::detail
