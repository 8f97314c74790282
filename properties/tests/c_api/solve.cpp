// plumb.h gives what the C++ functions under it give, to the bit, and refuses what it must.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "properties/doors/columns.hpp"
#include "properties/generators/families.hpp"
#include "solver/c/door.hpp"
#include "solver/method/methods.hpp"
#include "solver/plumb.h"

namespace plumb {
namespace {

/// NaN equals NaN; zeros of either sign differ.
bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
template <class T, std::size_t N>
bool same_bits(const T (&a)[N], const T (&b)[N]) {
  for (std::size_t i = 0; i < N; ++i)
    if (!same_bits(a[i], b[i])) return false;
  return true;
}

void expect_same(const plumb_contact& found, const Contact<double>& expected, const std::string& what) {
  const plumb_contact c = door::c_contact(expected);
  EXPECT_EQ(found.status, c.status) << what;
  EXPECT_EQ(found.verdict, c.verdict) << what;
  EXPECT_EQ(found.iterations, c.iterations) << what;
  EXPECT_EQ(found.evaluations, c.evaluations) << what;
  EXPECT_TRUE(same_bits(found.overlap, c.overlap) && same_bits(found.normal, c.normal) &&
              same_bits(found.points, c.points) && same_bits(found.contact_point, c.contact_point))
      << what;
}

/// Body 2 a little further on: the pair of a next step.
Pair moved(Pair pair) {
  pair.body2.position += Vec3<double>(1e-3, -2e-3, 1e-3) * size_of(pair);
  return pair;
}

plumb_options options_for(std::string_view method) {
  plumb_options out = PLUMB_OPTIONS;
  out.method = method.data();
  return out;
}

class CSolve : public testing::TestWithParam<const char*> {};

TEST_P(CSolve, IsEveryMethodsSolveColdAndWarm) {
  for (const Method& method : methods())
    for (std::uint64_t i = 0; i < 40; ++i) {
      const Pair pair = generate(GetParam(), 5, i).pair, next = moved(pair);
      const plumb_pair c_first = door::c_pair(pair), c_next = door::c_pair(next);
      plumb_options options = options_for(method.name);
      plumb_context context{};
      plumb_witnesses witnesses{};
      options.witnesses = &witnesses;
      plumb_contact found{};
      ASSERT_EQ(plumb_solve(&c_first, &options, &context, &found, nullptr), PLUMB_OK);
      const Contact<double> cold = method.solve(pair, {}, nullptr);
      const std::string what = std::string(method.name) + " " + std::to_string(i);
      expect_same(found, cold, what);
      ASSERT_EQ(plumb_solve(&c_next, &options, &context, &found, nullptr), PLUMB_OK);
      expect_same(found, method.solve(next, {}, cold.status == Status::converged ? &cold : nullptr), what + " warm");
    }
}

/// A context holds what `auto` takes from a Contact, to the bit; and a method may take over from another.
TEST(CApi, AContextIsTheLastContact) {
  Pair pair = generate("ellipsoid", 5, 2).pair;
  plumb_context context{};
  plumb_contact found;
  Contact<double> last;
  for (int step = 0; step < 6; ++step) {
    pair.body2.position[0] += 1e-3;
    const plumb_pair c_pair = door::c_pair(pair);
    ASSERT_EQ(plumb_solve(&c_pair, nullptr, &context, &found, nullptr), PLUMB_OK);
    last = find_method("auto")->solve(pair, {}, step == 0 ? nullptr : &last);
    EXPECT_EQ(found.iterations, last.iterations) << step;
    EXPECT_EQ(found.overlap, last.overlap) << step;
  }
  plumb_options options = PLUMB_OPTIONS;
  for (const char* method : {"new_cn", "auto", "minimum_distance", "auto", "original_cn"}) {
    options.method = method;
    const plumb_pair c_pair = door::c_pair(pair);
    ASSERT_EQ(plumb_solve(&c_pair, &options, &context, &found, nullptr), PLUMB_OK);
    EXPECT_EQ(found.status, PLUMB_CONVERGED) << method;
  }
  for (double& state : context.state) state = 7;  // of no solve
  const plumb_pair c_pair = door::c_pair(pair);
  ASSERT_EQ(plumb_solve(&c_pair, nullptr, &context, &found, nullptr), PLUMB_OK);
  EXPECT_EQ(found.overlap, find_method("auto")->solve(pair, {}, nullptr).overlap);
}

/// What proved the last answer, kept beside the context, does what it does for a Contact.
TEST(CApi, WitnessesAreTheLastContacts) {
  int kept = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    Pair pair = generate("superquadric", 5, i).pair;
    plumb_context context{};
    plumb_witnesses witnesses{};
    plumb_options options = PLUMB_OPTIONS;
    options.witnesses = &witnesses;
    plumb_contact found;
    Contact<double> last;
    for (int step = 0; step < 4; ++step) {
      pair = moved(pair);
      const plumb_pair c_pair = door::c_pair(pair);
      ASSERT_EQ(plumb_solve(&c_pair, &options, &context, &found, nullptr), PLUMB_OK);
      last = find_method("auto")->solve(pair, {}, step == 0 || last.status != Status::converged ? nullptr : &last);
      ASSERT_EQ(found.evaluations, last.evaluations) << i << ", step " << step;
      ASSERT_EQ(witnesses.state[0] > 0, last.witnesses.has_value()) << i << ", step " << step;
      kept += last.witnesses ? 1 : 0;
    }
    if (last.witnesses) witnesses.state[1 + i % 36] += 1e-3;  // a point of neither body, perhaps
    const plumb_pair c_pair = door::c_pair(pair);
    ASSERT_EQ(plumb_solve(&c_pair, &options, &context, &found, nullptr), PLUMB_OK);
    if (last.status == Status::converged) last.witnesses.reset();
    ASSERT_EQ(found.evaluations,
              find_method("auto")->solve(pair, {}, last.status == Status::converged ? &last : nullptr).evaluations);
  }
  EXPECT_GT(kept, 10);
}

plumb_body_arrays c_arrays(const BodyArrays& b) {
  return {{b.semi_axes[0].data(), b.semi_axes[1].data(), b.semi_axes[2].data()},
          {b.n1.data(), b.n2.data()},
          {b.position[0].data(), b.position[1].data(), b.position[2].data()},
          {b.quaternion[0].data(), b.quaternion[1].data(), b.quaternion[2].data(), b.quaternion[3].data()}};
}

/// From contexts of single solves a batch goes on as they do, and single solves from its own.
TEST_P(CSolve, AWarmBatchIsWarmSolves) {
  std::vector<Pair> pairs;
  for (std::uint64_t i = 0; i < 150; ++i) pairs.push_back(generate(GetParam(), 6, i).pair);
  std::vector<plumb_context> alone(pairs.size()), together(pairs.size());
  for (int step = 0; step < 5; ++step) {
    for (Pair& pair : pairs) pair.body2.position += Vec3<double>::Constant(1e-3 * size_of(pair));
    const PairColumns columns(pairs);
    const plumb_body_arrays bodies[2] = {c_arrays(columns.arrays().body1), c_arrays(columns.arrays().body2)};
    std::vector<int> status(pairs.size());
    std::vector<double> overlap(pairs.size());
    plumb_contact_arrays contacts{};
    contacts.status = status.data();
    contacts.overlap = overlap.data();
    ASSERT_EQ(plumb_solve_batch_warm(pairs.size(), bodies, nullptr, together.data(), &contacts), PLUMB_OK);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const plumb_pair pair = door::c_pair(pairs[i]);
      plumb_contact found;
      ASSERT_EQ(plumb_solve(&pair, nullptr, &alone[i], &found, nullptr), PLUMB_OK);
      EXPECT_EQ(status[i], found.status) << i;
      const double reach = std::max(size_of(pairs[i]), (pairs[i].body2.position - pairs[i].body1.position).norm());
      if (found.status == PLUMB_CONVERGED) {
        EXPECT_NEAR(overlap[i], found.overlap, 1e-14 * reach) << i;
      }
      if (i % 2 == 0) std::swap(alone[i], together[i]);
    }
  }
}

