// A wall as scenes hold it: a plane, or a shape at a place.
#pragma once

#include <string>

#include "corpus/json/fields.hpp"
#include "solver/scene/scene.hpp"

namespace plumb::scene {

/// Plane or shape, where it is; temperature and material are the caller's. Files of triangles are named from `folder`. Throws FieldError,
/// and InputFailure of such a file.
[[nodiscard]] Wall read_wall_place(const Field& field, const std::string& folder);

/// The same members.
[[nodiscard]] Json wall_place_json(const Wall& wall);

}  // namespace plumb::scene
