// Derivatives by poses: against differences of the long double solver, and the identities that a rigid motion leaves.
#include "solver/method/derivatives.hpp"

#include <gtest/gtest.h>

#include "properties/generators/draft.hpp"
#include "properties/generators/families.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

constexpr double step = 1e-5;  // the differences are good to its square

Contact<double> solve_with_derivatives(const Pair& pair) {
  Want want;
  want.derivatives = true;
  return find_method("auto")->solve(pair, want, nullptr);
}

using Derivatives = std::array<PoseDerivative<double>, 2>;

/// Fails where there are none.
Derivatives derivatives_of(const Contact<double>& c) {
  EXPECT_TRUE(c.derivatives);
  return c.derivatives.value_or(Derivatives{});
}

void turn_body(Body& body, const Vec3<double>& by) {
  body.quaternion = product(turn(by.normalized(), by.norm()), body.quaternion);
}

/// (overlap, normal) of the pair after `move` forwards minus that after `move` backwards, over 2 step.
Eigen::Matrix<double, 4, 1> difference(const Pair& pair, const std::function<void(Pair&, double)>& move) {
  const auto answer = [&](double by) {
    Pair moved = pair;
    move(moved, by);
    const Contact<long double> c = find_method_in<long double>("auto")->solve(moved, {}, nullptr);
    Eigen::Matrix<long double, 4, 1> out;
    out << c.overlap, c.normal;
    return out;
  };
  return ((answer(step) - answer(-step)) / (2 * static_cast<long double>(step))).cast<double>();
}

void expect_differences(const Pair& pair, const std::string& name) {
  const Contact<double> c = solve_with_derivatives(pair);
  const Derivatives both = derivatives_of(c);
  for (int body = 0; body < 2; ++body) {
    const PoseDerivative<double>& d = both[static_cast<std::size_t>(body)];
    const double of_normal = 1 + d.normal_by_shift.norm() + d.normal_by_turn.norm();
    const double allowed = 1e-6 * of_normal * of_normal * of_normal;  // the third derivative grows like that
    for (int k = 0; k < 3; ++k) {
      const auto body_of = [body](Pair& p) -> Body& { return body == 0 ? p.body1 : p.body2; };
      const auto shift = difference(pair, [&](Pair& p, double by) { body_of(p).position[k] += by; });
      const auto turned =
          difference(pair, [&](Pair& p, double by) { turn_body(body_of(p), by * Vec3<double>::Unit(k)); });
      EXPECT_NEAR(d.overlap_by_shift[k], shift[0], 1e-9 * of_normal * of_normal) << name;
      EXPECT_NEAR(d.overlap_by_turn[k], turned[0], 1e-9 * of_normal * of_normal) << name;
      EXPECT_LE((d.normal_by_shift.col(k) - shift.tail<3>()).norm(), allowed) << name;
      EXPECT_LE((d.normal_by_turn.col(k) - turned.tail<3>()).norm(), allowed) << name;
    }
  }
}

TEST(Derivatives, AreTheLimitsOfDifferences) {
  for (const std::string_view family : {"spheroid", "ellipsoid", "superquadric"})
    for (std::uint64_t i = 0; i < 12; ++i) {
      Case c = generate(family, 21, i);
      scale(c.pair, 1 / size_of(c.pair));
      expect_differences(c.pair, c.name);
    }
}

