// The patch: closed forms, and what must be true of it whatever the bodies.
#include "solver/patch/patch.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "properties/generators/families.hpp"
#include "properties/tests/extremes.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

constexpr double pi = std::numbers::pi;

Contact<double> solve_for_patch(const Pair& pair, double tolerance = 1e-3) {
  Want want;
  want.patch = true;
  want.patch_tolerance = tolerance;
  return find_method("auto")->solve(pair, want, nullptr);
}

Patch patch_of(const Pair& pair, double tolerance = 1e-3) {
  return solve_for_patch(pair, tolerance).patch.value_or(Patch{});
}

Body ball(double radius, double x) {
  Body out;
  out.shape.semi_axes.setConstant(radius);
  out.position[0] = x;
  return out;
}

/// A cap of a sphere on the plane z = 0, its pole at z = height: the integrals of 1, z, z^2 and x^2. With rho^2 = a^2 - 2 b z - z^2,
/// pi rho^2 z^k and pi rho^4 / 4 are integrated as polynomials.
struct SphereCap {
  long double volume, first, second, across;

  [[nodiscard]] static SphereCap of(long double radius, long double height) {
    const long double circle = std::numbers::pi_v<long double>, b = radius - height, a2 = height * (radius + b);
    const auto power = [&](int k) { return std::pow(height, k) / static_cast<long double>(k); };
    const auto moment = [&](int k) { return circle * (a2 * power(k + 1) - 2 * b * power(k + 2) - power(k + 3)); };
    return {moment(0), moment(1), moment(2),
            circle / 4 *
                (a2 * a2 * power(1) - 4 * a2 * b * power(2) + (4 * b * b - 2 * a2) * power(3) + 4 * b * power(4) +
                 power(5))};
  }
};

struct SphereLens {
  double volume, area, centre, along, across;

  /// Of spheres at 0 and at `distance` on x.
  [[nodiscard]] static SphereLens of(double radius1, double radius2, double distance) {
    const long double r1 = radius1, r2 = radius2, d = distance, overlap = r1 + r2 - d;
    const long double h1 = overlap * (2 * r2 - overlap) / (2 * d), h2 = overlap - h1;
    const SphereCap one = SphereCap::of(r1, h1), two = SphereCap::of(r2, h2);
    const long double v = one.volume + two.volume, from_plane = (one.first - two.first) / v;
    return {static_cast<double>(v), static_cast<double>(std::numbers::pi_v<long double> * h1 * (2 * r1 - h1)),
            static_cast<double>(r1 - h1 + from_plane),
            static_cast<double>((one.second + two.second) / v - from_plane * from_plane),
            static_cast<double>((one.across + two.across) / v)};
  }
};

void expect_lens(const Patch& patch, const SphereLens& lens, double error) {
  EXPECT_NEAR(patch.volume, lens.volume, error * lens.volume);
  EXPECT_NEAR(patch.area, lens.area, error * lens.area);
  EXPECT_NEAR(patch.normal[0], 1, error);
  EXPECT_NEAR(patch.centre[0], lens.centre, error * std::sqrt(lens.along));
  const double widest = std::max(lens.along, lens.across);
  EXPECT_NEAR(patch.second_moments.sum(), lens.along + 2 * lens.across, 3 * error * widest);
  EXPECT_NEAR(patch.second_moments[1], lens.across, error * widest);
  EXPECT_LT(patch.area_moment.norm(), error * lens.area * std::sqrt(lens.across));
}

TEST(Patch, IsTheLensOfTwoSpheres) {
  for (const double radius : {1.0, 0.3, 7.0})
    for (const double overlap : {1e-6, 1e-3, 0.05, 0.2})
      for (const double tolerance : {1e-2, 1e-3, 1e-6}) {
        const double distance = 1 + radius - overlap;
        const Patch patch = patch_of({ball(1, 0), ball(radius, distance)}, tolerance);
        ASSERT_LE(patch.error, tolerance + 1e-15 / overlap * 32 * (1 + radius)) << radius << ' ' << overlap;
        expect_lens(patch, SphereLens::of(1, radius, distance), patch.error);
      }
}

/// Exponents as near to 2 as can be go by the quadrature.
void expect_same(const Patch& closed, const Patch& by_quadrature) {
  const double error = closed.error + 2 * by_quadrature.error, width = std::sqrt(by_quadrature.second_moments[0]);
  EXPECT_NEAR(closed.volume, by_quadrature.volume, error * closed.volume);
  EXPECT_NEAR(closed.area, by_quadrature.area, error * closed.area);
  EXPECT_LE((closed.normal - by_quadrature.normal).norm(), error);
  EXPECT_LE((closed.centre - by_quadrature.centre).norm(), error * width);
  EXPECT_LE((closed.area_moment - by_quadrature.area_moment).norm(), error * closed.area * width);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(closed.second_moments[i], by_quadrature.second_moments[i], 2 * error * closed.second_moments[i]);
}

