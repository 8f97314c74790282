// The lower bound of curvature over a square of directions: its norm of the plane against 50 digits, the bound itself where
// bodies are special, and the convexity that a search concludes from it.
#include "solver/method/auto/cover/curvature_bound.hpp"

#include <gtest/gtest.h>

#include "properties/generators/draft.hpp"
#include "properties/generators/generators.hpp"
#include "solver/pose.hpp"
#include "solver/reference/real.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::curvature_bound_tests {
namespace {

using Fine = Real50;

/// |(1, r)|_m to the 50th digit, with its derivatives and W(1, r).
struct TruePlaneNorm {
  Fine value, by_first, by_second, weight;

  TruePlaneNorm(const Fine& m, const Fine& r) {
    const Fine sum = 1 + pow(r, m);
    value = pow(sum, 1 / m);
    by_first = pow(value, 1 - m);
    by_second = pow(r / value, m - 1);
    weight = (m - 1) * pow(r, m - 2) * pow(value, 1 - 2 * m);
  }
};

TEST(CurvatureBound, ItsPlaneNormIsTheNormAndItsSecondDerivative) {
  Stream stream("plane norm", 1, 0);
  for (int draw = 0; draw < 1500; ++draw) {
    const double m = stream.chance(0.2) ? 2 : 1 + stream.log_uniform(0.02, 10), r = stream.log_uniform(1e-10, 1e10);
    const detail::PlaneNorm<double> found = detail::plane_norm<double>(m, r);
    const TruePlaneNorm truth{Fine(m), Fine(r)};
    const auto near = [&](double ours, const Fine& exact) {
      const auto expected = static_cast<double>(exact);
      EXPECT_NEAR(ours, expected, 4e-14 * expected) << m << ' ' << r;  // a power of 1e10: 23 m epsilon
    };
    near(found.value, truth.value);
    near(found.by_first, truth.by_first);
    near(found.by_second, truth.by_second);
    near(found.weight, truth.weight);
  }
}

/// The second derivative along r of the norm is the weight: (r dz - z dr)^2 at (1, r) along (0, 1).
TEST(CurvatureBound, TheWeightIsASecondDifference) {
  const Fine step("1e-12");
  for (const double m : {1.02, 1.5, 2.0, 3.0, 11.0})
    for (const double r : {0.1, 0.3, 1.0, 7.0}) {
      const auto norm = [&](const Fine& at) { return TruePlaneNorm(Fine(m), at).value; };
      const Fine second = (norm(r + step) - 2 * norm(Fine(r)) + norm(r - step)) / (step * step);
      const double weight = detail::plane_norm<double>(m, r).weight;
      EXPECT_NEAR(weight, static_cast<double>(second), 1e-10 * weight) << m << ' ' << r;
    }
}

struct Bodies {
  PlacedPair<double> pair;

  explicit Bodies(const Pair& of) : pair(place<double>(of)) {}

  [[nodiscard]] std::array<SupportShape<double>, 2> support_shapes() const {
    const auto of = [](const PlacedBody<double>& body) {
      const Mat3<double> map = body.shape.semi_axes.asDiagonal() * body.rotation.transpose();
      const auto row = [&](int i) { return Vector3<double>::of(map.row(i).transpose()); };
      return SupportShape<double>{
          {row(0), row(1), row(2)}, body.shape.n1 / (body.shape.n1 - 1), body.shape.n2 / (body.shape.n2 - 1)};
    };
    return {of(pair.body1), of(pair.body2)};
  }