TEST_P(CSolve, BatchIsSolve) {
  std::vector<Pair> pairs;
  for (std::uint64_t i = 0; i < 1300; ++i) pairs.push_back(generate(GetParam(), 6, i).pair);
  const PairColumns columns(pairs);
  const PairArrays arrays = columns.arrays();
  ContactColumns expected(pairs.size()), found(pairs.size());
  ASSERT_EQ(solve_batch(arrays, {}, expected.arrays()).error, BatchError::none);
  const plumb_body_arrays bodies[2] = {c_arrays(arrays.body1), c_arrays(arrays.body2)};
  const ContactArrays to = found.arrays();
  std::vector<int> status(pairs.size()), verdict(pairs.size());
  plumb_contact_arrays contacts{};
  contacts.status = status.data();
  contacts.verdict = verdict.data();
  contacts.overlap = to.overlap.data();
  contacts.evaluations = to.evaluations.data();
  for (std::size_t k = 0; k < 3; ++k) contacts.normal[k] = to.normal[k].data();
  ASSERT_EQ(plumb_solve_batch(pairs.size(), bodies, nullptr, &contacts), PLUMB_OK);
  const ContactArrays want = expected.arrays();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(status[i], static_cast<int>(want.status[i])) << i;
    EXPECT_EQ(verdict[i], static_cast<int>(want.verdict[i])) << i;
    EXPECT_EQ(to.evaluations[i], want.evaluations[i]) << i;
    EXPECT_TRUE(same_bits(to.overlap[i], want.overlap[i]) && same_bits(to.normal[2][i], want.normal[2][i])) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, CSolve, testing::Values("spheroid", "ellipsoid", "superquadric", "hard"),
                         [](const auto& family) { return std::string(family.param); });

