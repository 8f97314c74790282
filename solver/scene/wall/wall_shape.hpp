// What a wall may be beside a half space: triangles, a cylinder, a cone, a box. Lengths in the scene's unit, in the wall's own axes.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "solver/contact.hpp"

namespace plumb::scene {

class Mesh;

/// The half space that the wall's normal points away from.
struct PlaneWall {};

/// On which side of it bodies are.
enum class Side { inside, outside };
inline constexpr std::array<std::string_view, 2> side_words{"inside", "outside"};  ///< of files, as the next ones

/// Of a wall with bodies inside, where it ends.
enum class End {
  open,   ///< the rim is an edge that bodies touch
  bare,   ///< nothing touches the rim: another wall goes on there
  closed  ///< by a flat end
};
inline constexpr std::array<std::string_view, 3> end_words{"open", "bare", "closed"};

[[nodiscard]] inline std::string_view word_of(Side side) {
  return side_words[static_cast<std::size_t>(side)];
}
[[nodiscard]] inline std::string_view word_of(End end) {
  return end_words[static_cast<std::size_t>(end)];
}

/// A thin sheet of triangles, which bodies may touch on either side: on that of their centre.
struct MeshWall {
  std::shared_ptr<const Mesh> mesh;  ///< of mesh.hpp; copies share it
  std::string file;                  ///< where it was read; empty: the triangles stand in the scene
  /// Contacts whose normals differ by less, and whose points are as near as that tells, are one: the deepest.
  double smooth_deg = 30;
};

/// About the z axis, |z| <= half_length. Outside: solid with flat ends.
struct CylinderWall {
  double radius = 1, half_length = 1;
  Side side = Side::inside;
  std::array<End, 2> ends{End::open, End::open};  ///< the lower, the upper
};

/// About the z axis, of radii[0] at z = 0 and radii[1] at z = height; one of them may be 0. Outside: solid with flat ends.
struct ConeWall {
  std::array<double, 2> radii{1, 1};
  double height = 1;
  Side side = Side::inside;
  std::array<End, 2> ends{End::open, End::open};  ///< the lower, the upper
};

/// |x| <= half_extents[0] and so on. Inside: a closed room.
struct BoxWall {
  Vec3<double> half_extents = Vec3<double>::Ones();
  Side side = Side::inside;
};

/// One of them. What copies it is in the source: g++ 12 sees values that are not set in a variant's copy where it is inlined.
struct WallShape : std::variant<PlaneWall, MeshWall, CylinderWall, ConeWall, BoxWall> {
  using variant::variant;
  WallShape();
  WallShape(const WallShape& other);
  WallShape(WallShape&& other) noexcept;
  WallShape& operator=(const WallShape& other);
  WallShape& operator=(WallShape&& other) noexcept;
  ~WallShape();
};

/// At how many places at once a body can touch it: so many entries of the contact list has a pair.
[[nodiscard]] std::size_t places_of(const WallShape& shape);

/// The greatest distance of a point of it from the wall's own point; infinite of a plane.
[[nodiscard]] double extent_of(const WallShape& shape);

/// The word of scene files: "plane", "mesh", ..
[[nodiscard]] const char* name_of(const WallShape& shape);

}  // namespace plumb::scene