  /// |A1 v| + |A2 v|, from shape/'s support function.
  [[nodiscard]] long double support_of(const Vec3<long double>& v) const {
    const auto of = [&](const PlacedBody<double>& body) {
      const Superellipsoid<long double> shape{body.shape.semi_axes.cast<long double>(), body.shape.n1, body.shape.n2};
      return support<long double>(shape, body.rotation.cast<long double>().transpose() * v);
    };
    return of(pair.body1) + of(pair.body2);
  }
};

/// Of square coordinates in [-1, 1].
Vec3<long double> place_in(const DirectionSquare<double>& square, long double a, long double b) {
  const auto wide = [](const Vector3<double>& v) -> Vec3<long double> { return v.eigen().cast<long double>(); };
  return wide(square.n) + square.reach * (a * wide(square.across[0]) + b * wide(square.across[1]));
}

Superellipsoid<double> draw_shape(Stream& stream) {
  Superellipsoid<double> out = random_ellipsoid(stream, 5);
  if (stream.chance(0.8)) {
    out.n1 = generators::draw_exponent(stream);
    out.n2 = generators::draw_exponent(stream);
  }
  return out;
}

Bodies draw_bodies(Stream& stream) {
  Pair pair{{draw_shape(stream), Vec3<double>::Zero(), random_rotation(stream)}, {draw_shape(stream)}};
  pair.body2.quaternion = stream.chance(0.3) ? pair.body1.quaternion : random_rotation(stream);
  return Bodies(pair);
}

DirectionSquare<double> square_about(const Vec3<double>& n, double reach) {
  const Tangent<double> across = tangent_basis<double>(n);
  return {Vector3<double>::of(n), {Vector3<double>::of(across.col(0)), Vector3<double>::of(across.col(1))}, reach};
}

/// f - bound |x|^2 / 2 is convex along any chord of the square: no middle is above the mean of the ends. This asks nothing
/// of derivatives, which are infinite on edges.
TEST(CurvatureBound, NoChordIsStraighterThanIt) {
  Stream stream("chords", 1, 0);
  int positive = 0;
  for (int draw = 0; draw < 200; ++draw) {
    const Bodies bodies = draw_bodies(stream);
    const Vec3<double> n = bodies.pair.body1.rotation * generators::draw_direction(stream);
    const DirectionSquare<double> square = square_about(n.normalized(), stream.log_uniform(1e-3, 0.5));
    const double bound =
        curvature_bound<double>(bodies.support_shapes(), square, std::numeric_limits<double>::infinity());
    positive += bound > 0 ? 1 : 0;
    for (int k = 0; k < 40; ++k) {
      const auto any = [&]() -> long double { return stream.uniform(-1, 1); };
      const Vec3<long double> from = place_in(square, any(), any()), to = place_in(square, any(), any());
      const long double sag = bodies.support_of(from) + bodies.support_of(to) - 2 * bodies.support_of((from + to) / 2);
      // Twice the middle's sag under curvature k over a chord of length l is k l^2 / 4.
      EXPECT_GE(sag, bound * (1 - 1e-9L) * (to - from).squaredNorm() / 4 - 1e-16L) << draw;
    }
  }
  EXPECT_GT(positive, 60);
}

/// The terms of a superellipsoid's second derivative at q, with the derivatives of q along the square's sides.
struct TermsAt {
  std::array<double, 2> inner, outer;  ///< x dy - y dx and r dz - z dr
  double inner_weight, outer_weight;

