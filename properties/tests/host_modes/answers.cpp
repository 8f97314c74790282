// A solve gives the same bits in whatever floating-point mode its host is, leaves it as it found it, and is right.
#include <gtest/gtest.h>

#include <cstring>

#include "properties/doors/columns.hpp"
#include "properties/generators/families.hpp"
#include "properties/laws/laws.hpp"
#include "properties/tests/draws.hpp"
#include "properties/tests/host_modes/drawn.hpp"
#include "solver/batch/batch.hpp"
#include "solver/c/door.hpp"
#include "solver/method/automatic.hpp"
#include "solver/method/methods.hpp"
#include "solver/plumb.h"

namespace plumb {
namespace {

/// NaN included.
bool same_bytes(const void* a, const void* b, std::size_t size) {
  return std::memcmp(a, b, size) == 0;
}

struct Answer {
  plumb_contact contact{};
  plumb_details details{};
  plumb_context context{};

  [[nodiscard]] bool operator==(const Answer& other) const {
    return same_bytes(&contact, &other.contact, sizeof contact) &&
           same_bytes(&context, &other.context, sizeof context) &&
           same_bytes(details.radii, other.details.radii, sizeof details - offsetof(plumb_details, radii));
  }
};

/// Cold, and warm from `last`.
Answer solved(const plumb_pair& pair, const char* method, const plumb_context& last) {
  plumb_options options = PLUMB_OPTIONS;
  options.method = method;
  options.want = PLUMB_WANT_CONTACT | PLUMB_WANT_CURVATURE | PLUMB_WANT_DERIVATIVES;
  Answer out;
  out.details.size = sizeof out.details;
  out.context = last;
  EXPECT_EQ(plumb_solve(&pair, &options, &out.context, &out.contact, &out.details), PLUMB_OK);
  return out;
}

Answer solved_in(const HostMode& mode, const plumb_pair& pair, const char* method, const plumb_context& last = {}) {
  const InHostMode host(mode);
  Answer out = solved(pair, method, last);
  EXPECT_TRUE(host.is_in_force()) << mode.name;
  return out;
}

TEST(AnswersInHostModes, AreTheSameBitsOfEachMethod) {
  for (std::uint64_t i = 0; i < drawn_cases(draws(2000)); ++i) {
    const plumb_pair pair = door::c_pair(scaled_pair(5, i).pair);
    for (const Method& method : methods()) {
      const char* name = method.name.data();
      const Answer expected = solved(pair, name, {});
      EXPECT_TRUE(solved_in(mode_of(i), pair, name) == expected) << i << ", " << name << ", " << mode_of(i).name;
      EXPECT_TRUE(solved_in(mode_of(i), pair, name, expected.context) == solved(pair, name, expected.context))
          << i << ", warm, " << name << ", " << mode_of(i).name;
    }
  }
}

TEST(AnswersInHostModes, AreTheSameBitsBehindTheSolversDoor) {
  for (std::uint64_t i = 0; i < drawn_cases(500); ++i) {
    const Pair pair = scaled_pair(6, i).pair;
    const Contact<double> expected = automatic<double>(pair, {}, nullptr);
    const InHostMode host(mode_of(i));
    const Contact<double> found = automatic<double>(pair, {}, nullptr);
    EXPECT_TRUE(host.is_in_force()) << mode_of(i).name;
    EXPECT_TRUE(same_bytes(&found.overlap, &expected.overlap, sizeof found.overlap)) << i << ", " << mode_of(i).name;
    EXPECT_TRUE(same_bytes(found.normal.data(), expected.normal.data(), sizeof found.normal)) << i;
  }
}

TEST(AnswersInHostModes, OfAutoAreNeverWrong) {
  for (std::uint64_t i = 0; i < drawn_cases(300); ++i) {
    const Pair pair = scaled_pair(7, i).pair;
    const HostMode& mode = mode_of(i);
    const auto solve = [&](const Pair& related) {
      const InHostMode host(mode);
      return find_method("auto")->solve(related, {}, nullptr);
    };
    Judge judge(pair);
    const Finding found = judge.judge(Problem::common_normal, solve(pair), solve, true).finding;
    EXPECT_TRUE(found.kind == FindingKind::none)
        << i << ", " << mode.name << ": " << name(found.kind) << " " << found.detail;
  }
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && same_bytes(a.data(), b.data(), a.size() * sizeof(double));
}

bool same_bits(const ContactColumns& a, const ContactColumns& b) {
  const auto same_vectors = [&](auto ContactColumns::* field) {
    return same_bits((a.*field)[0], (b.*field)[0]) && same_bits((a.*field)[1], (b.*field)[1]) &&
           same_bits((a.*field)[2], (b.*field)[2]);
  };
  return a.status == b.status && a.verdict == b.verdict && same_bits(a.overlap, b.overlap) &&
         same_vectors(&ContactColumns::normal) && same_vectors(&ContactColumns::point1) &&
         same_vectors(&ContactColumns::point2) && same_vectors(&ContactColumns::contact_point) &&
         a.iterations == b.iterations && a.evaluations == b.evaluations;
}

TEST(AnswersInHostModes, OfTheBatchAreTheSameBits) {
  std::vector<Pair> pairs;
  for (std::uint64_t i = 0; i < drawn_cases(300); ++i) pairs.push_back(scaled_pair(8, i).pair);
  const PairColumns columns(pairs);
  for (const InstructionSet set : {InstructionSet::baseline, best_instruction_set()}) {
    ContactColumns expected(pairs.size());
    EXPECT_EQ(solve_batch(columns.arrays(), {}, expected.arrays(), set).error, BatchError::none);
    for (const HostMode& mode : host_modes()) {
      ContactColumns found(pairs.size());
      const InHostMode host(mode);
      EXPECT_EQ(solve_batch(columns.arrays(), {}, found.arrays(), set).error, BatchError::none);
      EXPECT_TRUE(host.is_in_force()) << mode.name;
      EXPECT_TRUE(same_bits(found, expected)) << mode.name << ", " << name(set);
    }
  }
}

TEST(InputInHostModes, WhatIsNoNumberIsRefused) {
  const plumb_pair pair = door::c_pair(generate("ellipsoid", 1, 0).pair);
  const plumb_body_arrays nothing[2] = {};
  const plumb_contact_arrays nowhere{};
  plumb_options spoilt = PLUMB_OPTIONS, endless = PLUMB_OPTIONS;
  spoilt.tolerance = std::numeric_limits<double>::quiet_NaN();
  endless.motion[2] = std::numeric_limits<double>::infinity();
  for (const HostMode& mode : host_modes()) {
    plumb_contact contact;
    const InHostMode host(mode);
    for (const plumb_options* options : {&spoilt, &endless}) {
      EXPECT_EQ(plumb_solve(&pair, options, nullptr, &contact, nullptr), PLUMB_ERROR_ARGUMENT) << mode.name;
      EXPECT_EQ(plumb_solve_batch(0, nothing, options, &nowhere), PLUMB_ERROR_ARGUMENT) << mode.name;
    }
    EXPECT_TRUE(host.is_in_force()) << mode.name;
  }
}

TEST(InputInHostModes, IsAsLegalAsInTheStandardMode) {
  plumb_pair pair = door::c_pair(generate("ellipsoid", 1, 0).pair);
  pair.bodies[0].semi_axes[1] = 4e-320;
  for (double& q : pair.bodies[1].quaternion_wxyz) q *= 1e-310;
  for (const HostMode& mode : host_modes()) {
    const InHostMode host(mode);
    char text[80] = "";
    EXPECT_EQ(plumb_describe_input(&pair, text, sizeof text), PLUMB_OK);
    EXPECT_STREQ(text, "") << mode.name;
  }
}

}  // namespace
}  // namespace plumb
