// The faces and edges of polytopes, in body axes.
#pragma once

#include "solver/method/convex/placed_cores.hpp"

namespace plumb::detail {

/// An edge from corner to corner, and the normals of its two faces; a segment's has none.
struct EdgeOfCore {
  Vec3<double> from, to;
  std::array<Vec3<double>, 2> normals;
  bool has_faces;

  [[nodiscard]] Vec3<double> direction() const { return to - from; }
};

inline const std::array<Vec3<double>, 2> none{Vec3<double>::Zero(), Vec3<double>::Zero()};

struct SegmentEdges {
  const SegmentCore& core;

  [[nodiscard]] static int faces() { return 0; }
  [[nodiscard]] static Vec3<double> face_normal(int) { return Vec3<double>::Zero(); }
  [[nodiscard]] int edges() const { return core.half_length > 0 ? 1 : 0; }
  [[nodiscard]] EdgeOfCore edge(int) const { return {core.corner(0), core.corner(1), none, false}; }
};

struct BoxEdges {
  const BoxCore& core;

  [[nodiscard]] static int faces() { return 6; }
  [[nodiscard]] static Vec3<double> face_normal(int k) { return (k % 2 == 0 ? -1.0 : 1.0) * Vec3<double>::Unit(k / 2); }
  [[nodiscard]] static int edges() { return 12; }
  /// Four along each axis.
  [[nodiscard]] EdgeOfCore edge(int k) const {
    const int axis = k / 4, second = (axis + 1) % 3, third = (axis + 2) % 3;
    const double along_second = k % 2 == 0 ? -1 : 1, along_third = k / 2 % 2 == 0 ? -1 : 1;
    const Vec3<double> n2 = along_second * Vec3<double>::Unit(second), n3 = along_third * Vec3<double>::Unit(third);
    const Vec3<double>&a = core.half_extents, along = Vec3<double>::Unit(axis);
    return {a.cwiseProduct(n2 + n3 - along), a.cwiseProduct(n2 + n3 + along), {n2, n3}, true};
  }
};

struct HullEdges {
  const HullCore& core;

  [[nodiscard]] int faces() const { return static_cast<int>(core.hull->faces.size()); }
  [[nodiscard]] const Vec3<double>& face_normal(int k) const {
    return core.hull->faces[static_cast<std::size_t>(k)].normal;
  }
  [[nodiscard]] int edges() const { return static_cast<int>(core.hull->edges.size()); }
  [[nodiscard]] EdgeOfCore edge(int k) const {
    const HullEdge& e = core.hull->edges[static_cast<std::size_t>(k)];
    const Vec3<double> from = core.corner(e.corners[0]), to = core.corner(e.corners[1]);
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
