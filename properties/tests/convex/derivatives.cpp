// Curvature and derivatives of any two convex bodies: against differences of answers, and forms known in closed form.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "properties/generators/draft.hpp"
#include "properties/tests/convex/pairs.hpp"
#include "properties/tests/reference/drawn_bodies.hpp"
#include "solver/method/convex.hpp"

namespace plumb {
namespace {

using reference::bodies_tests::draw_pair;
using reference::bodies_tests::shape_count;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double step = 1e-6, enough = 1e-6, enough_of_overlap = 1e-7;  // of 1 and of how fast the normal turns

Contact<double> solve_with_all(const ConvexPair& pair) {
  return solve_convex(pair, {.curvature = true, .derivatives = true}, nullptr);
}

using Change = Eigen::Matrix<double, 4, 1>;  // of the overlap and of the normal
using Move = std::function<void(ConvexBody&, double)>;

Move shift_along(int axis) {
  return [axis](ConvexBody& body, double by) { body.position[axis] += by; };
}
Move turn_about(int axis) {
  return [axis](ConvexBody& body, double by) {
    body.quaternion = product(turn(Vec3<double>::Unit(axis), by), body.quaternion);
  };
}

/// Forwards and backwards, over the step. NaN where a moved pair has no answer.
std::array<Change, 2> differences(const ConvexPair& pair, const Contact<double>& contact, int body, const Move& move) {
  const auto change = [&](double by) -> Change {
    ConvexPair moved = pair;
    move(body == 0 ? moved.body1 : moved.body2, by);
    const Contact<double> there = solve_convex(moved, {}, nullptr);
    Change out;
    out << there.overlap - contact.overlap, there.normal - contact.normal;
    return out / by;
  };
  return {change(step), change(-step)};
}

/// How many columns agree, and how many were looked at: those where the differences to both sides are alike.
struct Seen {
  int looked_at = 0, wrong = 0;
};

void look_at(const Change& stated, const std::array<Change, 2>& both, double fastest, Seen& seen) {
  const Change middle = (both[0] + both[1]) / 2;
  const double allowed = enough * (1 + fastest);
  if (!middle.allFinite() || !((both[0] - both[1]).norm() < allowed)) return;  // no answer, or about to leave a face
  ++seen.looked_at;
  const bool is_right =
      std::abs(stated[0] - middle[0]) < enough_of_overlap * (1 + fastest) && (stated - middle).norm() < allowed;
  seen.wrong += is_right ? 0 : 1;
}

Seen look_at(const ConvexPair& pair) {
  Seen seen;
  const Contact<double> contact = solve_with_all(pair);
  if (!contact.derivatives) return seen;
  for (int body = 0; body < 2; ++body) {
    const PoseDerivative<double>& d = (*contact.derivatives)[static_cast<std::size_t>(body)];
    if (!d.normal_by_turn.allFinite()) continue;
    const double fastest = d.normal_by_shift.norm() + d.normal_by_turn.norm();
    for (int k = 0; k < 3; ++k) {
      Change by_shift, by_turn;
      by_shift << d.overlap_by_shift[k], d.normal_by_shift.col(k);
      by_turn << d.overlap_by_turn[k], d.normal_by_turn.col(k);
      look_at(by_shift, differences(pair, contact, body, shift_along(k)), fastest, seen);
      look_at(by_turn, differences(pair, contact, body, turn_about(k)), fastest, seen);
    }
  }
  return seen;
}

TEST(ConvexDerivatives, AreTheLimitsOfDifferences) {
  constexpr int each = 3, columns = 12;
  int pairs = 0, looked_at = 0;
  Stream stream("convex derivatives", 1, 0);
  for (std::size_t kind1 = 0; kind1 < shape_count; ++kind1)
    for (std::size_t kind2 = 0; kind2 < shape_count; ++kind2)
      for (int i = 0; i < each && !(kind1 == half_space_kind && kind2 == half_space_kind); ++i) {
        const Seen seen = look_at(draw_pair(kind1, kind2, stream));
        EXPECT_EQ(seen.wrong, 0) << kind1 << " " << kind2 << " " << i;
        ++pairs;
        looked_at += seen.looked_at;
      }
  EXPECT_GT(looked_at, pairs * columns * 9 / 10);
}

std::array<double, 2> radii_of(const ConvexPair& pair, std::size_t body) {
  const PrincipalCurvature<double> of = solve_with_all(pair).curvature[body];
  return {of.radius1, of.radius2};
}

TEST(ConvexDerivatives, RadiiAreThoseOfTheFeature) {
  const Shape ball = Capsule{0, 0.5}, box = Box{{1, 1, 1}}, cylinder = Cylinder{2, 0.5}, tablet = Tablet{0.5, 1, 0.5};
  using Radii = std::array<double, 2>;
  EXPECT_EQ(radii_of(at(box, ball, {0.1, 0.2, 1.25}), 0), (Radii{infinite, infinite}));  // a face
  EXPECT_EQ(radii_of(at(box, ball, {0.1, 1.25, 1.25}), 0), (Radii{0, infinite}));        // an edge
  EXPECT_EQ(radii_of(at(box, ball, {1.2, 1.25, 1.25}), 0), (Radii{0, 0}));               // a corner
  EXPECT_EQ(radii_of(at(box, ball, {1.2, 1.25, 1.25}), 1), (Radii{0.5, 0.5}));
  EXPECT_EQ(radii_of(at(cylinder, ball, {0.1, 0.2, 2.25}), 0), (Radii{infinite, infinite}));  // its end
  EXPECT_NEAR(radii_of(at(cylinder, ball, {0.6, 0.8, 0.25}), 0)[0], 0.5, 1e-14);              // its side
  EXPECT_EQ(radii_of(at(cylinder, ball, {0.6, 0.8, 0.25}), 0)[1], infinite);
  EXPECT_EQ(radii_of(at(cylinder, ball, {0.75, 0, 2.25}), 0)[0], 0);  // its rim
  EXPECT_NEAR(radii_of(at(cylinder, ball, {0.75, 0, 2.25}), 0)[1], 0.5 * std::sqrt(2), 1e-14);
  EXPECT_EQ(radii_of(at(tablet, ball, {0.1, 0, 1.4}), 0), (Radii{1.25, 1.25}));  // its cap
  EXPECT_EQ(radii_of(at(HalfSpace{}, tablet, {0, 0, 0.9}), 0), (Radii{infinite, infinite}));
  ConvexPair swept = at(box, ball, {1.3, 1.35, 1.35});
  swept.body1.swept_radius = 0.25;
  EXPECT_EQ(radii_of(swept, 0), (Radii{0.25, 0.25}));
}

/// A rim within the end of another cylinder, however the two lie: normals are exact to rounding alone.
TEST(ConvexDerivatives, AFlatEndIsFlatWhereItIsTouchedFromWithin) {
  Stream stream("flat ends", 1, 0);
  int seen = 0;
  for (int i = 0; i < 1000; ++i) {
    ConvexPair pair = at(Cylinder{1, 1}, Cylinder{0.25, 0.25}, {0, 0, 0}, random_rotation(stream));
    pair.body1.quaternion = random_rotation(stream);
    const Mat3<double> turned = rotation<double>(pair.body1.quaternion);
    pair.body2.position = turned * Vec3<double>(stream.uniform(-0.3, 0.3), stream.uniform(-0.3, 0.3), 1.3);
    const Contact<double> contact = solve_with_all(pair);
    if (contact.status != Status::converged || (contact.normal - turned.col(2)).norm() > 1e-9) continue;
    ++seen;
    EXPECT_EQ(contact.curvature[0].radius1, infinite) << i;
  }
  EXPECT_GT(seen, 900);
}

/// Turned about by any angle, two faces on one another have no normal that would follow.
TEST(ConvexDerivatives, OfFacesOnOneAnotherThereIsNone) {
  const Contact<double> contact = solve_with_all(at(Box{{1, 1, 1}}, Box{{1, 1, 1}}, {0.25, 0.125, 1.75}));
  ASSERT_TRUE(contact.derivatives);
  for (const PoseDerivative<double>& by : contact.derivatives.value_or(std::array<PoseDerivative<double>, 2>{})) {
    EXPECT_TRUE(by.normal_by_shift.array().isNaN().all() && by.normal_by_turn.array().isNaN().all());
    EXPECT_TRUE(by.overlap_by_shift.allFinite());
  }
}

TEST(ConvexDerivatives, AreAbsentUnlessAskedFor) {
  const Contact<double> contact = solve_convex(at(Box{{1, 1, 1}}, Capsule{1, 1}, {0, 0, 1.75}), {}, nullptr);
  EXPECT_FALSE(contact.derivatives);
  EXPECT_TRUE(std::isnan(contact.curvature[0].radius1));
}

/// The next step from the last answer is that from none, of bodies that move together and of bodies that jump.
TEST(ConvexWarm, StartsChangeNoAnswer) {
  Stream stream("convex warm", 1, 0);
  for (std::size_t kind1 = 0; kind1 < shape_count; ++kind1)
    for (std::size_t kind2 = 0; kind2 < shape_count; ++kind2) {
      if (kind1 == half_space_kind && kind2 == half_space_kind) continue;
      ConvexPair pair = draw_pair(kind1, kind2, stream);
      Contact<double> last = solve_convex(pair, {}, nullptr);
      for (const double by : {1e-3, 1e-3, 0.3}) {
        pair.body2.position += by * random_direction(stream);
        turn_about(2)(pair.body1, by);
        const Contact<double> cold = solve_convex(pair, {}, nullptr), warm = solve_convex(pair, {}, &last);
        last = warm;
        if (cold.status != Status::converged || warm.status != Status::converged) continue;
        EXPECT_NEAR(warm.overlap, cold.overlap, 1e-12 * size_of(pair)) << kind1 << " " << kind2 << " " << by;
        EXPECT_EQ(warm.verdict, cold.verdict);
      }
    }
}

}  // namespace
}  // namespace plumb