plumb_pair unit_spheres() {
  return {{{{1, 1, 1}, {2, 2}, {0, 0, 0}, {1, 0, 0, 0}}, {{1, 1, 1}, {2, 2}, {1.5, 0, 0}, {1, 0, 0, 0}}}};
}

TEST(CApi, DetailsAreCurvatureAndDerivatives) {
  const plumb_pair pair = unit_spheres();
  plumb_options options = PLUMB_OPTIONS;
  options.want |= PLUMB_WANT_CURVATURE | PLUMB_WANT_DERIVATIVES;
  plumb_contact contact{};
  plumb_details details{};
  details.size = sizeof details;
  ASSERT_EQ(plumb_solve(&pair, &options, nullptr, &contact, &details), PLUMB_OK);
  EXPECT_STREQ(details.method, "auto");
  EXPECT_NEAR(contact.overlap, 0.5, 1e-15);
  for (int body = 0; body < 2; ++body) {
    EXPECT_NEAR(details.radii[body][0], 1, 1e-14);
    EXPECT_NEAR(details.overlap_by_shift[body][0], body == 0 ? 1 : -1, 1e-14);
    // The normal (1, 0, 0) turns towards y as body 2 moves along y, by 1 / (centre distance).
    EXPECT_NEAR(details.normal_by_shift[body][1][1], (body == 0 ? -1 : 1) / 1.5, 1e-14);
    EXPECT_NEAR(details.normal_by_turn[body][1][2], 0, 1e-14);
  }
  ASSERT_EQ(plumb_solve(&pair, nullptr, nullptr, &contact, &details), PLUMB_OK);
  EXPECT_TRUE(std::isnan(details.radii[0][0]) && std::isnan(details.normal_by_turn[1][2][2]));
}

TEST(CApi, APatchIsOneOfTheDetails) {
  const plumb_pair pair = unit_spheres();
  plumb_options options = PLUMB_OPTIONS;
  options.want |= PLUMB_WANT_PATCH;
  plumb_contact contact{};
  plumb_details details{};
  details.size = sizeof details;
  ASSERT_EQ(plumb_solve(&pair, &options, nullptr, &contact, &details), PLUMB_OK);
  const plumb_patch& patch = details.patch;
  const double height = 0.25;  // of each cap, of radius 1
  EXPECT_NEAR(patch.volume, 2 * M_PI * height * height * (3 - height) / 3, 1e-3 * patch.volume);
  EXPECT_NEAR(patch.area, M_PI * height * (2 - height), 1e-3 * patch.area);
  EXPECT_NEAR(patch.normal[0], 1, 1e-6);
  EXPECT_NEAR(patch.centre[0], 0.75, 1e-4);
  EXPECT_NEAR(std::abs(patch.axes[2][0]), 1, 1e-6);
  double mean = 0;
  for (const auto& point : patch.points) mean += point[0] / 4;
  EXPECT_NEAR(mean, patch.centre[0], 1e-15);
  EXPECT_LE(patch.error, 1e-3);
  ASSERT_EQ(plumb_solve(&pair, nullptr, nullptr, &contact, &details), PLUMB_OK);
  EXPECT_TRUE(std::isnan(patch.volume) && std::isinf(patch.error));
}

TEST(CApi, ACallerOfAnOlderHeaderHasFewerFields) {
  const plumb_pair pair = unit_spheres();
  plumb_options options = PLUMB_OPTIONS;
  options.size = offsetof(plumb_options, motion);
  options.motion[0] = NAN;  // beyond what this caller has
  plumb_contact contact{};
  plumb_details details{};
  details.size = offsetof(plumb_details, radii);
  details.radii[0][0] = 7;
  EXPECT_EQ(plumb_solve(&pair, &options, nullptr, &contact, &details), PLUMB_OK);
  EXPECT_EQ(details.radii[0][0], 7);
  EXPECT_STREQ(details.method, "auto");
}

TEST(CApi, MotionIsFirstTouchs) {
  const plumb_pair pair = unit_spheres();
  plumb_options options = options_for("first_touch");
  options.motion[0] = -1;
  options.motion[1] = -1;
  plumb_contact contact{};
  ASSERT_EQ(plumb_solve(&pair, &options, nullptr, &contact, nullptr), PLUMB_OK);
  Pair moving = door::pair_of(pair);
  moving.motion = {-1, -1, 0};
  expect_same(contact, find_method("first_touch")->solve(moving, {}, nullptr), "along (1, 1, 0)");
  EXPECT_GT(contact.normal[1], 0.1);
}

