// The lower bound of the overlap around circles of latitude, against the circles themselves.
#include "solver/method/auto/cover/parallel_axes_bound.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

#include "properties/tests/cover/turned_pairs.hpp"

namespace plumb::parallel_axes_tests {
namespace {

using Bound = ParallelAxesBound<double>;

constexpr double turn_once = 2 * std::numbers::pi;

/// Of a pair that was drawn with parallel axes: it has one.
Bound bound_of(const PlacedPair<double>& placed) {
  const auto bound = Bound::of(placed);
  if (!bound) throw std::logic_error("the axes are not parallel");
  return *bound;
}

/// The pair's bound, with a basis of the world that its latitudes are in: the axis towards body 2.
struct Around {
  PlacedPair<double> placed;
  Bound bound;
  Vec3<double> axis;
  Tangent<double> across;

  explicit Around(const Drawn& drawn) : placed(place<double>(drawn.pair)), bound(bound_of(placed)) {
    axis = placed.body1.rotation.col(drawn.axis1).normalized();
    if (axis.dot(placed.body2.centre) < 0) axis = -axis;
    across = tangent_basis<double>(axis);
  }

  [[nodiscard]] Vec3<double> at(const Latitude<double>& latitude, double azimuth) const {
    const Vec3<double> u = across.col(0) * std::cos(azimuth) + across.col(1) * std::sin(azimuth);
    return u * latitude.x + axis * latitude.z;
  }
  /// Of so many directions around a circle, and the azimuth where.
  [[nodiscard]] std::pair<double, double> lowest_on(const Latitude<double>& latitude, int steps) const {
    std::pair<double, double> out{1e300, 0};
    for (int k = 0; k < steps; ++k) {
      const double azimuth = turn_once * k / steps;
      const auto there =
          static_cast<double>(overlap_along(placed, at(latitude, azimuth).normalized().cast<long double>()));
      if (there < out.first) out = {there, azimuth};
    }
    return out;
  }
};

Latitude<double> draw_latitude(Stream& stream) {
  const double angle = stream.uniform(0, std::numbers::pi);
  return Latitude<double>{std::sin(angle), std::cos(angle)};
}

/// A witness of one latitude bounds all directions of all latitudes.
TEST(ParallelAxesBound, NoDirectionIsLowerThanAWitnessSays) {
  int close = 0;
  for (const double tilt : {0.0, 1e-8}) {
    Stream stream("parallel axes", 1, tilt == 0 ? 0 : 1);
    for (int draw = 0; draw < 150; ++draw) {
      const Around around(draw_parallel(stream, tilt));
      const double rounding = 1e-15 * (4 + around.placed.body2.shape.semi_axes.maxCoeff());
      for (int k = 0; k < 10; ++k) {
        const auto witness = around.bound.witness(draw_latitude(stream), 0);
        const Latitude<double> other = draw_latitude(stream);
        const double height = witness.height(other);
        for (int j = 0; j < 12; ++j) {
          const Vec3<double> n = around.at(other, stream.uniform(0, turn_once));
          const auto there = static_cast<double>(overlap_along(around.placed, n.normalized().cast<long double>()));
          EXPECT_GE(there, height - rounding) << draw << ", tilt " << tilt;
          close += there < height + 0.01 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(close, 100);
}

/// At its own latitude a witness's height is the lowest of the circle, along the direction that it tells.
TEST(ParallelAxesBound, AtItsOwnLatitudeItIsTheLowestOfTheCircle) {
  Stream stream("own latitude", 1, 0);
  for (int draw = 0; draw < 100; ++draw) {
    const Around around(draw_parallel(stream, draw % 2 == 0 ? 0 : 1e-8));
    const Latitude<double> at = draw_latitude(stream);
    const auto witness = around.bound.witness(at, 0);
    const double height = witness.height(at);
    EXPECT_GE(around.lowest_on(at, 90).first, height - 2e-14) << draw;
    const Vec3<double> n = around.bound.lowest(at, witness).eigen();
    EXPECT_NEAR(n.norm(), 1, 1e-14) << draw;
    EXPECT_NEAR(static_cast<double>(overlap_along(around.placed, n.normalized().cast<long double>())), height, 2e-14)
        << draw;
    EXPECT_NEAR(n.dot(around.axis), at.z, 1e-7) << draw;  // but for the tilt
  }
}

/// A ball that rolls inside the sum is taken off: of two spheres all but the witness of their middle is theirs.
TEST(ParallelAxesBound, WithoutABallItBoundsTheOverlapOfWhatIsLeft) {
  Stream stream("ball", 1, 0);
  int tried = 0;
  for (int draw = 0; draw < 100; ++draw) {
    Drawn drawn = draw_parallel(stream, 0);
    if (drawn.pair.body1.shape.n1 != 2 || drawn.pair.body2.shape.n1 != 2) continue;
    ++tried;
    const Around around(drawn);
    double ball = 0;  // of ellipsoids the least semi-axis squared over the longest, summed
    for (const PlacedBody<double>* body : {&around.placed.body1, &around.placed.body2}) {
      const Vec3<double>& a = body->shape.semi_axes;
      ball += a.minCoeff() * a.minCoeff() / a.maxCoeff();
    }
    for (int k = 0; k < 20; ++k) {
      const Latitude<double> own = draw_latitude(stream), other = draw_latitude(stream);
      const auto witness = around.bound.witness(own, ball);
      EXPECT_NEAR(witness.height(own), around.bound.witness(own, 0).height(own) - ball, 1e-14);
      const Vec3<double> n = around.at(other, stream.uniform(0, turn_once));
      const auto there = static_cast<double>(overlap_along(around.placed, n.normalized().cast<long double>()));
      EXPECT_GE(there - ball, witness.height(other) - 2e-15 * 5) << draw;
    }
  }
  EXPECT_GT(tried, 20);
}

TEST(ParallelAxesBound, ItsGradientIsTheHeightsDifference) {
  Stream stream("gradient", 1, 0);
  for (int draw = 0; draw < 200; ++draw) {
    const Around around(draw_parallel(stream, draw % 2 == 0 ? 0 : 1e-8));
    const Latitude<double> at = draw_latitude(stream);
    if (at.x < 0.05) continue;
    const auto witness = around.bound.witness(at, 0);
    const Latitude<double> gradient = around.bound.gradient(at, witness);
    const double step = 1e-6;
    const auto slope = [&](double x, double z) {
      const Latitude<double> ahead{at.x + step * x, at.z + step * z}, behind{at.x - step * x, at.z - step * z};
      return (witness.height(ahead) - witness.height(behind)) / (2 * step);
    };
    EXPECT_NEAR(gradient.x, slope(1, 0), 1e-6) << draw;
    EXPECT_NEAR(gradient.z, slope(0, 1), 1e-6) << draw;
  }
}

/// The meridian is the body's: its farthest point is the support point.
TEST(ParallelAxesBound, TheMeridiansPointIsTheSupportPoint) {
  Stream stream("meridian", 1, 0);
  for (int draw = 0; draw < 400; ++draw) {
    const Turned body = draw_turned(stream);
    const Meridian<double> meridian(body.shape, detail::revolution_of(body.shape));
    const Latitude<double> towards = draw_latitude(stream), found = meridian.farthest(towards);
    const bool is_sphere = body.shape.semi_axes[body.axis] == 1 && body.shape.n1 == 2;
    const int along = is_sphere ? 2 : body.axis, across = along == 0 ? 1 : 0;
    Vec3<double> u = Vec3<double>::Zero();
    u[along] = towards.z;
    u[across] = towards.x;
    const Vec3<double> point = support_point<double>(body.shape, u).gradient;
    EXPECT_NEAR(found.z, point[along], 2e-13) << draw;
    EXPECT_NEAR(found.x, point[across], 2e-13) << draw;
  }
}

/// Between latitudes that it calls backwards the opposite of any direction is as low, or lower.
TEST(ParallelAxesBound, BackwardsIsWhereTheOppositeIsAsLow) {
  Stream stream("backwards", 1, 0);
  int backwards = 0;
  for (int draw = 0; draw < 300; ++draw) {
    const Around around(draw_parallel(stream, 0));
    const Latitude<double> from = draw_latitude(stream), to = draw_latitude(stream);
    if (!around.bound.is_backwards(from, to)) continue;
    ++backwards;
    for (int k = 0; k < 20; ++k) {
      const double share = stream.uniform();
      const Latitude<double> between{from.x + share * (to.x - from.x), from.z + share * (to.z - from.z)};
      const Vec3<long double> n = around.at(between, stream.uniform(0, turn_once)).normalized().cast<long double>();
      EXPECT_LE(overlap_along(around.placed, -n), overlap_along(around.placed, n) + 1e-15L) << draw;
    }
  }
  EXPECT_GT(backwards, 30);
}

TEST(ParallelAxesBound, ThereIsOneOfParallelAxesAlone) {
  Stream stream("kinds", 1, 0);
  for (int draw = 0; draw < 50; ++draw) {
    const Drawn coaxial = draw_parallel(stream, 0, true), tilted = draw_parallel(stream, 1e-3);
    const auto of = [](const Pair& pair) { return Bound::of(place<double>(pair)); };
    const Bound bound = bound_of(place<double>(coaxial.pair));
    EXPECT_TRUE(bound.is_coaxial()) << draw;
    EXPECT_FALSE(bound.circle_axis()) << draw;
    EXPECT_FALSE(of(tilted.pair)) << draw;
    Pair triaxial = coaxial.pair;
    triaxial.body1.shape = {{1, 0.8, 0.5}, 2, 2};
    EXPECT_FALSE(of(triaxial)) << draw;
  }
  Pair beside;  // of the world's axes, which are exact
  beside.body1.shape.semi_axes = {1, 1, 2};
  beside.body2.shape.semi_axes = {2, 2, 1};
  beside.body2.position << 1e-3, 0, 0.5;
  const Bound bound = bound_of(place<double>(beside));
  EXPECT_TRUE(bound.is_parallel());
  EXPECT_FALSE(bound.is_coaxial());
}

}  // namespace
}  // namespace plumb::parallel_axes_tests
