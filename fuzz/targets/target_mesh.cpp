// Bytes as a file of triangles: the first byte says which kind (even: STL, odd: OBJ), the rest is the file. The reader refuses with
// InputFailure or reads; what it reads makes a mesh, whose facets, edges and corners hold together, and that a body can be asked about.
#include <fmt/format.h>

#include <cmath>

#include "corpus/case/case.hpp"
#include "corpus/scene/mesh_file.hpp"
#include "fuzz/targets/target.hpp"
#include "solver/scene/wall/touches.hpp"

namespace plumb {
namespace {

using scene::Mesh;

/// What is wrong with a mesh; empty where nothing is.
std::string fault_of(const Mesh& mesh) {
  constexpr double rounding = 1e-9, tilt = 3e-5;  // of two sides against their facets, mesh_maker.cpp
  const auto is_unit = [&](const Vec3<double>& v) { return std::abs(v.norm() - 1) <= rounding; };
  for (const scene::MeshFacet& facet : mesh.facets())
    if (!is_unit(facet.normal)) return "a facet's normal is not unit";
  for (const scene::MeshEdge& edge : mesh.edges()) {
    if (!is_unit(edge.start) || !is_unit(edge.end) || !is_unit(edge.inward)) return "an edge's normal is not unit";
    const Vec3<double> last = std::cos(edge.width) * edge.start - std::sin(edge.width) * edge.inward;
    if (!((last - edge.end).norm() <= tilt)) return "an edge's arc does not end at its end";
  }
  for (const scene::MeshCorner& corner : mesh.corners())
    for (const Vec3<double>& direction : mesh.directions_from(corner))
      if (!is_unit(direction)) return "a direction out of a corner is not unit";
  return {};
}

/// Bodies about its first corners.
std::string fault_of_touches(const scene::MeshWall& wall) {
  const double size = wall.mesh->extent();
  std::vector<std::uint32_t> scratch;
  for (std::size_t k = 0; k < std::min<std::size_t>(4, wall.mesh->triangles().size()); ++k) {
    const Superellipsoid<double> shape{Vec3<double>(0.3, 0.2, 0.1) * size, 4, 2};
    const Vec3<double> at = wall.mesh->triangles()[k][0] + Vec3<double>(0.01, 0.02, 0.07) * size;
    scene::Touches touches;
    scene::find_touches(wall, {shape, at, Eigen::Quaterniond::Identity(), 0.4 * size, 0}, scratch, touches);
    for (const scene::Touch& touch : touches.all())
      if (!(std::abs(touch.into.norm() - 1) <= 1e-9) || !(touch.overlap > 0)) return "a contact is none";
  }
  return {};
}

}  // namespace

Outcome examine(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return {false, "no file"};
  const std::string text(bytes.begin() + 1, bytes.end());
  try {
    const scene::MeshWall wall = scene::made_mesh(
        bytes[0] % 2 == 0 ? scene::parse_stl(text, "input") : scene::parse_obj(text, "input"), "input");
    std::string fault = fault_of(*wall.mesh);
    if (fault.empty()) fault = fault_of_touches(wall);
    if (!fault.empty()) return {true, fault};
    return {false,
            fmt::format("read: {} triangles, {} facets", wall.mesh->triangles().size(), wall.mesh->facets().size())};
  } catch (const InputFailure& e) {
    return {false, fmt::format("refused: {}", e.what())};
  } catch (const std::exception& e) {
    return {true, fmt::format("the reader threw what it must not: {}", e.what())};
  }
}

}  // namespace plumb
