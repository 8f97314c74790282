// All stationary pairs: closed forms, the count that Poincare and Hopf ask for, the reference's answer among them, an
// independent evaluation of each, and cases that must not come out complete.
#include "solver/reference/search/stationary.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "properties/generators/families.hpp"
#include "solver/pose.hpp"
#include "solver/reference/interval/direction_box.hpp"
#include "solver/reference/reference.hpp"
#include "solver/reference/search/refine.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {
namespace {

int count(const StationarySet& set, StationaryKind kind) {
  return static_cast<int>(
      std::count_if(set.pairs.begin(), set.pairs.end(), [&](const StationaryPair& p) { return p.kind == kind; }));
}

void expect_bounds_hold(const StationaryPair& pair, const Real80& overlap, double slack) {
  EXPECT_LE(static_cast<double>(pair.overlap_lower - overlap), slack);
  EXPECT_GE(static_cast<double>(pair.overlap_upper - overlap), -slack);
  EXPECT_LT(static_cast<double>(pair.overlap_upper - pair.overlap_lower), 1e-40);
}

TEST(Stationary, TwoSpheresHaveTwo) {
  Pair pair;
  pair.body2.shape.semi_axes.setConstant(2);
  pair.body2.position << 1, 2, 1.5;
  const StationarySet set = find_stationary(pair);
  EXPECT_TRUE(set.complete && set.euler) << set.reason;
  ASSERT_EQ(set.pairs.size(), 2u);
  EXPECT_EQ(set.pairs[0].kind, StationaryKind::minimum);
  EXPECT_EQ(set.pairs[1].kind, StationaryKind::maximum);
  expect_bounds_hold(set.pairs[0], Real80(3) - sqrt(Real80(7.25)), 1e-70);
  expect_bounds_hold(set.pairs[1], Real80(3) + sqrt(Real80(7.25)), 1e-70);
  const Vec3<double> along = pair.body2.position.normalized();
  EXPECT_LT((set.pairs[0].normal.cast<double>() - along).norm(), 1e-15);
  EXPECT_LT((set.pairs[1].normal.cast<double>() + along).norm(), 1e-15);
}

/// With axes in one order o = h1 + h2 is stationary along the axes alone, where it is the sum of the semi-axes.
TEST(Stationary, ConcentricAlignedEllipsoidsHaveSix) {
  Pair pair;
  pair.body1.shape.semi_axes << 1, 2, 3;
  pair.body2.shape.semi_axes << 1.5, 2.5, 4;
  pair.body1.quaternion = pair.body2.quaternion = {0.8, 0.1, 0.3, 0.4};
  const StationarySet set = find_stationary(pair);
  EXPECT_TRUE(set.complete && set.euler) << set.reason;
  ASSERT_EQ(set.pairs.size(), 6u);
  const std::array<StationaryKind, 3> kinds{StationaryKind::minimum, StationaryKind::saddle, StationaryKind::maximum};
  const Mat3<double> axes = rotation<double>(pair.body1.quaternion);
  for (std::size_t i = 0; i < 6; ++i) {
    const int axis = static_cast<int>(i) / 2;
    EXPECT_EQ(set.pairs[i].kind, kinds[i / 2]);
    expect_bounds_hold(set.pairs[i], Real80(pair.body1.shape.semi_axes[axis] + pair.body2.shape.semi_axes[axis]),
                       1e-70);
    EXPECT_LT(axes.col(axis).cross(set.pairs[i].normal.cast<double>()).norm(), 1e-15);
  }
}

/// Normals opposite at both points, the line between the points along them, the points on the surfaces: from the gauge, which
/// the proof does not use.
void expect_stationary(const Pair& pair, const StationaryPair& found) {
  using S = Real50;
  const PlacedPair<S> placed = place<S>(pair);
  const Vec3<S> n = found.normal.cast<S>();
  const Vec3<S> p1 = placed.to_pair_point(found.point1.cast<S>(), pair),
                p2 = placed.to_pair_point(found.point2.cast<S>(), pair);
  const Vec3<S> x1 = placed.body1.to_body(p1), x2 = placed.body2.to_body(p2);
  const double allowed = 1e-30 + 50 * (found.normal_radius + found.points_radius / size_of(pair));
  EXPECT_LT(static_cast<double>(n.cross(p1 - p2).norm()), allowed);
  EXPECT_LT(static_cast<double>(abs(gauge<S>(placed.body1.shape, x1) - S(1))), allowed);
  EXPECT_LT(static_cast<double>(abs(gauge<S>(placed.body2.shape, x2) - S(1))), allowed);
  const Vec3<S> n1 = placed.body1.to_pair_direction(outward_normal<S>(placed.body1.shape, x1));
  const Vec3<S> n2 = placed.body2.to_pair_direction(outward_normal<S>(placed.body2.shape, x2));
  EXPECT_LT(static_cast<double>((n1 - n).norm()), allowed);
  EXPECT_LT(static_cast<double>((n2 + n).norm()), allowed);
}

TEST(Stationary, FamiliesAreComplete) {
  for (const std::string_view family : {"spheroid", "ellipsoid", "superquadric"})
    for (std::uint64_t i = 0; i < 12; ++i) {
      const Case c = generate(family, 5, i);
      SCOPED_TRACE(c.name);
      const StationarySet set = find_stationary(c.pair);
      ASSERT_TRUE(set.complete) << set.reason;
      EXPECT_TRUE(set.euler);
      EXPECT_TRUE(set.open.empty());
      const Reference reference = find_reference(c.pair);
      ASSERT_TRUE(reference.common_normal.solved);
      EXPECT_EQ(set.pairs.front().kind, StationaryKind::minimum);
      expect_bounds_hold(set.pairs.front(), Real80(reference.common_normal.overlap), 1e-40);
      for (const StationaryPair& pair : set.pairs) expect_stationary(c.pair, pair);
    }
}

/// Local solves from all over the sphere end at listed pairs.
TEST(Stationary, NoStartFindsAnother) {
  using namespace reference;
  int arrived = 0;
  for (const std::string_view family : {"spheroid", "ellipsoid", "superquadric"})
    for (std::uint64_t i = 20; i < 26; ++i) {
      const Case c = generate(family, 5, i);
      SCOPED_TRACE(c.name);
      const StationarySet set = find_stationary(c.pair);
      ASSERT_TRUE(set.complete) << set.reason;
      const PlacedPair<double> placed = place<double>(c.pair);
      for (int k = 0; k < 100; ++k) {
        const double z = (k + 0.5) / 50 - 1, turn = 2.399963 * k, r = std::sqrt(1 - z * z);
        const auto local = solve_from_direction<double>(placed, {}, {r * std::cos(turn), r * std::sin(turn), z});
        if (!(local.residual < 1e-13)) continue;
        ++arrived;
        const ChartResidual<double> f = chart_residual<double>(placed, {}, local.at);
        const Vec3<double> normal = f.normal1;
        const double overlap = placed.to_world_length(normal.dot(f.point1 - f.point2)), size = size_of(c.pair);
        EXPECT_TRUE(find_hit(set, normal, overlap, 1e-6, 1e-9 * size).has_value()) << normal.transpose();
      }
    }
  EXPECT_GT(arrived, 1000);
}

/// Flat faces on one another: minima on the faces, second derivatives infinite at them and along the ridges of o.
TEST(Stationary, BlocksHaveManyAndAllAreFound) {
  Pair pair;
  for (Body* body : {&pair.body1, &pair.body2}) {
    body->shape.n1 = body->shape.n2 = 20;
    body->shape.semi_axes << 1, 1.1, 1.2;
  }
  pair.body2.position << 0.1, 0.2, 1.5;
  pair.body2.quaternion = {0.8, 0.1, 0.3, 0.4};
  const StationarySet turned = find_stationary(pair);
  EXPECT_TRUE(turned.complete && turned.euler) << turned.reason;
  EXPECT_GT(count(turned, StationaryKind::minimum), 3);
  pair.body1.quaternion = pair.body2.quaternion;
  const StationarySet alike = find_stationary(pair);
  EXPECT_TRUE(alike.complete && alike.euler) << alike.reason;
}

TEST(Stationary, DeepOverlapHasSeveralMinima) {
  Pair pair;
  pair.body1.shape.semi_axes << 3, 1, 0.5;
  pair.body2.shape.semi_axes << 0.5, 1, 3;
  pair.body2.position << 0.2, 0.1, 0.3;
  const StationarySet set = find_stationary(pair);
  EXPECT_TRUE(set.complete && set.euler) << set.reason;
  EXPECT_GE(count(set, StationaryKind::minimum), 2);
  const StationaryPair& second = set.pairs[1];
  const double overlap = static_cast<double>(second.overlap_lower);
  EXPECT_EQ(find_hit(set, 2 * second.normal.cast<double>(), overlap, 1e-9, 1e-9), 1u);
  EXPECT_FALSE(find_hit(set, second.normal.cast<double>(), overlap + 1e-3, 1e-9, 1e-9).has_value());
  EXPECT_FALSE(find_hit(set, Vec3<double>(0.6, 0.64, 0.48), overlap, 1e-9, 1e-9).has_value());
}

/// Bodies of revolution on one axis: every direction of a cone is stationary. Spheres with one centre: every direction.
TEST(Stationary, AContinuumIsNotComplete) {
  Pair coaxial;
  coaxial.body1.shape.semi_axes << 1, 1, 2;
  coaxial.body2.shape.semi_axes << 1, 1, 3;
  coaxial.body2.position << 0, 0, 0.2;
  for (const Pair& pair : {coaxial, Pair{}}) {
    const StationarySet set = find_stationary(pair);
    EXPECT_FALSE(set.complete);
    EXPECT_NE(set.reason.find("continuum"), std::string::npos);
    EXPECT_FALSE(set.open.empty());
    EXPECT_FALSE(set.unproved.empty());
  }
}

TEST(Stationary, BudgetThatEndsIsReported) {
  const StationarySet set = find_stationary(generate("ellipsoid", 5, 3).pair, {100, 12});
  EXPECT_FALSE(set.complete);
  EXPECT_NE(set.reason.find("budget"), std::string::npos);
}

/// Points and Hessians of directions inside a box lie in what the box is said to hold, at every exponent.
TEST(Stationary, BoxesHoldTheirDirections) {
  using namespace reference;
  for (const std::string_view family : {"ellipsoid", "superquadric"})
    for (std::uint64_t i = 0; i < 40; ++i) {
      const Pair pair = generate(family, 6, i).pair;
      const PlacedPair<Real50> placed = place<Real50>(pair);
      const ChartedPair<Interval18> charted(enclose<Interval18>(pair), {Mat3<double>::Identity()});
      const Cell cell{static_cast<int>(i) % 3, 1, 0.3 - 0.02 * static_cast<double>(i), 0.1, 0.2};
      const auto box = direction_box<Interval18>(charted, box_of<Interval18>(cell, cell.half));
      for (const double s : {-1.0, -0.3, 0.4, 1.0}) {
        const Vec3<Real50> d = cell.at(s, 0.7 * s * s).cast<Real50>();
        const Real50 length = d.norm();
        const auto h = support_hessian<Real50>(placed.body1.shape, placed.body1.to_body_direction(d / length));
        for (int k = 0; k < 9; ++k) {
          const double entry = static_cast<double>(h.hessian(k / 3, k % 3) / length);
          EXPECT_LE(low(box.bodies[0].hessian(k / 3, k % 3)), entry + 1e-12 * std::abs(entry));
          EXPECT_GE(high(box.bodies[0].hessian(k / 3, k % 3)), entry - 1e-12 * std::abs(entry));
        }
        for (int k = 0; k < 3; ++k) {
          EXPECT_LE(low(box.bodies[0].point[k]), static_cast<double>(h.gradient[k]) + 1e-14);
          EXPECT_GE(high(box.bodies[0].point[k]), static_cast<double>(h.gradient[k]) - 1e-14);
        }
      }
    }
}

}  // namespace
}  // namespace plumb
