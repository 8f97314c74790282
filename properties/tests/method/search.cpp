// What the search over directions rests on: the lower bound of curvature, the mixtures of witnesses, the slope along a turn.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "properties/generators/generators.hpp"
#include "solver/method/auto/cover/curvature_bound.hpp"
#include "solver/method/auto/cover/mixture_bound.hpp"
#include "solver/method/auto/cover/rotation_derivative.hpp"
#include "solver/pose.hpp"
#include "solver/shape/superellipsoid.hpp"
#include "solver/shape/tangent.hpp"

namespace plumb {
namespace {

/// Two bodies and a square of directions.
struct Squared {
  PlacedPair<double> pair;
  DirectionSquare<double> square;

  [[nodiscard]] std::array<SupportShape<double>, 2> support_shapes() const {
    const auto of = [](const PlacedBody<double>& body) {
      const Mat3<double> map = body.shape.semi_axes.asDiagonal() * body.rotation.transpose();
      const auto row = [&](int i) { return Vector3<double>::of(map.row(i).transpose()); };
      const auto dual = [](double n) { return n / (n - 1); };
      return SupportShape<double>{{row(0), row(1), row(2)}, dual(body.shape.n1), dual(body.shape.n2)};
    };
    return {of(pair.body1), of(pair.body2)};
  }

  /// The least eigenvalue of the second derivative at v, from shape/'s closed form.
  [[nodiscard]] long double least_curvature(const Vec3<long double>& v) const {
    Eigen::Matrix<long double, 3, 2> sides;
    sides << square.across[0].eigen().cast<long double>(), square.across[1].eigen().cast<long double>();
    Mat3<long double> hessian = Mat3<long double>::Zero();
    for (const PlacedBody<double>* body : {&pair.body1, &pair.body2}) {
      const Superellipsoid<long double> shape{body->shape.semi_axes.cast<long double>(), body->shape.n1,
                                              body->shape.n2};
      const Mat3<long double> rotation = body->rotation.cast<long double>();
      hessian += rotation * support_hessian<long double>(shape, rotation.transpose() * v.normalized()).hessian *
                 rotation.transpose();
    }
    const Eigen::Matrix<long double, 2, 2> across = sides.transpose() * hessian * sides / v.norm();
    if (!across.allFinite()) return std::numeric_limits<long double>::infinity();
    return (across(0, 0) + across(1, 1)) / 2 - std::hypot((across(0, 0) - across(1, 1)) / 2, across(1, 0));
  }

