#include "solver/scene/body/mass.hpp"

#include <cmath>

#include "solver/shape/shapes.hpp"

namespace plumb::scene {
namespace {

/// Integral of x^i over the quarter |x|^p + |y|^p <= 1 of the plane, x, y > 0.
double quarter_moment(int i, double p) {
  return std::tgamma((i + 1) / p) * std::tgamma(1 / p) / (p * p * std::tgamma((i + 2) / p + 1));
}

/// Integral of t^i (1 - t^p)^(j/p) over 0..1: what the slices at height t add up to.
double slices(int i, int j, double p) {
  return std::tgamma((i + 1) / p) * std::tgamma(j / p + 1) / (p * std::tgamma((i + j + 1) / p + 1));
}

}  // namespace

MassProperties mass_properties(const Superellipsoid<double>& shape) {
  const Vec3<double> square = shape.semi_axes.cwiseAbs2();
  const double box = 8 * shape.semi_axes.prod();
  const double volume = box * quarter_moment(0, shape.n2) * slices(0, 2, shape.n1);
  const double across = box * quarter_moment(2, shape.n2) * slices(0, 4, shape.n1);
  const double along = box * quarter_moment(0, shape.n2) * slices(2, 2, shape.n1);
  const Vec3<double> second(square.x() * across, square.y() * across, square.z() * along);
  return {volume, Vec3<double>(second.y() + second.z(), second.z() + second.x(), second.x() + second.y())};
}

double bounding_radius(const Superellipsoid<double>& shape) {
  constexpr double rounding = 1e-14;
  const double reach = RowOf<Superellipsoid<double>>::reach(shape);
  return shape.n1 <= 2 && shape.n2 <= 2 ? reach : reach * (1 + rounding);
}

bool is_sphere(const Superellipsoid<double>& shape) {
  return shape.n1 == 2 && shape.n2 == 2 && shape.semi_axes.minCoeff() == shape.semi_axes.maxCoeff();
}

}  // namespace plumb::scene
