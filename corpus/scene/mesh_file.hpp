// Triangles as files hold them: STL, binary or in words, and OBJ.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/scene/wall/mesh.hpp"
#include "solver/scene/wall/wall_shape.hpp"

namespace plumb::scene {

/// By its name: .stl or .obj. Throws InputFailure: file, line where it has lines, field, reason.
[[nodiscard]] std::vector<Triangle> read_mesh_file(const std::string& path);

/// The same of what such a file holds. `file` is for errors.
[[nodiscard]] std::vector<Triangle> parse_stl(std::string_view bytes, const std::string& file);
[[nodiscard]] std::vector<Triangle> parse_obj(std::string_view text, const std::string& file);

/// Of triangles that a body can touch. Throws InputFailure.
[[nodiscard]] MeshWall made_mesh(std::vector<Triangle> triangles, const std::string& file);

}  // namespace plumb::scene