  TermsAt(const SupportShape<double>& shape, const Vec3<double>& q, const std::array<Vec3<double>, 2>& by) {
    const auto [map, m1, m2] = shape;
    const double x = std::abs(q[0]), y = std::abs(q[1]), z = std::abs(q[2]);
    const double r = std::pow(std::pow(x, m2) + std::pow(y, m2), 1 / m2),
                 norm = std::pow(std::pow(r, m1) + std::pow(z, m1), 1 / m1);
    const double rx = std::copysign(std::pow(x / r, m2 - 1), q[0]), ry = std::copysign(std::pow(y / r, m2 - 1), q[1]);
    for (std::size_t k = 0; k < 2; ++k) {
      inner[k] = q[0] * by[k][1] - q[1] * by[k][0];
      outer[k] = r * by[k][2] - q[2] * (rx * by[k][0] + ry * by[k][1]);
    }
    inner_weight = std::pow(r / norm, m1 - 1) * (m2 - 1) * std::pow(x * y, m2 - 2) / std::pow(r, 2 * m2 - 1);
    outer_weight = (m1 - 1) * std::pow(r * z, m1 - 2) / std::pow(norm, 2 * m1 - 1);
  }
};

/// Weights that are not above the true ones, and vectors within their radius, at every direction of the square.
TEST(CurvatureBound, ItsTermsHoldThoseOfEveryDirection) {
  Stream stream("terms", 1, 0);
  int terms_tried = 0;
  for (int draw = 0; draw < 400; ++draw) {
    const SupportShape<double> shape = draw_bodies(stream).support_shapes()[0];
    if (shape.m1 == 2 && shape.m2 == 2) continue;
    const DirectionSquare<double> square = square_about(random_direction(stream), stream.log_uniform(1e-3, 0.5));
    const detail::CurvatureTerms<double> found = detail::BodyOverSquare<double>(shape, square).terms()[0];
    if (!(found[0].weight > 0)) continue;
    std::array<Vec3<double>, 2> by{(shape.map * square.across[0]).eigen(), (shape.map * square.across[1]).eigen()};
    const Vec3<double> middle = (shape.map * square.n).eigen();
    const bool is_swapped = std::abs(middle[0]) < std::abs(middle[1]);
    for (int k = 0; k < 20; ++k) {
      const double a = square.reach * stream.uniform(-1, 1), b = square.reach * stream.uniform(-1, 1);
      const TermsAt truth(shape, middle + a * by[0] + b * by[1], by);
      const double sign = is_swapped ? -1 : 1;  // of x dy - y dx
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_LE(std::abs(sign * truth.inner[i] - found[0].middle[i]), found[0].radius[i] + 1e-13) << draw;
        EXPECT_LE(std::abs(truth.outer[i] - found[1].middle[i]), found[1].radius[i] + 1e-13) << draw;
      }
      EXPECT_LE(found[0].weight, truth.inner_weight * (1 + 1e-10)) << draw;
      EXPECT_LE(found[1].weight, truth.outer_weight * (1 + 1e-10)) << draw;
      ++terms_tried;
    }
  }
  EXPECT_GT(terms_tried, 1000);
}

/// Of any vectors within the radii the sum of weighted squares has no lower eigenvalue.
TEST(CurvatureBound, TheLeastEigenvalueOfItsTermsIsALowerBound) {
  Stream stream("eigenvalue", 1, 0);
  int positive = 0;
  for (int draw = 0; draw < 1000; ++draw) {
    std::array<detail::CurvatureTerms<double>, 2> bodies{};
    const double radius = stream.log_uniform(1e-6, 0.3);
    for (detail::CurvatureTerms<double>& terms : bodies)
      for (detail::WeightedSquare<double>& term : terms) {
        term.weight = stream.chance(0.4) ? 0 : stream.log_uniform(1e-3, 10);
        for (std::size_t i = 0; i < 2; ++i)
          term.middle[i] = stream.uniform(-1, 1), term.radius[i] = radius * stream.uniform();
      }
    const double bound = detail::least_eigenvalue<double>(bodies[0], bodies[1]);
    positive += bound > 0 ? 1 : 0;
    for (int k = 0; k < 20; ++k) {
      double xx = 0, xy = 0, yy = 0;
      for (const detail::CurvatureTerms<double>& terms : bodies)
        for (const detail::WeightedSquare<double>& term : terms) {
          const auto any = [&](std::size_t i) {
            return term.middle[i] + term.radius[i] * (k < 10 ? stream.sign() : stream.uniform(-1, 1));
          };
          const double x = any(0), y = any(1);
          xx += term.weight * x * x, xy += term.weight * x * y, yy += term.weight * y * y;
        }
      EXPECT_LE(bound, (xx + yy) / 2 - std::hypot((xx - yy) / 2, xy) + 1e-13) << draw;
    }
  }
  EXPECT_GT(positive, 300);
}

