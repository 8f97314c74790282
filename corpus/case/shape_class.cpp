#include "corpus/case/shape_class.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace plumb {
namespace {

int equal_axes(const Vec3<double>& axes) {
  return int(axes[0] == axes[1]) + int(axes[1] == axes[2]) + int(axes[0] == axes[2]);
}

std::array<double, 3> sorted_axes(const Superellipsoid<double>& shape) {
  std::array<double, 3> axes{shape.semi_axes[0], shape.semi_axes[1], shape.semi_axes[2]};
  std::sort(axes.begin(), axes.end());
  return axes;
}

std::string slenderness(const Pair& pair) {
  bool needle = false, disc = false;
  for (const Body* body : {&pair.body1, &pair.body2}) {
    const auto axes = sorted_axes(body->shape);
    needle = needle || axes[2] >= 10 * axes[1];
    disc = disc || axes[1] >= 10 * axes[0];
  }
  if (needle && disc) return "-needle-and-disc";
  return needle ? "-needle" : (disc ? "-disc" : "");
}

}  // namespace

ShapeKind shape_kind(const Superellipsoid<double>& shape) {
  if (shape.n1 == 2 && shape.n2 == 2) {
    const int equal = equal_axes(shape.semi_axes);
    return equal == 3 ? ShapeKind::sphere : (equal == 1 ? ShapeKind::spheroid : ShapeKind::ellipsoid);
  }
  if (std::min(shape.n1, shape.n2) < 2) return ShapeKind::pointed_superquadric;
  return std::max(shape.n1, shape.n2) <= 4 ? ShapeKind::round_superquadric : ShapeKind::blocky_superquadric;
}

std::string shape_class(const Pair& pair) {
  static constexpr std::array<std::string_view, 6> names{
      "spheres", "spheroids", "ellipsoids", "round_superquadrics", "blocky_superquadrics", "pointed_superquadrics"};
  const ShapeKind kind = std::max(shape_kind(pair.body1.shape), shape_kind(pair.body2.shape));
  return std::string(names[static_cast<std::size_t>(kind)]) + slenderness(pair);
}

}  // namespace plumb
