// Witnesses that a contact keeps (solver/contact.hpp): they are points of their bodies wherever these go, they save evaluations, and
// they are no other bodies' points.
#include <gtest/gtest.h>

#include "properties/generators/draft.hpp"
#include "properties/tests/draws.hpp"
#include "solver/method/methods.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {
namespace {

Contact<double> solve(const Pair& pair, const Contact<double>* last) {
  return find_method("auto")->solve(pair, {}, last);
}

/// Two blocks that overlap by a tenth of their distance and turn a little at each step.
struct Motion {
  Pair pair;
  Quaternion turned;

  explicit Motion(std::uint64_t index, double step) {
    Stream stream("witnesses", 1, index);
    Draft draft;
    draft.pair.body1.shape = random_superellipsoid(stream, 5, 8, 40);
    draft.pair.body2.shape = random_superellipsoid(stream, 5, 8, 40);
    draft.pair.body2.quaternion = random_rotation(stream);
    place_on_random_line(stream, draft, stream.log_uniform(3e-2, 3e-1));
    pair = draft.pair;
    turned = turn(random_direction(stream), step);
  }
  void go_on() { pair.body2.quaternion = product(turned, pair.body2.quaternion); }
};

double gauge_of(const Superellipsoid<double>& shape, const Vec3<double>& in_semi_axes) {
  return gauge<double>({Vec3<double>::Ones(), shape.n1, shape.n2}, in_semi_axes);
}

/// However often they are mixed anew.
TEST(Witnesses, AreInTheirBodies) {
  int kept = 0, changed = 0;
  for (std::uint64_t i = 0; i < draws(400, 40); ++i) {
    Motion motion(i, 2e-2);
    Contact<double> last = solve(motion.pair, nullptr);
    for (int step = 0; step < 150; ++step) {
      motion.go_on();
      const Contact<double> found = solve(motion.pair, &last);
      if (found.witnesses) {
        ++kept;
        changed += last.witnesses && found.witnesses->points[0][0] != last.witnesses->points[0][0] ? 1 : 0;
        ASSERT_LE(found.witnesses->count, Witnesses<double>::most);
        const std::array bodies{motion.pair.body1, motion.pair.body2};
        for (std::size_t body = 0; body < 2; ++body)
          for (std::size_t k = 0; k < found.witnesses->count; ++k)
            ASSERT_LE(gauge_of(bodies.at(body).shape, found.witnesses->points.at(body).at(k)), 1 + 1e-14)
                << i << ", step " << step;
      }
      last = found;
    }
  }
  EXPECT_GT(kept, 500);
  EXPECT_GT(changed, 100);
}

TEST(Witnesses, SaveMostOfTheSearch) {
  long with = 0, without = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    Motion motion(i, 1e-3);
    Contact<double> last = solve(motion.pair, nullptr), forgetful = last;
    for (int step = 0; step < 60; ++step) {
      motion.go_on();
      last = solve(motion.pair, &last);
      forgetful.witnesses.reset();
      forgetful = solve(motion.pair, &forgetful);
      if (!last.witnesses || last.status != Status::converged || forgetful.status != Status::converged) continue;
      ASSERT_NEAR(last.overlap, forgetful.overlap, 1e-14 * size_of(motion.pair)) << i << ", step " << step;
      with += last.evaluations;
      without += forgetful.evaluations;
    }
  }
  EXPECT_LT(with * 2, without);
}

/// A tool may keep a contact and change the shape: of rounder bodies the points may lie outside.
TEST(Witnesses, OfOtherShapesAreLeft) {
  int left = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    Motion motion(i, 1e-3);
    Contact<double> last = solve(motion.pair, nullptr);
    if (!last.witnesses) continue;
    motion.pair.body1.shape.n1 = 3;
    const Contact<double> found = solve(motion.pair, &last);
    last.witnesses.reset();
    const Contact<double> alone = solve(motion.pair, &last);
    ASSERT_EQ(found.evaluations, alone.evaluations) << i;
    ASSERT_EQ(found.overlap, alone.overlap) << i;
    if (found.witnesses) {
      ASSERT_EQ(found.witnesses->shapes[0].n1, 3) << i;
    }
    ++left;
  }
  EXPECT_GT(left, 30);
}

}  // namespace
}  // namespace plumb