TEST(Patch, OfAnEllipsoidAtAWallIsAStretchedCap) {
  Body body = ball(1, 0);
  body.shape.semi_axes = {0.4, 0.7, 0.2};
  body.quaternion = {0.7, 0.1, -0.4, 0.5};
  body.position = {1, -2, 3};
  const Mat3<double> rotation = Eigen::Quaterniond(0.7, 0.1, -0.4, 0.5).normalized().toRotationMatrix();
  for (int x = -2; x <= 2; ++x)
    for (const double share : {1e-4, 0.1, 0.9, 1.7}) {
      const Vec3<double> into_wall = Vec3<double>(x, 1, 2).normalized();
      const double reach = (rotation.transpose() * into_wall).cwiseProduct(body.shape.semi_axes).norm();
      const Vec3<double> at_wall = body.position + (1 - share) * reach * into_wall;
      Body near_it = body;
      near_it.shape.n1 = 2 + 1e-14;
      const Patch closed = patch_at_wall(body, into_wall, at_wall, 1e-3);
      EXPECT_NEAR(closed.volume, pi * 0.4 * 0.7 * 0.2 * share * share * (3 - share) / 3, closed.error * closed.volume);
      expect_same(closed, patch_at_wall(near_it, into_wall, at_wall, 1e-6));
    }
}

TEST(Patch, OfABodyInsideTheOtherIsTheInnerBody) {
  Pair pair{ball(1, 0), ball(1, 0.2)};
  pair.body2.shape.semi_axes = {0.4, 0.3, 0.2};
  pair.body2.quaternion = {0.7, 0.1, -0.4, 0.5};
  const Patch patch = patch_of(pair);
  EXPECT_LE(patch.error, 1e-3);
  EXPECT_NEAR(patch.volume, 4 * pi / 3 * 0.4 * 0.3 * 0.2, 1e-3 * patch.volume);
  EXPECT_LT(patch.area, 1e-3 * patch.volume / 0.4);
  EXPECT_NEAR(patch.centre[0], 0.2, 1e-4);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(patch.second_moments[i], std::pow(0.4 - 0.1 * i, 2) / 5, 1e-3 * 0.16 / 5);
  EXPECT_TRUE(patch.normal.array().isNaN().all());
}

/// Superellipsoids whose exponents make them boxes to a relative error of about log(2)/n at an edge.
Body box(const Vec3<double>& half, const Vec3<double>& at, double exponent = 4000) {
  Body out;
  out.shape = {half, exponent, exponent};
  out.position = at;
  return out;
}

TEST(Patch, OfABodyBehindAWallIsTheBody) {
  Body body = ball(0.5, 0.25);
  body.shape.semi_axes[2] = 0.75;
  const double volume = 4 * pi / 3 * 0.5 * 0.5 * 0.75;
  for (const double exponent : {2.0, 4.0}) {
    body.shape.n1 = body.shape.n2 = exponent;
    for (const double distance : {0.5, 1.0, 3.0, 4.5, 10.0, 1e3, 1e9, 1e300}) {
      const Patch patch = patch_at_wall(body, Vec3<double>::UnitX(), {0.25 - distance, 1, 2}, 1e-3);
      ASSERT_LE(patch.error, 1e-3) << exponent << " at " << distance;
      if (exponent == 2) {
        EXPECT_NEAR(patch.volume, volume, 1e-3 * volume) << distance;
      }
      EXPECT_LE(patch.area, 1e-3) << exponent << " at " << distance;
      EXPECT_LE((patch.centre - body.position).norm(), 1e-3) << exponent << " at " << distance;
    }
  }
}

// Along a wall a ray hardly leaves it: Newton goes on for as long as the wall is not known to be farther than the body.
TEST(Patch, OfABodyBehindAnyWallIsOneOfTheBody) {
  Body body = ball(0.5, 0);
  body.position.setZero();
  body.shape.semi_axes = {1, 0.8, 0.5};
  for (const double exponent : {1.5, 2.5, 4.0, 8.0})
    for (int x = -3; x <= 3; ++x)
      for (int y = -3; y <= 3; ++y)
        for (const double distance : {-2.0, -0.9, -0.6, 0.1}) {
          body.shape.n1 = body.shape.n2 = exponent;
          const Vec3<double> into_wall = Vec3<double>(x, y, 2).normalized();
          const Patch patch = patch_at_wall(body, into_wall, distance * into_wall, 1e-2);
          ASSERT_LE(patch.error, 0.1) << exponent << ", " << into_wall.transpose() << " at " << distance;
          ASSERT_LE(patch.volume, 8 * 0.4 * 1.1) << exponent << ", " << into_wall.transpose() << " at " << distance;
        }
}

