// What is proved does not depend on the floating-point mode of the host, and holds the truth at any length.
#include <gtest/gtest.h>

#include "corpus/case/case.hpp"
#include "properties/generators/families.hpp"
#include "properties/tests/host_modes/drawn.hpp"
#include "solver/c/door.hpp"
#include "solver/plumb.h"
#include "solver/reference/proof/proof.hpp"
#include "solver/reference/reference.hpp"
#include "solver/reference/search/make_proof.hpp"

namespace plumb {
namespace {

/// The result of `work` in the mode, which must be in force afterwards.
template <class Work>
auto in_mode(const HostMode& mode, const Work& work) {
  const InHostMode host(mode);
  auto out = work();
  EXPECT_TRUE(host.is_in_force()) << mode.name;
  return out;
}

bool have_common(const Bounds& a, const Bounds& b) {
  return a.lower <= b.upper && b.lower <= a.upper;
}

Bounds scaled(const Bounds& bounds, int exponent) {
  return {ldexp(bounds.lower, exponent), ldexp(bounds.upper, exponent)};
}

std::string told(const Bounds& bounds) {
  return "[" + bounds.lower.str(20) + ", " + bounds.upper.str(20) + "]";
}

/// Where both name the only lowest common normal they name the same one.
void expect_same_normal(const Reference& found, const Reference& truth) {
  if (!names_all_lowest(found) || !names_all_lowest(truth) || !found.tied.empty() || !truth.tied.empty()) return;
  const Solution &a = found.common_normal, &b = truth.common_normal;
  EXPECT_LE(static_cast<double>((a.normal - b.normal).norm()), a.normal_radius + b.normal_radius + 1e-45);
}

class ProofsInHostModes : public testing::TestWithParam<Effort> {};

TEST_P(ProofsInHostModes, HoldTheTruthAtAnyLength) {
  const std::uint64_t cases = drawn_cases(GetParam() == Effort::bounds ? 300 : 60);
  for (std::uint64_t i = 0; i < cases; ++i) {
    const ScaledPair drawn = scaled_pair(1, i);
    const Reference truth = find_reference(drawn.unit, Effort::digits);
    const Reference found = in_mode(mode_of(i), [&] { return find_reference(drawn.pair, GetParam()); });
    const Bounds expected = scaled(truth.overlap, drawn.exponent);
    EXPECT_TRUE(have_common(found.overlap, expected))
        << i << ", " << mode_of(i).name << ": " << told(found.overlap) << " for " << told(expected);
    expect_same_normal(found, truth);
  }
}

Bounds kept_bounds(const Case& c) {
  const Json& overlap = c.provenance.at("certificate").at("overlap");
  return {Real50(overlap.at("lower").get<std::string>()), Real50(overlap.at("upper").get<std::string>())};
}

TEST_P(ProofsInHostModes, OfTheFrozenHardCasesHoldTheirCertificates) {
  for (const std::string_view ladder : hard_generators()) {
    CaseReader reader(PLUMB_SOURCE_DIR "/corpus/cases/hard/" + std::string(ladder) + ".jsonl");
    std::uint64_t i = 0;
    for (std::optional<Case> c = reader.next(); c; c = reader.next(), ++i) {
      const Reference found = in_mode(mode_of(i), [&] { return find_reference(c->pair, GetParam()); });
      EXPECT_TRUE(have_common(found.overlap, kept_bounds(*c))) << c->name << ", " << mode_of(i).name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Efforts, ProofsInHostModes, testing::ValuesIn(efforts),
                         [](const auto& effort) { return std::string(name(effort.param)); });

TEST(CertifyInHostModes, HoldsTheTruthAtAnyLength) {
  for (std::uint64_t i = 0; i < drawn_cases(100); ++i) {
    const ScaledPair drawn = scaled_pair(2, i);
    const Reference truth = find_reference(drawn.unit, Effort::digits);
    const plumb_pair pair = door::c_pair(drawn.pair);
    plumb_certificate found{};
    found.size = sizeof found;
    const int error = in_mode(mode_of(i), [&] { return plumb_certify(&pair, &found); });
    ASSERT_EQ(error, PLUMB_OK) << i << ", " << mode_of(i).name;
    const Bounds expected = scaled(truth.overlap, drawn.exponent), bounds{found.overlap_lower, found.overlap_upper};
    EXPECT_TRUE(have_common(bounds, expected))
        << i << ", " << mode_of(i).name << ": " << told(bounds) << " for " << told(expected);
  }
}

TEST(StoredProofsInHostModes, AreMadeAndVerifiedAlike) {
  for (std::uint64_t i = 0; i < 4 * host_modes().size(); ++i) {
    const Pair pair = scaled_pair(3, i).pair;
    const Reference found = find_reference(pair, Effort::proof);
    const auto proof = in_mode(mode_of(i), [&] { return reference::make_proof(pair, found); });
    if (!proof) continue;
    const reference::ProofCheck expected = reference::verify_proof(pair, *proof);
    const reference::ProofCheck checked = in_mode(mode_of(i), [&] { return reference::verify_proof(pair, *proof); });
    EXPECT_EQ(checked.failure, expected.failure) << i << ", " << mode_of(i).name;
    EXPECT_EQ(checked.overlap.lower, expected.overlap.lower) << i << ", " << mode_of(i).name;
    EXPECT_EQ(checked.overlap.upper, expected.overlap.upper) << i << ", " << mode_of(i).name;
  }
}

TEST(OtherProblemsInHostModes, AreSolvedAlike) {
  for (std::uint64_t i = 0; i < 2 * host_modes().size(); ++i) {
    const Pair pair = scaled_pair(4, i).pair;
    for (const Problem problem : {Problem::deepest_points, Problem::midway}) {
      const Solution expected = find_problem_reference(pair, problem);
      const Solution found = in_mode(mode_of(i), [&] { return find_problem_reference(pair, problem); });
      EXPECT_EQ(found.proved, expected.proved) << i << ", " << mode_of(i).name;
      if (expected.proved) {
        EXPECT_EQ(found.overlap, expected.overlap) << i << ", " << mode_of(i).name;
      }
    }
  }
}

}  // namespace
}  // namespace plumb