/// Two equal ellipsoids along an axis: (b^2 / a) + (b^2 / a) across it, and the least of the two ways across.
TEST(CurvatureBound, OfEllipsoidsAtAnAxisIsTheClosedForm) {
  Pair pair;
  pair.body1.shape.semi_axes = pair.body2.shape.semi_axes = {1.2, 0.9, 0.5};
  const Bodies bodies(pair);
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3<double>& a = pair.body1.shape.semi_axes;
    const double least = std::min(a[(axis + 1) % 3], a[(axis + 2) % 3]), expected = 2 * least * least / a[axis];
    const double found = curvature_bound<double>(bodies.support_shapes(), square_about(Vec3<double>::Unit(axis), 1e-9),
                                                 std::numeric_limits<double>::infinity());
    EXPECT_LE(found, expected * (1 + 1e-12)) << axis;
    EXPECT_GE(found, expected * (1 - 1e-6)) << axis;
  }
}

/// s = f - level |v| on the square that a search takes for convex: again by chords, with levels from shallow to deep.
TEST(CurvatureBound, TheConvexSquareIsConvex) {
  Stream stream("convex square", 1, 0);
  int found = 0, wide = 0, none = 0;
  for (int draw = 0; draw < 300; ++draw) {
    const Bodies bodies = draw_bodies(stream);
    const Vec3<double> n = (bodies.pair.body1.rotation * generators::draw_direction(stream)).normalized();
    const double level = stream.log_uniform(1e-4, 3);
    const DirectionSquare<double> square =
        convex_square<double>(bodies.support_shapes(), Vector3<double>::of(n), level);
    found += square.reach > 0 ? 1 : 0;
    wide += square.reach >= 0.1 ? 1 : 0;
    none += square.reach == 0 ? 1 : 0;
    const auto s = [&](const Vec3<long double>& v) { return bodies.support_of(v) - level * v.norm(); };
    for (int k = 0; k < (square.reach > 0 ? 40 : 0); ++k) {
      const auto any = [&]() -> long double { return stream.uniform(-1, 1); };
      const Vec3<long double> from = place_in(square, any(), any()), to = place_in(square, any(), any());
      EXPECT_LE(2 * s((from + to) / 2), s(from) + s(to) + 1e-16L) << draw << ", level " << level;
    }
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(wide, 20);
  EXPECT_GT(none, 20);
}

/// A sphere's s is (r - level) |v|: convex up to its radius, and no further.
TEST(CurvatureBound, OfSpheresTheConvexSquareIsThereUpToTheirRadius) {
  const Bodies spheres(Pair{});
  const Vector3<double> n{0, 0.6, 0.8};
  EXPECT_GT(convex_square<double>(spheres.support_shapes(), n, 1.5).reach, 0.005);
  EXPECT_GT(convex_square<double>(spheres.support_shapes(), n, 1.999).reach, 0);
  EXPECT_EQ(convex_square<double>(spheres.support_shapes(), n, 2.001).reach, 0);
}

TEST(CurvatureBound, ASquareHoldsItsDirectionsAndNoOthers) {
  Stream stream("square", 1, 0);
  int inside = 0;
  for (int draw = 0; draw < 2000; ++draw) {
    const DirectionSquare<double> square = square_about(random_direction(stream), stream.log_uniform(1e-6, 0.5));
    const double a = stream.uniform(-2, 2), b = stream.uniform(-2, 2), length = stream.log_uniform(1e-3, 1e3);
    const Vec3<double> v = length * place_in(square, a, b).cast<double>();
    const bool expected = std::abs(a) <= 1 && std::abs(b) <= 1;
    EXPECT_EQ(square.holds(Vector3<double>::of(v)), expected) << a << ' ' << b;
    EXPECT_FALSE(square.holds(Vector3<double>::of(Vec3<double>(-v))));
    inside += expected ? 1 : 0;
  }
  EXPECT_GT(inside, 200);
}

}  // namespace
}  // namespace plumb::curvature_bound_tests
