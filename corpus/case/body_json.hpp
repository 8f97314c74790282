// A body as cases and scenes hold it: shape, position, orientation.
#pragma once

#include "corpus/json/fields.hpp"
#include "solver/contact.hpp"
#include "solver/shape/convex.hpp"

namespace plumb {

/// A quaternion (w, x, y, z), from one or from Euler angles, which are evaluated in 50 digits. Throws FieldError.
[[nodiscard]] std::array<double, 4> read_orientation(const Field& orientation);

/// Reads a legal body from an object's shape, position and orientation; its other members are the caller's. Where something
/// else places it, it has no position. Euler angles are evaluated in 50 digits. Throws FieldError.
[[nodiscard]] Body read_body(const Field& field, bool placed = false);

/// The same of every shape, always with a position.
[[nodiscard]] ConvexBody read_convex_body(const Field& field);

/// Position and quaternion.
[[nodiscard]] Json body_json(const Body& body);
[[nodiscard]] Json body_json(const ConvexBody& body);

}  // namespace plumb
