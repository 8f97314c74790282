// Volume and inertia against quadrature over directions, and against bodies that everybody knows.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <numbers>

#include "solver/scene/body/mass.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::scene {
namespace {

using Four = Eigen::Vector4d;

/// Volume, and integrals of x^2, y^2, z^2, one octant times 8: 1/3 g^-3 and 1/5 u^2 g^-5 over the directions u, dz dphi.
Four moments_by_quadrature(const Superellipsoid<double>& shape) {
  Four out = Four::Zero();
  for (int k = 0; k < 4; ++k) {
    boost::math::quadrature::tanh_sinh<double> across(8), along(8);
    const auto density = [&](double z, double phi) {
      const double r = std::sqrt((1 - z) * (1 + z));
      const Vec3<double> u(r * std::cos(phi), r * std::sin(phi), z);
      const double g = gauge(shape, u);
      return k == 0 ? 1 / (3 * g * g * g) : u[k - 1] * u[k - 1] / (5 * std::pow(g, 5));
    };
    const auto slice = [&](double z) {
      return along.integrate([&](double phi) { return density(z, phi); }, 0.0, std::numbers::pi / 2, 1e-10);
    };
    out[k] = 8 * across.integrate(slice, 0.0, 1.0, 1e-10);
  }
  return out;
}

void expect_moments(const Superellipsoid<double>& shape, double tolerance) {
  const MassProperties found = mass_properties(shape);
  const Four exact = moments_by_quadrature(shape);
  EXPECT_NEAR(found.volume / exact[0], 1, tolerance);
  for (int k = 0; k < 3; ++k) {
    const double inertia = exact[1 + (k + 1) % 3] + exact[1 + (k + 2) % 3];
    EXPECT_NEAR(found.inertia[k] / inertia, 1, tolerance) << k;
  }
}

// The quadrature is asked for 1e-10; exponents below 2 have infinite curvatures of g on the axes, which it meets at its ends.
TEST(MassProperties, AgreeWithQuadrature) {
  for (const double n1 : {1.3, 2.0, 3.7, 8.0})
    for (const double n2 : {1.5, 2.0, 5.0}) {
      SCOPED_TRACE(testing::Message() << n1 << ' ' << n2);
      expect_moments({{1.3, 0.6, 0.9}, n1, n2}, 1e-8);
    }
}

constexpr double rounding = 1e-14;

void expect_known(const Superellipsoid<double>& shape, double volume, const Vec3<double>& inertia, double tolerance) {
  const MassProperties found = mass_properties(shape);
  EXPECT_NEAR(found.volume, volume, tolerance * volume);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(found.inertia[k], inertia[k], tolerance * inertia[k]) << k;
}

TEST(MassProperties, OfAnEllipsoid) {
  const double a = 0.3, b = 2, c = 1.1, m = 4.0 / 3 * std::numbers::pi * a * b * c;
  expect_known({{a, b, c}}, m, m / 5 * Vec3<double>(b * b + c * c, c * c + a * a, a * a + b * b), rounding);
}

// |x/a|^n + .. <= 1 with n towards infinity: what is missing of the corners goes as 1/n^2, times pi^2/6 a corner.
TEST(MassProperties, TendToThoseOfABox) {
  const double a = 0.3, b = 2, c = 1.1, n = 1e4, m = 8 * a * b * c;
  const Vec3<double> inertia = m / 3 * Vec3<double>(b * b + c * c, c * c + a * a, a * a + b * b);
  expect_known({{a, b, c}, n, n}, m, inertia, 20 / (n * n));
}

TEST(MassProperties, TendToThoseOfAnOctahedron) {
  const double a = 0.3, b = 2, c = 1.1, m = 4.0 / 3 * a * b * c, n = 1 + 1e-9;
  const Vec3<double> inertia = m / 10 * Vec3<double>(b * b + c * c, c * c + a * a, a * a + b * b);
  expect_known({{a, b, c}, n, n}, m, inertia, 20 * (n - 1));
}

TEST(MassProperties, TendToThoseOfACylinder) {
  const double r = 0.7, half = 1.3, n = 1e4, m = 2 * std::numbers::pi * r * r * half;
  const double across = m * (r * r / 4 + half * half / 3);
  expect_known({{r, r, half}, n, 2}, m, {across, across, m * r * r / 2}, 20 / (n * n));
}

RC_GTEST_PROP(MassProperties, BoundingBallHoldsTheBody, ()) {
  const auto number = [](int low, int high) { return 1e-3 * *rc::gen::inRange(low, high); };
  const Superellipsoid<double> shape{
      {number(100, 3000), number(100, 3000), number(100, 3000)}, number(1010, 30000), number(1010, 30000)};
  const Vec3<double> u(number(-1000, 1000), number(-1000, 1000), number(1, 1000));
  RC_ASSERT(u.norm() / gauge(shape, u) <= bounding_radius(shape) * (1 + 1e-14));
}

}  // namespace
}  // namespace plumb::scene
