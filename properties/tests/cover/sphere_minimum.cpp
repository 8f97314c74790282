// What the search over heights rests on: the minimum of a quadratic over the sphere.
#include "solver/method/auto/cover/sphere_minimum.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/generators/stream.hpp"

namespace plumb {
namespace {

/// n.M n - 2 c.n with M's eigenvalues and c's coordinates along its eigenvectors.
struct Quadratic {
  Symmetric3<double> m;
  Vector3<double> c;
  double size;

  Quadratic(const Vec3<double>& eigenvalues, const Vec3<double>& along, Stream& random) {
    const auto any = [&] { return Vec3<double>(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)); };
    Mat3<double> axes;
    axes.col(0) = any().normalized();
    axes.col(1) = axes.col(0).cross(any()).normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    const Mat3<double> full = axes * eigenvalues.asDiagonal() * axes.transpose();
    m = {full(0, 0), full(0, 1), full(0, 2), full(1, 1), full(1, 2), full(2, 2)};
    c = Vector3<double>::of(Vec3<double>(axes * along));
    size = eigenvalues.cwiseAbs().maxCoeff() + 2 * along.norm();
  }

  [[nodiscard]] double operator()(const Vector3<double>& n) const { return dot(n, m * n) - 2 * dot(n, c); }
};

Vector3<double> any_direction(Stream& random) {
  const Vec3<double> v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  return Vector3<double>::of(Vec3<double>(v.normalized()));
}

void expect_minimum(const Quadratic& q, Stream& random) {
  const SphereMinimum<double> least(q.m, q.c);
  const double rounding = 20 * epsilon<double>() * q.size, lowest = q(least.direction());
  EXPECT_NEAR(length(least.direction()), 1, 4 * epsilon<double>());
  for (int i = 0; i < 200; ++i) {
    const Vector3<double> far = any_direction(random), near = least.direction() + far * random.log_uniform(1e-9, 1);
    EXPECT_GE(q(far), lowest - rounding);
    EXPECT_GE(q(near * (1 / length(near))), lowest - rounding);
  }
}

TEST(SphereMinimum, IsNotAboveAnyOther) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    Stream random("sphere_minimum", 1, i);
    const auto number = [&] { return random.signed_log_uniform(1e-6, 1); };
    const Vec3<double> eigenvalues(random.log_uniform(1e-3, 1), random.log_uniform(1e-3, 1), 1);
    expect_minimum(Quadratic(eigenvalues, {number(), number(), number()}, random), random);
  }
}

/// c across the lowest eigenvectors: two minima, or a circle; and all but that, to the rounding.
TEST(SphereMinimum, OfSeveralIsOneOfThem) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    Stream random("sphere_minimum_hard", 1, i);
    const double lowest = random.log_uniform(1e-3, 0.5), apart = i % 3 == 0 ? 0 : random.log_uniform(1e-17, 1e-3);
    const double across = i % 2 == 0 ? 0 : random.signed_log_uniform(1e-18, 1e-8);
    const Vec3<double> along(across, -across / 3, random.uniform(0, 1 - lowest) * 0.9);
    expect_minimum(Quadratic({lowest, lowest + apart, 1}, along, random), random);
  }
}

TEST(SphereMinimum, WithoutALinearPartIsTheLeastEigenvalue) {
  Stream random("sphere_minimum_zero", 1, 0);
  expect_minimum(Quadratic({0.2, 0.3, 1}, Vec3<double>::Zero(), random), random);
  expect_minimum(Quadratic({1, 1, 1}, Vec3<double>::Zero(), random), random);
}

/// Centres that a needle's length divides.
TEST(SphereMinimum, OfAFarCentreIsTheLineOfCentres) {
  Stream random("sphere_minimum_far", 1, 0);
  expect_minimum(Quadratic({1e-6, 1e-3, 1}, {3e5, -2e5, 1e5}, random), random);
}

}  // namespace
}  // namespace plumb
