// Shapes as cases hold them: { "capsule": { "half_length": .., "radius": .. } }, or one swept by a sphere.
#pragma once

#include <string>

#include "corpus/json/fields.hpp"
#include "solver/shape/convex.hpp"

namespace plumb {

/// What a body is before it is placed.
struct SweptShape {
  Shape shape;
  double swept_radius = 0;  ///< the sum of all radii, in the order of nesting, the innermost first
  std::string path;         ///< of the shape within the sweeps, as errors name it
};

/// Refuses what holds none of read_shape's shapes or several, and says which there are. Throws FieldError.
void require_a_shape(const Field& shape);

/// The shape may be an illegal one: its numbers are find_input_error's. Throws FieldError.
[[nodiscard]] SweptShape read_shape(const Field& shape);

/// The same where nothing but a superellipsoid may stand.
[[nodiscard]] Superellipsoid<double> read_superellipsoid(const Field& shape);

/// Whether it is one of read_shape's that read_superellipsoid refuses.
[[nodiscard]] bool is_other_shape(const Field& shape);

/// A foreign one is written with its radii alone, and is not read. A swept one as one sphere_swept. A polyhedron's points are the corners of its hull.
[[nodiscard]] Json shape_json(const Shape& shape, double swept_radius);

}  // namespace plumb
