// Triangles made ready for contacts: which of them lie in one plane, which edges and corners stick out.
//
// Facet    triangles that are joined and in one plane: they share its normal to the bit, and edges within are none
// Edge     between facets, or at the border. A body touches it along normals n, across it and away from every triangle that meets there:
//          n.f <= 0 for the directions f into the triangles. They are an arc; where the joint is flat there is none. Seen from its other
//          side an edge is concave, and nothing touches it.
// Corner   the same of all edges that meet there; one whose normals are no more than an arc is none
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "solver/contact.hpp"

namespace plumb::scene {

using Triangle = std::array<Vec3<double>, 3>;

struct MeshFacet {
  Vec3<double> normal;  ///< unit; on either side of it
  Vec3<double> point;
};

/// A side of a triangle: from its corner `side` to the next.
struct TriangleSide {
  std::uint32_t triangle, side;
};

struct MeshEdge {
  std::array<TriangleSide, 2> sides;  ///< where the arc starts and ends; the same of a border
  Vec3<double> from, to;
  /// Its normals: cos(t) start - sin(t) inward, 0 <= t <= width; the last is `end`.
  Vec3<double> start, end, inward;
  double width;
};

struct MeshCorner {
  Vec3<double> point;
  std::uint32_t triangle;                ///< one of those that meet there
  std::uint32_t first_edge, edge_count;  ///< in Mesh::edge_directions
};

class Mesh {
 public:
  /// Corners are joined where they are the same numbers. Throws std::invalid_argument: "triangles[3]: has no area", ..
  explicit Mesh(std::vector<Triangle> triangles);
  ~Mesh();
  Mesh(const Mesh&) = delete;
  Mesh& operator=(const Mesh&) = delete;

  /// Those that were given, in an order by place.
  [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
  /// Of the farthest corner from the origin.
  [[nodiscard]] double extent() const { return extent_; }
  [[nodiscard]] std::span<const MeshFacet> facets() const { return facets_; }
  [[nodiscard]] std::span<const MeshEdge> edges() const { return edges_; }
  [[nodiscard]] std::span<const MeshCorner> corners() const { return corners_; }
  /// Unit, out of a corner.
  [[nodiscard]] std::span<const Vec3<double>> directions_from(const MeshCorner& corner) const {
    return std::span(directions_).subspan(corner.first_edge, corner.edge_count);
  }

  static constexpr std::uint32_t none = 0xffffffffU;

  /// What a triangle is of, and what it has: none, where there is no such edge or corner.
  struct Parts {
    std::uint32_t facet = none;
    std::array<bool, 3> is_flat{};  ///< whether the triangle's neighbour at this side is of the same facet
    std::array<std::uint32_t, 3> edges{none, none, none}, corners{none, none, none};
  };
  [[nodiscard]] const Parts& parts(std::uint32_t triangle) const { return parts_[triangle]; }
  /// How far a point is on the triangle's side of one of its sides, times the side's length; the facet's normal is across all of them.
  [[nodiscard]] double inwards(TriangleSide at, const Vec3<double>& point) const;
  /// Triangles whose boxes meet a box, added to `out`.
  void near(const Vec3<double>& low, const Vec3<double>& high, std::vector<std::uint32_t>& out) const;

 private:
  struct Tree;

  std::vector<Triangle> triangles_;
  std::vector<MeshFacet> facets_;
  std::vector<MeshEdge> edges_;
  std::vector<MeshCorner> corners_;
  std::vector<Vec3<double>> directions_;
  std::vector<Parts> parts_;
  std::vector<char> is_reversed_;  ///< against its facet's normal
  std::unique_ptr<const Tree> tree_;
  double extent_ = 0;
  friend class MeshMaker;
};

}  // namespace plumb::scene