TEST(Patch, OfBoxesIsABox) {
  const double depth = 0.05, offset = 0.7;
  const Patch patch = patch_of({box({1, 1, 1}, {0, 0, 0}), box({1, 1, 1}, {offset, 0, 2 - depth})});
  const double width = 2 - offset, of_edges = 5e-3;
  EXPECT_NEAR(patch.volume, 2 * width * depth, std::max(of_edges, patch.error) * patch.volume);
  EXPECT_NEAR(patch.centre[0], offset / 2, std::max(of_edges, patch.error) * width);
  EXPECT_NEAR(patch.second_moments[0], 1.0 / 3, 2 * std::max(of_edges, patch.error) / 3);
  EXPECT_NEAR(patch.second_moments[1], width * width / 12, 2 * std::max(of_edges, patch.error) / 3);
}

TEST(Patch, IsOnlyThereWhereItWasAskedFor) {
  const Pair pair{ball(1, 0), ball(1, 1.9)};
  EXPECT_FALSE(find_method("auto")->solve(pair, {}, nullptr).patch);
  Want alone{.overlap = false, .normal = false, .points = false, .patch = true};
  const Contact<double> c = find_method("auto")->solve(pair, alone, nullptr);
  EXPECT_TRUE(std::isnan(c.overlap) && c.normal.array().isNaN().all());
  EXPECT_LE(c.patch.value_or(Patch{}).error, 1e-3);
}

TEST(Patch, OfBodiesApartIsEmpty) {
  const Patch patch = patch_of({ball(1, 0), ball(1, 2.1)});
  EXPECT_EQ(patch.volume, 0);
  EXPECT_EQ(patch.area, 0);
  EXPECT_EQ(patch.error, 0);
  EXPECT_TRUE(patch.centre.array().isNaN().all());
}

TEST(Patch, OfBodiesThatMayTouchIsNone) {
  const Patch patch = patch_of({ball(1, 0), ball(1, 2)});
  EXPECT_TRUE(std::isnan(patch.volume));
  EXPECT_TRUE(std::isinf(patch.error));
}

TEST(Patch, PointsHaveItsMoments) {
  const Patch patch = patch_of(generate("superquadric", 5, 3).pair);
  const auto points = points_of(patch);
  Vec3<double> mean = Vec3<double>::Zero();
  Mat3<double> spread = Mat3<double>::Zero();
  for (const Vec3<double>& x : points) {
    mean += (x - patch.centre) / 4;
    spread += (x - patch.centre) * (x - patch.centre).transpose() / 4;
  }
  const double size = patch.second_moments[0], rounding = 1e-15 * patch.centre.norm();  // of the points' coordinates
  EXPECT_LT(mean.norm(), rounding);
  EXPECT_LT((spread - patch.axes * patch.second_moments.asDiagonal() * patch.axes.transpose()).norm(),
            4 * rounding * std::sqrt(size));
  EXPECT_NEAR(patch.axes.determinant(), 1, 1e-14);
  EXPECT_GT(patch.axes.col(2).dot(patch.normal), 0);
}

/// Their axes turn at once: of a square both moments are equal.
TEST(Patch, PointsOfADieOnADieDoNotJump) {
  const auto points_at = [](double tilt) {
    Pair pair;
    pair.body1.shape = pair.body2.shape = {Vec3<double>::Constant(0.5), 8, 8};
    pair.body2.position = {0, 0, 0.99};
    pair.body2.quaternion = {1, tilt / 2, 0, 0};
    return points_of(patch_of(pair));
  };
  const auto flat = points_at(0);
  for (const double tilt : {1e-16, -1e-16, 1e-14, 1e-12, -1e-9, 1e-7, 1e-5, -1e-5}) {
    const auto tilted = points_at(tilt);
    for (std::size_t k = 0; k < flat.size(); ++k) EXPECT_LT((tilted[k] - flat[k]).norm(), 2e-3) << k << " at " << tilt;
  }
}

TEST(Patch, OfLegalExtremesIsNumbersOrNone) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Contact<double> c = solve_for_patch(Extremes(seed).legal_pair());
    if (!c.patch || !std::isfinite(c.patch->error) || c.patch->volume == 0) continue;
    EXPECT_GT(c.patch->volume, 0) << seed;
    EXPECT_TRUE(std::isfinite(c.patch->area) && c.patch->centre.allFinite() && c.patch->second_moments.allFinite())
        << seed;
  }
}

}  // namespace
}  // namespace plumb
