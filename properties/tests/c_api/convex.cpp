// plumb_solve_convex gives what solve_convex gives, to the bit, and refuses what it must.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cfenv>
#include <cmath>
#include <fstream>
#include <map>

#include "properties/generators/families.hpp"
#include "properties/tests/c_api/convex_pairs.hpp"
#include "solver/c/door.hpp"
#include "solver/method/convex.hpp"
#include "solver/plumb.h"

namespace plumb {
namespace {

bool same_bits(const plumb_contact& a, const plumb_contact& b) {
  static_assert(sizeof(plumb_contact) == 120);  // no bytes between its fields
  return std::bit_cast<std::array<std::byte, 120>>(a) == std::bit_cast<std::array<std::byte, 120>>(b);
}

plumb_contact solve_in_c(const plumb_convex_pair& pair) {
  plumb_contact out{};
  EXPECT_EQ(plumb_solve_convex(&pair, nullptr, nullptr, &out), PLUMB_OK);
  return out;
}

TEST(CConvex, IsSolveConvexOfEveryTwoShapes) {
  int converged = 0;
  for_c_pairs(4, [&](const BothPairs& both) {
    const plumb_contact found = solve_in_c(both.c_pair);
    converged += found.status == PLUMB_CONVERGED ? 1 : 0;
    EXPECT_TRUE(same_bits(found, door::c_contact(solve_convex(both.pair, {}, nullptr))));
  });
  EXPECT_GT(converged, 300);  // of 320 that are legal
}

TEST(CConvex, TwoSuperellipsoidsAreThoseOfPlumbSolve) {
  for (std::uint64_t i = 0; i < 60; ++i) {
    Pair pair = generate("hard", 5, i).pair;
    plumb_context context{}, convex_context{};
    for (int step = 0; step < 3; ++step) {
      pair.body2.position += Vec3<double>(1e-3, -2e-3, 1e-3) * size_of(pair);
      const plumb_pair c_pair = door::c_pair(pair);
      const BothPairs both{convex(pair)};
      plumb_contact expected{}, found{};
      ASSERT_EQ(plumb_solve(&c_pair, nullptr, &context, &expected, nullptr), PLUMB_OK);
      ASSERT_EQ(plumb_solve_convex(&both.c_pair, nullptr, &convex_context, &found), PLUMB_OK);
      EXPECT_TRUE(same_bits(found, expected)) << i << " " << step;
    }
  }
}

TEST(CConvex, TheCallersRoundingChangesNothing) {
  for_c_pairs(4, [](const BothPairs& both) {
    const plumb_contact expected = solve_in_c(both.c_pair);
    std::fesetround(FE_UPWARD);
    const OwnedHull hull1 = hull_of(both.pair.body1.shape), hull2 = hull_of(both.pair.body2.shape);
    plumb_convex_pair pair = both.c_pair;
    pair.bodies[0].shape.hull = hull1.get();
    pair.bodies[1].shape.hull = hull2.get();
    const plumb_contact found = solve_in_c(pair);
    EXPECT_EQ(std::fegetround(), FE_UPWARD);
    std::fesetround(FE_TONEAREST);
    EXPECT_TRUE(same_bits(found, expected));
  });
}

template <class... S>
std::map<std::string, int> numbers_by_word(const std::variant<S...>* /*list*/) {
  int next = 0;
  return {{std::string(RowOf<S>::word), next++}...};
}

plumb_convex_pair boxes() {
  return {{{{PLUMB_SHAPE_BOX, nullptr, {1, 1, 1}}, 0, {0, 0, 0}, {1, 0, 0, 0}},
           {{PLUMB_SHAPE_BOX, nullptr, {1, 1, 1}}, 0.25, {0, 0, 2}, {1, 0, 0, 0}}}};
}

TEST(CConvex, OptionsSayWhatIsWanted) {
  const plumb_convex_pair pair = boxes();
  plumb_options options = PLUMB_OPTIONS;
  options.want = PLUMB_WANT_OVERLAP | PLUMB_WANT_PATCH;  // which no convex pair has
  plumb_contact contact{};
  ASSERT_EQ(plumb_solve_convex(&pair, &options, nullptr, &contact), PLUMB_OK);
  EXPECT_EQ(contact.status, PLUMB_CONVERGED);
  EXPECT_EQ(contact.overlap, 0.25);
  EXPECT_TRUE(std::isnan(contact.normal[0]) && std::isnan(contact.points[0][0]));
}

TEST(CConvex, DetailsAreThoseOfSolveConvex) {
  plumb_options options = PLUMB_OPTIONS;
  options.want = PLUMB_WANT_CURVATURE | PLUMB_WANT_DERIVATIVES;
  int compared = 0;
  for_c_pairs(4, [&](const BothPairs& both) {
    plumb_contact contact{};
    plumb_details details{};
    details.size = sizeof details;
    ASSERT_EQ(plumb_solve_convex_details(&both.c_pair, &options, nullptr, &contact, &details), PLUMB_OK);
    const Contact<double> expected = solve_convex(
        both.pair, {.overlap = false, .normal = false, .points = false, .curvature = true, .derivatives = true},
        nullptr);
    if (!expected.derivatives) return;
    ++compared;
    for (std::size_t body = 0; body < 2; ++body) {
      EXPECT_EQ(details.radii[body][0], expected.curvature[body].radius1);
      EXPECT_EQ(details.radii[body][1], expected.curvature[body].radius2);
      EXPECT_EQ(Vec3<double>::Map(details.overlap_by_turn[body]), (*expected.derivatives)[body].overlap_by_turn);
    }
  });
  EXPECT_GT(compared, 300);
  plumb_contact contact{};
  plumb_details details{};
  details.size = 1;
  const plumb_convex_pair pair = boxes();
  EXPECT_EQ(plumb_solve_convex_details(&pair, &options, nullptr, &contact, &details), PLUMB_ERROR_ARGUMENT);
}

TEST(CConvex, WhatCannotBeIsAnError) {
  const plumb_convex_pair pair = boxes();
  plumb_contact contact{};
  EXPECT_EQ(plumb_solve_convex(nullptr, nullptr, nullptr, &contact), PLUMB_ERROR_ARGUMENT);
  EXPECT_EQ(plumb_solve_convex(&pair, nullptr, nullptr, nullptr), PLUMB_ERROR_ARGUMENT);
  plumb_options options = PLUMB_OPTIONS;
  options.iteration_limit = 0;
  EXPECT_EQ(plumb_solve_convex(&pair, &options, nullptr, &contact), PLUMB_ERROR_ARGUMENT);
  options = PLUMB_OPTIONS;
  options.method = "new_cn";
  EXPECT_EQ(plumb_solve_convex(&pair, &options, nullptr, &contact), PLUMB_ERROR_METHOD);
  options.method = "auto";
  EXPECT_EQ(plumb_solve_convex(&pair, &options, nullptr, &contact), PLUMB_OK);
  char text[8];
  EXPECT_EQ(plumb_describe_convex_input(nullptr, text, sizeof text), PLUMB_ERROR_ARGUMENT);
  EXPECT_EQ(plumb_describe_convex_input(&pair, nullptr, 0), PLUMB_ERROR_ARGUMENT);
}

/// Refused with this text.
void expect_refused(const plumb_convex_pair& pair, const std::string& expected) {
  const plumb_contact contact = solve_in_c(pair);
  EXPECT_EQ(contact.status, PLUMB_INVALID_INPUT) << expected;
  EXPECT_TRUE(std::isnan(contact.overlap)) << expected;
  char text[128];
  EXPECT_EQ(plumb_describe_convex_input(&pair, text, sizeof text), PLUMB_OK);
  EXPECT_EQ(text, expected);
}

TEST(CConvex, AnIllegalPairIsAnAnswerAndSaysWhy) {
  const auto refused = [](auto&& change, const char* text) {
    plumb_convex_pair pair = boxes();
    change(pair.bodies[1]);
    expect_refused(pair, text);
  };
  using Body = plumb_convex_body;
  refused([](Body& b) { b.shape.parameters[1] = NAN; },
          "bodies[1].shape.box.half_extents[1]: must be finite and above 0");
  refused([](Body& b) { b.shape.parameters[0] = -1; },
          "bodies[1].shape.box.half_extents[0]: must be finite and above 0");
  refused([](Body& b) { b.swept_radius = -1; }, "bodies[1].shape.sphere_swept.radius: must be finite and not below 0");
  refused([](Body& b) { b.position[2] = INFINITY; }, "bodies[1].position: must be finite");
  refused([](Body& b) { b.quaternion_wxyz[0] = 0; }, "bodies[1].orientation.quaternion_wxyz: must not be zero");
  for (const int kind : {-1, int{std::variant_size_v<Shape>}, 1 << 30})
    refused([&](Body& b) { b.shape.kind = kind; }, "bodies[1].shape.kind: no shape has this number");
  refused([](Body& b) { b.shape.kind = PLUMB_SHAPE_POLYHEDRON; }, "bodies[1].shape.hull: must not be null");
  plumb_convex_pair walls = boxes();
  for (Body& body : walls.bodies) body.shape.kind = PLUMB_SHAPE_HALF_SPACE;
  expect_refused(walls, "bodies[1].shape.half_space: two half-spaces have no lowest overlap");
  char text[8];
  EXPECT_EQ(plumb_describe_convex_input(&walls, text, sizeof text), PLUMB_OK);
  EXPECT_STREQ(text, "bodies[");
  const plumb_convex_pair legal = boxes();
  EXPECT_EQ(plumb_describe_convex_input(&legal, text, sizeof text), PLUMB_OK);
  EXPECT_STREQ(text, "");
}

/// `PLUMB_SHAPE_NAME = number` in the header, the name as cases have it.
TEST(CConvex, EveryShapeHasItsNumber) {
  std::ifstream in(PLUMB_SOURCE_DIR "/solver/plumb.h");
  constexpr std::string_view prefix = "PLUMB_SHAPE_";
  std::map<std::string, int> numbers;
  for (std::string word, sign, number; in >> word;) {
    if (!word.starts_with(prefix) || !(in >> sign >> number) || sign != "=") continue;
    word.erase(0, prefix.size());
    std::ranges::transform(word, word.begin(), [](char c) { return static_cast<char>(std::tolower(c)); });
    numbers[word] = std::stoi(number);
  }
  EXPECT_EQ(numbers, (numbers_by_word(static_cast<const Shape*>(nullptr))));
}

void ball(const void* radius, const double* n, double* x) {
  for (int i = 0; i < 3; ++i) x[i] = *static_cast<const double*>(radius) * n[i];
}
void nothing(const void* /*data*/, const double* /*n*/, double* x) {
  x[0] = NAN;
}
void enclosed_ball(const void* radius, const double* n, double* lower, double* upper) {
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (int i = 0; i < 3; ++i) {
    const double at = *static_cast<const double*>(radius) * n[i] / length, off = 1e-15 * std::abs(at) + 1e-300;
    lower[i] = at - off, upper[i] = at + off;
  }
}

plumb_convex_pair with_foreign(const plumb_foreign* foreign) {
  plumb_convex_pair out = boxes();
  out.bodies[1].shape.kind = PLUMB_SHAPE_FOREIGN;
  out.bodies[1].shape.foreign = foreign;
  out.bodies[1].position[2] = 1.5;
  return out;
}

TEST(CConvex, AForeignShapeIsSolvedAndJudged) {
  const double radius = 0.5;
  plumb_foreign foreign{sizeof foreign, &radius, ball, nullptr, enclosed_ball, 0.5, 0.5};
  const plumb_convex_pair pair = with_foreign(&foreign);
  const plumb_contact contact = solve_in_c(pair);
  EXPECT_EQ(contact.status, PLUMB_CONVERGED);
  EXPECT_NEAR(contact.overlap, 0.25, 1e-14);  // swept by 0.25
  plumb_certificate proved{};
  proved.size = sizeof proved;
  ASSERT_EQ(plumb_certify_convex(&pair, contact.normal, &proved), PLUMB_OK);
  EXPECT_EQ(proved.verdict, PLUMB_OVERLAPPING);
  EXPECT_EQ(proved.global, PLUMB_PROVED);
  EXPECT_EQ(proved.unique, PLUMB_OPEN);
  EXPECT_TRUE(proved.overlap_lower <= 0.25 && 0.25 <= proved.overlap_upper);
  EXPECT_LT(proved.overlap_upper - proved.overlap_lower, 1e-12);
  EXPECT_TRUE(std::string(proved.open).ends_with("not the normal, not the points")) << proved.open;
  foreign.enclose = nullptr;
  ASSERT_EQ(plumb_certify_convex(&pair, nullptr, &proved), PLUMB_OK);
  EXPECT_EQ(proved.verdict, PLUMB_UNDECIDED);
  EXPECT_EQ(proved.global, PLUMB_OPEN);
  EXPECT_EQ(proved.overlap_upper, INFINITY);
  EXPECT_STREQ(proved.open, "nothing is proved: the foreign shape of body 2 has no enclosures");
}

TEST(CConvex, AForeignShapeThatIsNoneIsNamed) {
  const double radius = 0.5;
  plumb_foreign foreign{sizeof foreign, &radius, ball, nullptr, nullptr, 0.25, 0};
  const plumb_convex_pair pair = with_foreign(&foreign);
  const auto says = [&](int status, const char* expected) {
    EXPECT_EQ(solve_in_c(pair).status, status) << expected;
    char text[128];
    EXPECT_EQ(plumb_describe_convex_input(&pair, text, sizeof text), PLUMB_OK);
    EXPECT_STREQ(text, expected);
  };
  says(PLUMB_INVALID_INPUT, "bodies[1].shape.foreign.support: writes a point beyond bounding_radius");
  foreign.bounding_radius = 1;
  foreign.support = nothing;
  says(PLUMB_NOT_FINITE, "bodies[1].shape.foreign.support: writes what is no finite number");
  foreign.size = offsetof(plumb_foreign, support);
  says(PLUMB_INVALID_INPUT, "bodies[1].shape.foreign.bounding_radius: must be finite and above 0");
  expect_refused(with_foreign(nullptr), "bodies[1].shape.foreign: must not be null");
  plumb_certificate proved{};
  proved.size = sizeof proved;
  EXPECT_EQ(plumb_certify_convex(&pair, nullptr, &proved), PLUMB_ERROR_ARGUMENT);
  EXPECT_EQ(plumb_certify_convex(nullptr, nullptr, &proved), PLUMB_ERROR_ARGUMENT);
}

TEST(CConvex, AHullIsOfFinitePoints) {
  const double points[] = {0, 0, 0, 1, 0, 0, 0, INFINITY, 0};
  int error = PLUMB_OK;
  for (const auto& [from, count] : {std::pair(points, 0), std::pair(points, 3), std::pair<const double*, int>({}, 1)}) {
    EXPECT_EQ(plumb_hull_create(from, static_cast<std::size_t>(count), &error), nullptr);
    EXPECT_EQ(error, PLUMB_ERROR_ARGUMENT);
  }
  EXPECT_EQ(plumb_hull_create(points, SIZE_MAX, &error), nullptr);
  EXPECT_EQ(error, PLUMB_ERROR_ARGUMENT);
  EXPECT_EQ(plumb_hull_create(nullptr, 1, nullptr), nullptr);
  for (const std::size_t count : {1, 2}) {
    const OwnedHull hull(plumb_hull_create(points, count, &error));
    EXPECT_NE(hull, nullptr);
    EXPECT_EQ(error, PLUMB_OK);
  }
  plumb_hull_destroy(nullptr);
}

}  // namespace
}  // namespace plumb