  [[nodiscard]] Vec3<long double> at(long double a, long double b) const {
    const auto wide = [](const Vector3<double>& v) -> Vec3<long double> { return v.eigen().cast<long double>(); };
    return wide(square.n) + square.reach * (a * wide(square.across[0]) + b * wide(square.across[1]));
  }
};

Squared squared(const Pair& pair, const Vec3<double>& own_n, double reach) {
  Squared out{place<double>(pair), {}};
  const Vec3<double> n = (out.pair.body1.rotation * own_n).normalized();
  const Tangent<double> across = tangent_basis<double>(n);
  out.square = {
      Vector3<double>::of(n), {Vector3<double>::of(across.col(0)), Vector3<double>::of(across.col(1))}, reach};
  return out;
}

Squared draw_squared(const Superellipsoid<double>& shape1, const Superellipsoid<double>& shape2, Stream& stream) {
  Pair pair{{shape1, Vec3<double>::Zero(), random_rotation(stream)}, {shape2, Vec3<double>::Zero(), {1, 0, 0, 0}}};
  pair.body2.quaternion = stream.chance(0.3) ? pair.body1.quaternion : random_rotation(stream);
  // Poles, edges and flats of body 1 as often as anywhere.
  const Vec3<double> own_n = generators::draw_direction(stream);
  return squared(pair, own_n, stream.log_uniform(1e-8, 0.5));
}

constexpr double infinite = std::numeric_limits<double>::infinity();

RC_GTEST_PROP(CurvatureBound, IsBelowTheCurvatureAllOverTheSquare, ()) {
  Stream stream("curvature floor", *rc::gen::arbitrary<std::uint64_t>(), 0);
  const Squared drawn = draw_squared(*generators::shape(), *generators::shape(), stream);
  const long double floor = curvature_bound<double>(drawn.support_shapes(), drawn.square, infinite);
  RC_CLASSIFY(floor > 0, "positive");
  for (int i = 0; i < 32; ++i) {
    const bool is_corner = i < 4;
    const long double a = is_corner ? (i % 2 == 0 ? -1 : 1) : stream.uniform(-1, 1),
                      b = is_corner ? (i < 2 ? -1 : 1) : stream.uniform(-1, 1);
    RC_ASSERT(floor <= drawn.least_curvature(drawn.at(a, b)) * (1 + 1e-9L) + 1e-12L);
  }
}

TEST(CurvatureBound, IsTheCurvatureOfASmallSquare) {
  Stream stream("curvature floor", 1, 0);
  int near = 0;
  const int pairs = 400;
  for (int i = 0; i < pairs; ++i) {
    const auto shape = [&] {
      Superellipsoid<double> out = random_ellipsoid(stream, 5);
      out.n1 = stream.log_uniform(1.2, 20);
      out.n2 = stream.log_uniform(1.2, 20);
      return out;
    };
    const Pair pair{{shape(), Vec3<double>::Zero(), random_rotation(stream)},
                    {shape(), Vec3<double>::Zero(), random_rotation(stream)}};
    const Squared drawn = squared(pair, random_direction(stream), 1e-9);
    const double floor = curvature_bound<double>(drawn.support_shapes(), drawn.square, infinite);
    near += floor >= 0.99 * static_cast<double>(drawn.least_curvature(drawn.at(0, 0))) ? 1 : 0;
  }
  EXPECT_GT(near, 0.99 * pairs);
}

TEST(CurvatureBound, PowersOfLargeRatiosDoNotOverflow) {
  for (const float m : {11.0F, 21.0F, 1001.0F})
    for (const float r : {10.0F, 1e4F, 1e17F}) {
      const detail::PlaneNorm<float> at = detail::plane_norm<float>(m, r);
      EXPECT_FLOAT_EQ(at.value, r) << m;
      EXPECT_FLOAT_EQ(at.by_second, 1) << m;
      EXPECT_LT(at.weight, 1e-3F) << m << ' ' << r;
      EXPECT_GE(at.weight, 0) << m << ' ' << r;
    }
}

TEST(CurvatureBound, OfASphereIsItsRadius) {
  const Squared spheres = squared({}, Vec3<double>(1, 2, 3), 1e-8);
  EXPECT_NEAR(curvature_bound<double>(spheres.support_shapes(), spheres.square, infinite), 2, 1e-3);
}

using Mixtures = MixtureBound<double>;

/// The place is a mixture of these with shares whose sum is its z.
constexpr Mixtures::Corners flat_corners{{{-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}}};

double least_height(const Vector3<double>& witness, const Mixtures::Corners& corners) {
  double out = infinite;
  for (const Vector3<double>& corner : corners) out = std::min(out, dot(witness, corner));
  return out;
}

RC_GTEST_PROP(MixtureBound, TheBestMixtureIsAsHighAsThePlaceIsLow, ()) {
  Stream stream("mixture bound", *rc::gen::arbitrary<std::uint64_t>(), 0);
  const std::size_t count = 1 + stream.below(Mixtures::most_witnesses);
  const double size = stream.log_uniform(1e-9, 1e9);
  Mixtures mixtures;
  std::vector<Vector3<double>> witnesses;
  for (std::size_t j = 0; j < count; ++j) {
    // Flat ones, and the same twice, are what a search meets.
    const double flatness = stream.chance(0.5) ? 1 : 1e-6;
    const bool is_known = j > 0 && stream.chance(0.1);
    witnesses.push_back(is_known ? witnesses[stream.below(j)]
                                 : Vector3<double>{stream.uniform(-1, 1) * flatness, stream.uniform(-1, 1) * flatness,
                                                   stream.uniform(-1, 1)} *
                                       size);
    mixtures.add(witnesses.back());
  }
  const auto [mixture, place] = mixtures.solve(flat_corners, -4 * size);  // below all: no early end
  const double value = least_height(mixture, flat_corners), shares = place.z;
  double at_place = -infinite;
  for (const Vector3<double>& witness : witnesses) {
    RC_ASSERT(value >= least_height(witness, flat_corners) - 1e-9 * size);
    at_place = std::max(at_place, dot(witness, place) / shares);
  }
  RC_ASSERT(std::abs(place.x) <= shares * (1 + 1e-12) && std::abs(place.y) <= shares * (1 + 1e-12));
  RC_ASSERT(std::abs(value - at_place) <= 1e-9 * size);  // no mixture is higher there, nor any place lower
}

RC_GTEST_PROP(MixtureBound, EndsEarlyWhereNoMixtureIsAsHighAsWanted, ()) {
  Stream stream("early end", *rc::gen::arbitrary<std::uint64_t>(), 0);
  Mixtures mixtures;
  for (std::size_t j = 0; j < 8; ++j) mixtures.add(Vector3<double>::of(random_direction(stream)));
  const double value = least_height(mixtures.solve(flat_corners, -4).mixture, flat_corners);
  const double wanted = value + stream.signed_log_uniform(1e-6, 1);
  const auto [mixture, place] = mixtures.solve(flat_corners, wanted);
  RC_ASSERT((least_height(mixture, flat_corners) >= wanted) == (value >= wanted));
  if (value < wanted) RC_ASSERT(!mixtures.reaches(wanted * place.z / length(place), place));
}

TEST(MixtureBound, TwoWitnessesExcludeAGrooveThatNeitherDoes) {
  // o = |x| + 0.1 over the directions (x, y, 1): a groove along x = 0.
  Mixtures mixtures;
  const Vector3<double> left{-1, 0, 0.1}, right{1, 0, 0.1};
  mixtures.add(left);
  mixtures.add(right);
  EXPECT_LT(least_height(left, flat_corners), 0);
  EXPECT_LT(least_height(right, flat_corners), 0);
  EXPECT_NEAR(least_height(mixtures.solve(flat_corners, 0).mixture, flat_corners), 0.1, 1e-12);
}

/// A body of revolution about x, y or z; the axis is that of `axis`.
struct Turned {
  Superellipsoid<double> shape;
  int axis;
};

Turned draw_turned(Stream& stream) {
  Turned out{{}, static_cast<int>(stream.below(3))};
  out.shape.semi_axes[out.axis] = stream.log_uniform(0.05, 20);
  if (out.axis == 2 && stream.chance(0.7)) out.shape.n1 = generators::draw_exponent(stream);
  return out;
}

/// The slope of o at n as n turns about body 1's axis, from shape/'s support points.
long double slope_along_turn(const PlacedPair<double>& pair, int axis, const Vec3<long double>& n) {
  Vec3<long double> gradient = -pair.body2.centre.cast<long double>();
  for (const PlacedBody<double>* body : {&pair.body1, &pair.body2}) {
    const Superellipsoid<long double> shape{body->shape.semi_axes.cast<long double>(), body->shape.n1, body->shape.n2};
    const Mat3<long double> rotation = body->rotation.cast<long double>();
    gradient += rotation * support_point<long double>(shape, rotation.transpose() * n).gradient;
  }
  return pair.body1.rotation.col(axis).cast<long double>().cross(n).dot(gradient);
}

RC_GTEST_PROP(RotationDerivative, HasTheSignThatItSaysAllOverTheCell, ()) {
  Stream stream("turn slope", *rc::gen::arbitrary<std::uint64_t>(), 0);
  const Turned body1 = draw_turned(stream), body2 = draw_turned(stream);
  RC_PRE(body1.shape.semi_axes != Vec3<double>::Ones());
  Pair pair{{body1.shape, Vec3<double>::Zero(), random_rotation(stream)}, {body2.shape, random_direction(stream), {}}};
  // Nearly coaxial and far from it.
  const Mat3<double> own = place<double>(Pair{pair.body1, pair.body1}).body1.rotation;
  const double tilt = stream.log_uniform(1e-12, 1);
  const Vec3<double> axis1 = own.col(body1.axis), axis2 = (axis1 + tilt * random_direction(stream)).normalized();
  const Vec3<double> from = Vec3<double>::Unit(body2.axis);
  const Vec3<double> turn = from.cross(axis2);
  pair.body2.quaternion = {1 + from.dot(axis2), turn[0], turn[1], turn[2]};
  pair.body2.position = axis1 * stream.uniform(-1, 1) + tilt * random_direction(stream);
  const PlacedPair<double> placed = place<double>(pair);
  const auto slope = RotationDerivative<double>::of(placed);
  if (!slope) RC_FAIL("bodies of revolution without an axis");
  const Vec3<double> middle = random_direction(stream);
  const Tangent<double> across = tangent_basis<double>(middle);
  const double half = stream.log_uniform(1e-4, 0.5);
  Mixtures::Corners corners;
  const auto at = [&](double a, double b) {
    return (middle + half * (across.col(0) * a + across.col(1) * b)).normalized().eval();
  };
  for (std::size_t k = 0; k < 4; ++k) corners[k] = Vector3<double>::of(at(k % 2 == 0 ? -1 : 1, k < 2 ? -1 : 1));
  const bool has_one_sign = slope->has_one_sign(corners);
  RC_CLASSIFY(has_one_sign, "one sign");
  if (!has_one_sign) return;
  const auto of = [&](const Vec3<double>& n) { return slope_along_turn(placed, body1.axis, n.cast<long double>()); };
  const bool is_positive = of(middle) > 0;
  for (int i = 0; i < 32; ++i) RC_ASSERT((of(at(stream.uniform(-1, 1), stream.uniform(-1, 1))) > 0) == is_positive);
}

TEST(RotationDerivative, IsNoneOfBodiesThatAreNotOfRevolution) {
  Pair pair;
  pair.body1.shape.semi_axes = {1, 2, 3};
  EXPECT_FALSE(RotationDerivative<double>::of(place<double>(pair)).has_value());
}

}  // namespace
}  // namespace plumb
