// The recorder and the laws on the same answers: what it calls wrong is wrong, and it sees most of what is.
#include <cmath>

#include "properties/tests/draws.hpp"
#include "properties/tests/recorder/sample.hpp"

namespace plumb {
namespace {

class RecorderAgrees : public Folder, public testing::WithParamInterface<std::string_view> {};

TEST_P(RecorderAgrees, NoFalseAlarmOnAnyAnswerOfAuto) {
  plumb_recorder_options exact = plumb_recorder_defaults();
  exact.tolerance = 0;
  open(exact);
  for (std::uint64_t i = 0; i < draws(26000); ++i) {
    const Case c = generate(GetParam(), 11, i);
    const Contact<double> contact = answer_of("auto", c.pair);
    if (contact.status != Status::converged) continue;
    const int found = record(recorder_, c.pair, contact);
    ASSERT_EQ(found, 0) << c.name << ": " << plumb_recorder_finding_name(found);
  }
}

/// Without points and normal: nothing but the verdict.
TEST_P(RecorderAgrees, NoFalseAlarmOnAnyVerdictOfAuto) {
  plumb_recorder_options bare = plumb_recorder_defaults();
  bare.lacks = PLUMB_LACKS_OVERLAP | PLUMB_LACKS_NORMAL | PLUMB_LACKS_POINTS;
  bare.tolerance = 0;
  open(bare);
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Case c = generate(GetParam(), 12, i);
    const Contact<double> contact = answer_of("auto", c.pair);
    if (contact.status != Status::converged || contact.verdict == Verdict::undecided) continue;
    const int found = record(recorder_, c.pair, contact);
    ASSERT_EQ(found, 0) << c.name << ": " << plumb_recorder_finding_name(found);
  }
  EXPECT_LT(counts().not_judged, counts().calls * 2 / 3);
}

/// Counts of one family over the methods that are often wrong.
struct Shared {
  int wrong = 0, seen = 0;
};

Shared compare(plumb_recorder* recorder, std::string_view family, std::string_view method) {
  Shared out;
  for (std::uint64_t i = 0; i < 25; ++i) {
    const Case c = generate(family, 13, i);
    const Contact<double> contact = answer_of(method, c.pair);
    if (contact.status != Status::converged) continue;
    Judge judge(c.pair);
    const FindingKind law = judge.judge(Problem::common_normal, contact).finding.kind;
    const int found = record(recorder, c.pair, contact);
    out.wrong += law != FindingKind::none ? 1 : 0;
    out.seen += found != 0 ? 1 : 0;
    // The laws see more: one that comes before it.
    EXPECT_TRUE(found == 0 || law <= finding_kind(found)) << c.name << " by " << method;
  }
  return out;
}

TEST_P(RecorderAgrees, WhatItFindsTheLawsFindAndMostOfWhatTheyDo) {
  open();
  Shared all;
  for (const std::string_view method : {"original_cn", "corrected_cn", "new_cn", "geometric_potential"}) {
    const Shared of_method = compare(recorder_, GetParam(), method);
    all.wrong += of_method.wrong, all.seen += of_method.seen;
  }
  ASSERT_GT(all.wrong, 20);
  EXPECT_GT(all.seen, (GetParam() == "hard" ? 0.5 : 0.9) * all.wrong);
}

INSTANTIATE_TEST_SUITE_P(Families, RecorderAgrees, testing::Values("spheroid", "ellipsoid", "superquadric", "hard"),
                         [](const auto& of) { return std::string(of.param); });

}  // namespace
}  // namespace plumb
