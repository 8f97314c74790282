// Any two convex bodies: every answer is judged by bounds and errors in interval arithmetic, which share no code with the solver.
#include <gtest/gtest.h>

#include <limits>

#include "properties/tests/allocations.hpp"
#include "properties/tests/convex/pairs.hpp"
#include "properties/tests/reference/drawn_bodies.hpp"
#include "solver/method/convex.hpp"
#include "solver/method/methods.hpp"
#include "solver/reference/convex_bounds.hpp"

namespace plumb {
namespace {

using reference::bodies_tests::draw_pair;
using reference::bodies_tests::shape_count;

constexpr int judge_cells = 20'000, judge_few_cells = 500;  // where a circle of overlaps is even, all of them are used
constexpr double overlap_floor = 1e-12, touching_floor = 1e-12;  // of the size
/// What the law allows rounding (laws_convex.cpp): of the sizes and the distances.
constexpr double points_floor = 1024 * std::numeric_limits<double>::epsilon();

/// The largest of an answer's errors, each over what it may be; below 1 the answer is right.
double severity(const ConvexPair& pair, const Contact<double>& contact, int cells = judge_cells) {
  const double size = size_of(pair);
  const auto bounds = reference::bound_overlap(pair, contact.normal, cells);
  const auto e = reference::errors_of(pair, contact, bounds);
  const double length = size + std::abs(bounds.upper) + pair.body1.position.lpNorm<Eigen::Infinity>() +
                        pair.body2.position.lpNorm<Eigen::Infinity>();
  const double of_size = std::max({e.overlap / overlap_floor, e.touching1 / touching_floor,
                                   e.touching2 / touching_floor, e.alignment / touching_floor});
  return std::max(of_size / size, std::max(e.point1, e.point2) / (points_floor * length));
}

bool are_half_spaces(std::size_t kind1, std::size_t kind2) {
  return kind1 == half_space_kind && kind2 == half_space_kind;
}

/// Of each two shapes so many pairs.
template <class F>
void for_drawn_pairs(int each, std::uint64_t seed, const F& use) {
  Stream stream("convex pairs", seed, 0);
  for (std::size_t kind1 = 0; kind1 < shape_count; ++kind1)
    for (std::size_t kind2 = 0; kind2 < shape_count; ++kind2)
      for (int i = 0; i < each && !are_half_spaces(kind1, kind2); ++i) {
        SCOPED_TRACE(std::to_string(kind1) + " " + std::to_string(kind2) + " " + std::to_string(i));
        use(draw_pair(kind1, kind2, stream));
      }
}

TEST(Convex, EveryAnswerIsRight) {
  int stalled = 0, asked = 0;
  for_drawn_pairs(6, 1, [&](const ConvexPair& pair) {
    const Contact<double> contact = solve_convex(pair, {}, nullptr);
    ++asked;
    if (contact.status == Status::converged)
      EXPECT_LE(severity(pair, contact), 1);
    else
      ++stalled;
  });
  EXPECT_LE(stalled * 100, asked);
}

TEST(Convex, ExchangedBodiesHaveTheSameContact) {
  for_drawn_pairs(1, 2, [](const ConvexPair& pair) {
    const Contact<double> contact = solve_convex(pair, {}, nullptr),
                          exchanged = solve_convex({pair.body2, pair.body1}, {}, nullptr);
    if (contact.status != Status::converged || exchanged.status != Status::converged) return;
    EXPECT_NEAR(contact.overlap, exchanged.overlap, overlap_floor * size_of(pair));
  });
}

/// What is wrong of a normal is seen to first order in a shift alone: two of three in a row, and the middle of the others.
TEST(Convex, NormalsAreAsExactAsTheirPoints) {
  constexpr double shift = 1e-6, bend = 1e-4, bound = 1e-10;
  int asked = 0, off = 0;
  for_drawn_pairs(3, 6, [&](const ConvexPair& pair) {
    const auto normal = [&](double by) {
      ConvexPair moved = pair;
      moved.body2.position[0] += by;
      return solve_convex(moved, {}, nullptr).normal;
    };
    const Vec3<double> before = normal(-shift), after = normal(shift);
    if (!((after - before).norm() < bend)) return;  // from one face to the next
    ++asked;
    off += (before - 2 * normal(0) + after).norm() < bound ? 0 : 1;
  });
  EXPECT_GT(asked, 250);
  EXPECT_LE(off * 100, asked);
}

TEST(Convex, AUnitOfLengthChangesNoBit) {
  constexpr double unit = 0x1p-40;
  Stream stream("convex pairs", 3, 0);
  for (int i = 0; i < 20; ++i) {
    ConvexPair pair = draw_pair(2, 5, stream);
    const Contact<double> contact = solve_convex(pair, {}, nullptr);
    for (ConvexBody* body : {&pair.body1, &pair.body2}) body->position *= unit, body->swept_radius *= unit;
    auto& cylinder = std::get<Cylinder>(pair.body1.shape);
    cylinder = {cylinder.half_length * unit, cylinder.radius * unit};
    std::get<Box>(pair.body2.shape).half_extents *= unit;
    const Contact<double> small = solve_convex(pair, {}, nullptr);
    EXPECT_EQ(small.overlap, contact.overlap * unit);
    EXPECT_EQ(small.normal, contact.normal);
  }
}

TEST(Convex, ARadiusIsAddedToTheOverlap) {
  for_drawn_pairs(1, 4, [](ConvexPair pair) {
    pair.body1.swept_radius = pair.body2.swept_radius = 0;
    const Contact<double> core = solve_convex(pair, {}, nullptr);
    pair.body1.swept_radius = 0.25;
    pair.body2.swept_radius = 0.5;
    const Contact<double> swept = solve_convex(pair, {}, nullptr);
    if (core.status != Status::converged || swept.status != Status::converged) return;
    EXPECT_NEAR(swept.overlap, core.overlap + 0.75, overlap_floor * size_of(pair));
  });
}

TEST(Convex, PairsOfSuperellipsoidsAreThoseOfAuto) {
  Stream stream("convex pairs", 5, 0);
  for (int i = 0; i < 50; ++i) {
    ConvexPair pair = draw_pair(0, 0, stream);
    pair.body1.swept_radius = pair.body2.swept_radius = 0;
    const auto body = [](const ConvexBody& b) {
      return Body{std::get<Superellipsoid<double>>(b.shape), b.position, b.quaternion};
    };
    const Contact<double> contact = solve_convex(pair, {}, nullptr),
                          known = find_method("auto")->solve({body(pair.body1), body(pair.body2)}, {}, nullptr);
    EXPECT_EQ(contact.status, known.status);
    if (known.status != Status::converged) continue;
    EXPECT_EQ(contact.overlap, known.overlap);
    EXPECT_EQ(contact.normal, known.normal);
    EXPECT_EQ(contact.point1, known.point1);
  }
}

/// What has faces, edges and axes.
std::array<Shape, 8> aligned_shapes() {
  return {Superellipsoid<double>{{1, 1, 0.5}, 2, 2},
          Capsule{1, 0.5},
          Cylinder{1, 0.5},
          Cone{1, 2},
          Frustum{{1, 0.5}, 1},
          Box{{1, 1, 1}},
          Box{{1, 0.5, 0.25}},
          PolySuperellipsoid{{1, 0.5, 0.75, 0.75, 0.25, 1}, 4, 3}};
}

/// Where they may lie on one another.
TEST(Convex, AlignedBodiesAreRight) {
  const std::array<std::array<double, 4>, 4> turns{{{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 1e-9, 0, 0}, {1, 1e-6, 1e-6, 0}}};
  const std::array<Vec3<double>, 6> places{
      {{0, 0, 0}, {0, 0, 1}, {0, 0, 1.5}, {1, 0, 0}, {0.5, 0.25, 0.125}, {1e-9, 0, 2}}};
  for (const Shape& first : aligned_shapes())
    for (const Shape& second : aligned_shapes())
      for (const auto& turn : turns)
        for (const Vec3<double>& place : places) {
          const ConvexPair pair = at(first, second, place, turn);
          const Contact<double> contact = solve_convex(pair, {}, nullptr);
          EXPECT_TRUE(contact.status == Status::converged && severity(pair, contact) <= 1)
              << name(first) << " " << name(second) << " at " << place.transpose() << " turned by " << turn[1];
        }
}

/// Centres on an axis that no coordinate is along: what is off it is rounding, and lies any way.
TEST(Convex, AlignedBodiesAreSolvedHoweverTheyLie) {
  for (const auto& turn : {std::array{1.0, 1.0, 1.0, 0.0}, std::array{4.0, 4.0, 2.0, 3.0}})
    for (const Shape& first : aligned_shapes())
      for (const Shape& second : aligned_shapes())
        for (const double height : {0.0, 0.3, 0.5, 0.7, 1.0, 1.3}) {
          ConvexPair pair = at(first, second, {0, 0, height});
          const double expected = solve_convex(pair, {}, nullptr).overlap;
          pair.body1.quaternion = pair.body2.quaternion = turn;
          pair.body2.position = height * rotation<double>(turn).col(2);
          const double found = solve_convex(pair, {}, nullptr).overlap;
          EXPECT_NEAR(found, expected, overlap_floor) << name(first) << " " << name(second) << " " << height;
        }
}

TEST(Convex, ACubeRestsOnACube) {
  const Contact<double> contact = solve_convex(at(Box{{1, 1, 1}}, Box{{1, 1, 1}}, {0.5, 0.25, 1.875}), {}, nullptr);
  EXPECT_EQ(contact.status, Status::converged);
  EXPECT_EQ(contact.verdict, Verdict::overlapping);
  EXPECT_NEAR(contact.overlap, 0.125, 1e-15);
  EXPECT_NEAR((contact.normal - Vec3<double>::UnitZ()).norm(), 0, 1e-15);
  EXPECT_NEAR(contact.point1[2], 1, 1e-15);
  EXPECT_NEAR(contact.point2[2], 0.875, 1e-15);
  EXPECT_NEAR(contact.contact_point[0], 0.25, 1e-15) << "not the middle of what the faces share";
  EXPECT_NEAR(contact.contact_point[1], 0.125, 1e-15);
}

/// Tilts and turns from rounding to what is seen; above, overlapping and apart, also over the rim.
TEST(Convex, ABoxThatRestsAlmostFlatIsSolved) {
  Stream stream("boxes almost flat", 1, 0);
  for (int i = 0; i < 500; ++i) {
    const auto half = [&] {
      return Vec3<double>(stream.uniform(0.5, 1), stream.uniform(0.5, 1), stream.uniform(0.5, 1));
    };
    const Vec3<double> first = half(), second = half();
    const Vec3<double> tilt = random_direction(stream) * stream.log_uniform(1e-16, 1e-3);
    const Vec3<double> place(stream.uniform(-1, 1), stream.uniform(-1, 1),
                             first[2] + second[2] + stream.uniform(-0.1, 0.05));
    const ConvexPair pair = at(Box{first}, Box{second}, place, {1, tilt[0], tilt[1], tilt[2]});
    const Contact<double> contact = solve_convex(pair, {}, nullptr);
    ASSERT_EQ(contact.status, Status::converged) << i;
    EXPECT_LE(severity(pair, contact), 1) << i;
  }
}

/// All around their axis the overlap may be the same.
TEST(Convex, BodiesOnOneAxisAreSolved) {
  const std::array<Shape, 7> shapes{Superellipsoid<double>{{1, 1, 0.5}, 4, 2},
                                    Capsule{0, 0.75},
                                    Capsule{1, 0.5},
                                    Cylinder{1, 0.5},
                                    Cone{1, 2},
                                    Frustum{{1, 0.5}, 1},
                                    PolySuperellipsoid{{0.5, 0.5, 0.5, 0.5, 0.25, 1}, 3, 2}};
  Stream stream("bodies on one axis", 1, 0);
  for (const Shape& first : shapes)
    for (const Shape& second : shapes)
      for (int i = 0; i < 3; ++i) {
        const ConvexPair pair = at(first, second, {0, 0, i == 0 ? 0.0 : stream.uniform(-2, 2)},
                                   {i % 2 == 0 ? 1.0 : 0.0, 0, i % 2 == 0 ? 0.0 : 1.0, 0});
        const Contact<double> contact = solve_convex(pair, {}, nullptr);
        ASSERT_EQ(contact.status, Status::converged) << name(first) << " " << name(second) << " " << i;
        EXPECT_LE(severity(pair, contact, judge_few_cells), 1) << name(first) << " " << name(second) << " " << i;
      }
}

TEST(Convex, OfAFaceOnAPlaneTheMiddleIsTaken) {
  const Contact<double> box = solve_convex(at(HalfSpace{}, Box{{1, 0.5, 0.25}}, {3, 2, 0.125}), {}, nullptr);
  EXPECT_EQ(box.overlap, 0.125);
  EXPECT_NEAR((box.point2 - Vec3<double>(3, 2, -0.125)).norm(), 0, 1e-15);
  const Contact<double> disc = solve_convex(at(HalfSpace{}, Cylinder{0.25, 1}, {3, 2, 0.125}), {}, nullptr);
  EXPECT_NEAR((disc.point2 - Vec3<double>(3, 2, -0.125)).norm(), 0, 1e-14);
}

TEST(Convex, WhatIsNotAskedForIsNotANumber) {
  const ConvexPair pair = at(Box{{1, 1, 1}}, Capsule{1, 0.5}, {0, 0, 1.5});
  const Contact<double> verdict = solve_convex(pair, {.overlap = false, .normal = false, .points = false}, nullptr);
  EXPECT_EQ(verdict.verdict, Verdict::overlapping);
  EXPECT_TRUE(std::isnan(verdict.overlap));
  EXPECT_TRUE(std::isnan(verdict.normal[0]));
  EXPECT_TRUE(std::isnan(verdict.point1[0]));
}

TEST(Convex, IllegalPairsAreRefused) {
  EXPECT_EQ(solve_convex(at(HalfSpace{}, HalfSpace{}, {0, 0, 0}), {}, nullptr).status, Status::invalid_input);
  EXPECT_EQ(solve_convex(at(Box{{1, -1, 1}}, Cone{1, 1}, {0, 0, 0}), {}, nullptr).status, Status::invalid_input);
  EXPECT_EQ(solve_convex(at(Polyhedron{}, Cone{1, 1}, {0, 0, 0}), {}, nullptr).status, Status::invalid_input);
}

#if !defined(__SANITIZE_ADDRESS__)
TEST(Convex, NothingIsAllocated) {
  std::vector<ConvexPair> pairs;
  for_drawn_pairs(1, 6, [&](const ConvexPair& pair) { pairs.push_back(pair); });
  const auto ball = [](const void* /*data*/, const double* n, double* x) { std::copy_n(n, 3, x); };
  for (const double z : {0.25, 2.5})
    pairs.push_back(at(Box{{1, 1, 1}}, ForeignShape{ball, nullptr, nullptr, nullptr, 1, 1}, {0, 0.125, z}));
  const long before = allocations;
  for (const ConvexPair& pair : pairs) (void)solve_convex(pair, {}, nullptr);
  EXPECT_EQ(allocations, before);
}
#endif

}  // namespace
}  // namespace plumb
