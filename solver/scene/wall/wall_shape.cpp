#include "solver/scene/wall/wall_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/scene/wall/mesh.hpp"
#include "solver/shape/overloaded.hpp"

namespace plumb::scene {
namespace {

/// Places of a curved wall or a mesh: of more, the deepest count, and the contact counts as failed.
constexpr std::size_t many_places = 8;
constexpr std::size_t faces_of_a_box = 6;

std::size_t places_on(Side side, std::size_t inside) {
  return side == Side::inside ? inside : 1;
}

}  // namespace

WallShape::WallShape() = default;
WallShape::WallShape(const WallShape& other) = default;
WallShape::WallShape(WallShape&& other) noexcept = default;
WallShape& WallShape::operator=(const WallShape& other) = default;
WallShape& WallShape::operator=(WallShape&& other) noexcept = default;
WallShape::~WallShape() = default;

std::size_t places_of(const WallShape& shape) {
  return std::visit(plumb::detail::Overloaded{
                        [](const PlaneWall&) -> std::size_t { return 1; }, [](const MeshWall&) { return many_places; },
                        [](const CylinderWall& wall) { return places_on(wall.side, many_places); },
                        [](const ConeWall& wall) { return places_on(wall.side, many_places); },
                        [](const BoxWall& wall) { return places_on(wall.side, faces_of_a_box); }},
                    shape);
}

double extent_of(const WallShape& shape) {
  return std::visit(
      plumb::detail::Overloaded{
          [](const PlaneWall&) { return std::numeric_limits<double>::infinity(); },
          [](const MeshWall& wall) { return wall.mesh->extent(); },
          [](const CylinderWall& wall) { return std::hypot(wall.radius, wall.half_length); },
          [](const ConeWall& wall) { return std::max(wall.radii[0], std::hypot(wall.radii[1], wall.height)); },
          [](const BoxWall& wall) { return wall.half_extents.norm(); }},
      shape);
}

const char* name_of(const WallShape& shape) {
  constexpr std::array names{"plane", "mesh", "cylinder", "cone", "box"};
  return names[shape.index()];
}

}  // namespace plumb::scene