/// What is left of (o, n) when all moves together: o stays, n turns with the world.
TEST(Derivatives, ARigidMotionOfBothTurnsTheNormalAlone) {
  int held = 0;
  for (const std::string_view family : {"ellipsoid", "superquadric", "hard"})
    for (std::uint64_t i = 0; i < 60; ++i) {
      const Case c = generate(family, 22, i);
      const Contact<double> contact = solve_with_derivatives(c.pair);
      if (!contact.derivatives) continue;
      const auto& [d1, d2] = *contact.derivatives;
      if (!d1.normal_by_turn.allFinite() || !d2.normal_by_turn.allFinite()) continue;
      if (!d1.normal_by_shift.allFinite() || !d2.normal_by_shift.allFinite())
        continue;  // of bodies of 1e-310: overflow
      ++held;
      const Vec3<double> w(0.3, -0.7, 0.2);
      // About body 1's position, for far from the origin the products would cancel.
      const Vec3<double> shift2 = w.cross(c.pair.body2.position - c.pair.body1.position);
      const double length = size_of(c.pair) + shift2.stableNorm();
      const double noise = 1e-12 * (1 + d2.normal_by_shift.stableNorm() * length + d1.normal_by_turn.stableNorm() +
                                    d2.normal_by_turn.stableNorm());
      const double step = 4 * std::numeric_limits<double>::denorm_min();
      EXPECT_NEAR((d1.overlap_by_turn + d2.overlap_by_turn).dot(w) + d2.overlap_by_shift.dot(shift2), 0,
                  1e-13 * length + step)
          << c.name;
      EXPECT_LE((d1.overlap_by_shift + d2.overlap_by_shift).stableNorm(), 1e-15) << c.name;
      const Vec3<double> turned = (d1.normal_by_turn + d2.normal_by_turn) * w + d2.normal_by_shift * shift2;
      EXPECT_LE((turned - w.cross(contact.normal)).stableNorm(), noise) << c.name;
      EXPECT_LE((d1.normal_by_shift + d2.normal_by_shift).stableNorm() * length, noise) << c.name;
    }
  EXPECT_GT(held, 150);
}

TEST(Derivatives, OfSpheresAreTheProjectionOverTheDistance) {
  Pair pair;
  pair.body1.shape.semi_axes *= 1e-3;
  pair.body2.shape.semi_axes *= 2e-3;
  pair.body2.position << 1.4e-3, -1.2e-3, 2.1e-3;
  const Contact<double> c = solve_with_derivatives(pair);
  const Derivatives both = derivatives_of(c);
  const Mat3<double> projection =
      (Mat3<double>::Identity() - c.normal * c.normal.transpose()) / pair.body2.position.norm();
  EXPECT_LE((both[1].normal_by_shift - projection).norm(), 1e-12 * projection.norm());
  EXPECT_LE(both[1].normal_by_turn.norm(), 1e-14);
  EXPECT_LE((both[0].overlap_by_shift - c.normal).norm(), 1e-15);
}

/// A block's flat face against a sphere: the normal follows the block's turns, and nothing else.
TEST(Derivatives, OfAFlatAreFinite) {
  Pair pair;
  pair.body1.shape = {{1, 1, 1}, 8, 8};
  pair.body2.position << 0, 0, 1.9;
  const Contact<double> c = solve_with_derivatives(pair);
  const Derivatives both = derivatives_of(c);
  const auto& [block, sphere] = both;
  EXPECT_LE(block.normal_by_shift.norm() + sphere.normal_by_shift.norm() + sphere.normal_by_turn.norm(), 1e-13);
  const Vec3<double> w(0.2, -0.5, 0.9);
  EXPECT_LE((block.normal_by_turn * w - w.cross(c.normal)).norm(), 1e-13);
}

/// Of an exponent of 1.05 the point at its edge does not tell the normal: curvature taken there was off by 1e-3.
TEST(Derivatives, AtASharpEdgeAreThoseOfItsNormal) {
  Pair pair;
  pair.body1 = {{{0.46, 0.115, 0.88}, 5, 40}, Vec3<double>::Zero(), {-0.42, 0.34, 0.38, -0.75}};
  pair.body2 = {{{0.44, 0.63, 0.63}, 1.05, 1.05}, {-0.95, -1.13, 0.85}, {-0.72, 0.3, -0.61, 0.16}};
  expect_differences(pair, "an edge");
}

TEST(Derivatives, AreAbsentUnlessAskedFor) {
  const Case c = generate("ellipsoid", 21, 0);
  EXPECT_FALSE(find_method("auto")->solve(c.pair, {}, nullptr).derivatives);
}

}  // namespace
}  // namespace plumb
