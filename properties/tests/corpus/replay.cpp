// What a replay says of cases as expected, of cases that differ and of those that nothing could judge.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "corpus/json/json_text.hpp"
#include "properties/command/replay_reports.hpp"
#include "properties/tests/corpus/sample.hpp"

namespace plumb {
namespace {

Replayed replayed(const std::string& name) {
  return {"a.jsonl", 1, name, "auto", {}, "", {}, 0};
}

Replayed unjudged(const std::string& name) {
  Replayed out = replayed(name);
  out.unjudged = "not judged: no refinement reached 40 digits";
  return out;
}

Replayed differing(const std::string& name) {
  Replayed out = replayed(name);
  out.differences = {"verdict separated, expected overlapping"};
  return out;
}

const std::array<Replayed, 3> three{replayed("good"), unjudged("open"), differing("bad")};

TEST(Replay, UnjudgedIsNeitherSameNorDifferent) {
  EXPECT_EQ(outcome(unjudged("a")), Outcome::not_judged);
  EXPECT_EQ(replay_line(unjudged("a")),
            "open  auto  none  0  a.jsonl:1  a (not judged: no refinement reached 40 digits)");
  EXPECT_EQ(replay_total(three, true), "3 cases: 1 as expected, 1 differ, 1 not judged");
}

TEST(Replay, WhatNeedsNoReferenceCountsWithoutOne) {
  Replayed found = unjudged("a");
  found.finding = {FindingKind::nonconverged, 1e16, "converges", ""};
  EXPECT_EQ(outcome(found), Outcome::as_expected);
  found.differences = {"finding nonconverged, expected none"};
  EXPECT_EQ(outcome(found), Outcome::differs);
  EXPECT_TRUE(replay_line(found).starts_with("DIFF  auto  nonconverged  10000000000000000  "));
}

TEST(Replay, WhatFailsIsToldByLawAndInDegrees) {
  Replayed found = replayed("a");
  found.angle_error_deg = 1e-14;
  EXPECT_EQ(replay_line(found), "same  auto  none  0  a.jsonl:1  a");
  found.finding = {FindingKind::misaligned, 1e13, "normal", ""};
  found.angle_error_deg = 12.3456;
  EXPECT_EQ(replay_line(found), "same  auto  misaligned  10000000000000  a.jsonl:1  a; law normal; 12.3 deg off");
  found.differences = {"finding misaligned, expected none"};
  EXPECT_TRUE(replay_line(found).ends_with("a; law normal; 12.3 deg off; finding misaligned, expected none"));
  found.angle_error_deg = std::nan("");
  EXPECT_TRUE(replay_line(found).ends_with("a; law normal; finding misaligned, expected none"));
  found.finding = {};
  found.angle_error_deg = 0.5;
  EXPECT_TRUE(replay_line(found).ends_with("a; 0.5 deg off; finding misaligned, expected none"));
}

/// By a method that says what is right of the verdict and nothing else.
Contact<double> overlapping(const Pair&, const Want&, const Contact<double>*) {
  Contact<double> out;
  out.status = Status::converged;
  out.verdict = Verdict::overlapping;
  return out;
}

TEST(Replay, TheReasonIsTheReferencesOwn) {
  // Where the centres coincide both potentials are lowest at one point, and no midway point is defined.
  const Case c = parse_case(sample_with("1.5", "0"), "a.json");
  const Solver solver{"mine", {.problem = Problem::midway}, "", false, false, overlapping};
  const Replayed found = replay_case(c, "a.json", 0, solver);
  EXPECT_EQ(outcome(found), Outcome::not_judged) << replay_line(found);
  EXPECT_EQ(found.unjudged, "not judged: coincident centres");
}

TEST(Replay, UnjudgedIsSkippedInJUnit) {
  const std::string junit = junit_report(three, true);
  EXPECT_NE(junit.find(R"(tests="3" failures="1" errors="0" skipped="1")"), std::string::npos) << junit;
  EXPECT_NE(junit.find(R"(name="open" time="0.000000">
      <skipped message="not judged: no refinement reached 40 digits"/>)"),
            std::string::npos)
      << junit;
  EXPECT_NE(junit.find(R"(name="good" time="0.000000"/>)"), std::string::npos) << junit;
}

TEST(Replay, UnjudgedIsANoteInSarif) {
  const Json results = read_json(sarif_report(three, true))["runs"][0]["results"];
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0]["level"], "note");
  EXPECT_EQ(results[0]["message"]["text"], "open: not judged: no refinement reached 40 digits");
  EXPECT_EQ(results[1]["level"], "error");
}

}  // namespace
}  // namespace plumb
