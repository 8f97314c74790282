// Witnesses that a contact keeps (solver/contact.hpp): they are points of their bodies, they save evaluations, and they are no other
// bodies' points.
#include <gtest/gtest.h>

#include "properties/generators/draft.hpp"
#include "properties/tests/draws.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

Contact<double> solve(const Pair& pair, const Contact<double>* last) {
  return find_method("auto")->solve(pair, {}, last);
}

/// Two bodies that overlap, and turn a little at each step.
struct Motion {
  Pair pair;
  Quaternion turned;

  Motion(std::uint64_t index, double step, double least_exponent, double greatest_exponent) {
    Stream stream("witnesses", 1, index);
    const auto draw = [&] {
      return greatest_exponent == 2 ? random_ellipsoid(stream, 20)
                                    : random_superellipsoid(stream, 5, least_exponent, greatest_exponent);
    };
    Draft draft;
    draft.pair.body1.shape = draw();
    draft.pair.body2.shape = draw();
    draft.pair.body2.quaternion = random_rotation(stream);
    const double shallow = greatest_exponent == 2 ? 0.1 : 0.03;  // where the guard does not know
    place_on_random_line(stream, draft, stream.log_uniform(shallow, 10 * shallow));
    pair = draft.pair;
    turned = turn(random_direction(stream), step);
  }
  void go_on() { pair.body2.quaternion = product(turned, pair.body2.quaternion); }
};
Motion blocks(std::uint64_t index, double step) {
  return {index, step, 8, 40};
}

/// |(x, y)|_m of components >= 0.
double norm(double m, double x, double y) {
  const double large = std::max(x, y);
  return large > 0 ? large * std::pow(std::pow(x / large, m) + std::pow(y / large, m), 1 / m) : 0;
}
/// How far the body reaches along v, body axes.
double support(const Superellipsoid<double>& shape, const Vec3<double>& v) {
  const Vec3<double> q = shape.semi_axes.cwiseProduct(v).cwiseAbs();
  return norm(shape.n1 / (shape.n1 - 1), norm(shape.n2 / (shape.n2 - 1), q[0], q[1]), q[2]);
}
/// Of a ball that rolls inside the body.
double rolling_radius(const Superellipsoid<double>& shape) {
  if (std::min(shape.n1, shape.n2) < 2) return 0;
  const double least = shape.semi_axes.minCoeff();
  return least * least / shape.semi_axes.maxCoeff() / (std::max(shape.n1, shape.n2) - 1);
}

/// By how much a ball about the point is outside of the body, of its size: along many directions, those towards the point among them.
double outside(const Superellipsoid<double>& shape, const Vec3<double>& in_semi_axes, Stream& stream) {
  const Vec3<double> point = shape.semi_axes.cwiseProduct(in_semi_axes);
  double most = 0;
  for (int k = 0; k < 60; ++k) {
    const Vec3<double> v = (k == 0 ? point : point.normalized() * (0.05 * k) + random_direction(stream)).normalized();
    most = std::max(most, point.dot(v) + rolling_radius(shape) - support(shape, v));
  }
  return most / shape.semi_axes.maxCoeff();
}

struct Exponents {
  double least, greatest;
};

class WitnessesOf : public testing::TestWithParam<Exponents> {};

/// The bodies without the balls that roll inside hold them: what the proof takes them for.
TEST_P(WitnessesOf, AreInTheirBodiesLessTheBalls) {
  int kept = 0, changed = 0;
  for (std::uint64_t i = 0; i < draws(400, 60); ++i) {
    Motion motion(i, 2e-2, GetParam().least, GetParam().greatest);
    Stream stream("directions", 1, i);
    Contact<double> last = solve(motion.pair, nullptr);
    for (int step = 0; step < 100; ++step) {
      motion.go_on();
      const Contact<double> found = solve(motion.pair, last.status == Status::converged ? &last : nullptr);
      if (found.witnesses) {
        ++kept;
        changed += last.witnesses && found.witnesses->points[0][0] != last.witnesses->points[0][0] ? 1 : 0;
        ASSERT_LE(found.witnesses->count, Witnesses<double>::most);
        const std::array bodies{motion.pair.body1, motion.pair.body2};
        for (std::size_t body = 0; body < 2; ++body)
          for (std::size_t k = 0; k < found.witnesses->count; ++k)
            ASSERT_LE(outside(bodies.at(body).shape, found.witnesses->points.at(body).at(k), stream), 1e-14)
                << i << ", step " << step;
      }
      last = found;
    }
  }
  EXPECT_GT(kept, 100);
  EXPECT_GT(changed, 10);
}
INSTANTIATE_TEST_SUITE_P(Exponents, WitnessesOf,
                         testing::Values(Exponents{2, 2}, Exponents{1.3, 3}, Exponents{2, 4}, Exponents{8, 40}),
                         [](const auto& of) { return "To" + std::to_string(static_cast<int>(of.param.greatest)); });

TEST(Witnesses, SaveMostOfTheSearch) {
  long with = 0, without = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    Motion motion = blocks(i, 1e-3);
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
    Motion motion = blocks(i, 1e-3);
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
