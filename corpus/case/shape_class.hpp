// What kind of shapes a pair is of, in words: for the names of files that keep cases.
#pragma once

#include <string>

#include "solver/contact.hpp"

namespace plumb {

/// Rising: the less simple the shape. Pointed: an exponent below 2; round: all at most 4.
enum class ShapeKind { sphere, spheroid, ellipsoid, round_superquadric, blocky_superquadric, pointed_superquadric };

[[nodiscard]] ShapeKind shape_kind(const Superellipsoid<double>& shape);

/// "spheres", "blocky_superquadrics" .. of the less simple body; then "-needle", "-disc", "-needle-and-disc" where an aspect
/// reaches 10.
[[nodiscard]] std::string shape_class(const Pair& pair);

}  // namespace plumb