TEST(CApi, WhatCannotBeIsAnError) {
  const plumb_pair pair = unit_spheres();
  plumb_contact contact{};
  EXPECT_EQ(plumb_solve(nullptr, nullptr, nullptr, &contact, nullptr), PLUMB_ERROR_ARGUMENT);
  EXPECT_EQ(plumb_solve(&pair, nullptr, nullptr, nullptr, nullptr), PLUMB_ERROR_ARGUMENT);
  plumb_options options = options_for("nobody");
  EXPECT_EQ(plumb_solve(&pair, &options, nullptr, &contact, nullptr), PLUMB_ERROR_METHOD);
  const auto refused = [&](auto&& change) {
    plumb_options bad = PLUMB_OPTIONS;
    change(bad);
    return plumb_solve(&pair, &bad, nullptr, &contact, nullptr) == PLUMB_ERROR_ARGUMENT;
  };
  EXPECT_TRUE(refused([](plumb_options& o) { o.want = 64; }));
  EXPECT_TRUE(refused([](plumb_options& o) { o.iteration_limit = 0; }));
  EXPECT_TRUE(refused([](plumb_options& o) { o.tolerance = NAN; }));
  EXPECT_TRUE(refused([](plumb_options& o) { o.motion[1] = INFINITY; }));
  EXPECT_TRUE(refused([](plumb_options& o) { o.size = 0; }));
  EXPECT_TRUE(refused([](plumb_options& o) { o.size = offsetof(plumb_options, want) - 1; }));  // a part of a pointer
  plumb_details details{};                                                                     // its size is not set
  EXPECT_EQ(plumb_solve(&pair, nullptr, nullptr, &contact, &details), PLUMB_ERROR_ARGUMENT);
  const plumb_body_arrays nothing[2] = {};
  plumb_contact_arrays contacts{};
  EXPECT_EQ(plumb_solve_batch(1, nothing, nullptr, &contacts), PLUMB_ERROR_ARGUMENT);
  EXPECT_EQ(plumb_solve_batch(0, nothing, nullptr, &contacts), PLUMB_OK);
  options.method = "new_cn";
  EXPECT_EQ(plumb_solve_batch(0, nothing, &options, &contacts), PLUMB_ERROR_METHOD);
}

TEST(CApi, AnIllegalPairIsAnAnswerAndSaysWhy) {
  plumb_pair pair = unit_spheres();
  pair.bodies[1].semi_axes[2] = -1;
  plumb_contact contact{};
  EXPECT_EQ(plumb_solve(&pair, nullptr, nullptr, &contact, nullptr), PLUMB_OK);
  EXPECT_EQ(contact.status, PLUMB_INVALID_INPUT);
  EXPECT_TRUE(std::isnan(contact.overlap));
  char text[128];
  EXPECT_EQ(plumb_describe_input(&pair, text, sizeof text), PLUMB_OK);
  EXPECT_STREQ(text, "bodies[1].shape.superellipsoid.semi_axes[2]: must be finite and above 0");
  EXPECT_EQ(plumb_describe_input(&pair, text, 8), PLUMB_OK);
  EXPECT_STREQ(text, "bodies[");
  const plumb_pair legal = unit_spheres();
  EXPECT_EQ(plumb_describe_input(&legal, text, sizeof text), PLUMB_OK);
  EXPECT_STREQ(text, "");
  EXPECT_EQ(plumb_describe_input(&legal, nullptr, 0), PLUMB_ERROR_ARGUMENT);
}

TEST(CApi, NamesAreTheLibrarysWords) {
  EXPECT_STREQ(plumb_status_name(PLUMB_ITERATION_LIMIT), "iteration_limit");
  EXPECT_STREQ(plumb_status_name(6), "");
  EXPECT_STREQ(plumb_verdict_name(PLUMB_SEPARATED), "separated");
  EXPECT_STREQ(plumb_verdict_name(-1), "");
  EXPECT_STREQ(plumb_error_text(PLUMB_ERROR_METHOD), "there is no such method");
  EXPECT_STREQ(plumb_error_text(PLUMB_OK), "");
  EXPECT_STREQ(plumb_error_text(99), "");
  for (std::size_t i = 0; i < methods().size(); ++i) EXPECT_EQ(plumb_method_name(i), methods()[i].name);
  EXPECT_EQ(plumb_method_name(methods().size()), nullptr);
}

}  // namespace
}  // namespace plumb
