// Makes a mesh ready: joins its triangles at their corners, lays together what lies in one plane, and finds the normals of edges and
// corners.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/scene/wall/mesh.hpp"

namespace plumb::scene {

class MeshMaker {
 public:
  explicit MeshMaker(Mesh& mesh) : mesh_(mesh) {}
  /// Throws std::invalid_argument.
  void make();

 private:
  /// A side of a triangle, between two joined corners, the lower first.
  struct Joint {
    std::array<std::uint32_t, 2> ends;
    TriangleSide side;
  };

  void check_triangles() const;
  void order_triangles();
  void join_corners();
  void list_joints();
  void lay_together();
  void fill_facet(std::uint32_t seed);
  void order_facets();
  void sharpen(MeshFacet& facet, std::span<const std::uint32_t> members) const;
  [[nodiscard]] bool is_in_plane(const MeshFacet& facet, std::uint32_t triangle) const;
  void find_edges();
  void find_edge(std::span<const Joint> joints);
  void find_corners();
  void find_corner(std::uint32_t corner, std::vector<Vec3<double>>& directions, TriangleSide first);
  [[nodiscard]] Vec3<double> inward_of(TriangleSide side) const;
  /// The joints of one edge after the other.
  template <class Visit>
  void each_edge(const Visit& visit) const;

  Mesh& mesh_;
  std::vector<std::array<std::uint32_t, 3>> corners_;  ///< of each triangle, joined
  std::vector<Joint> joints_;                          ///< sorted by their ends
  std::vector<std::array<std::uint32_t, 3>> joint_of_;
  std::uint32_t corner_count_ = 0;
};

}  // namespace plumb::scene
