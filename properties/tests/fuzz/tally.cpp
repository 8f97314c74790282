// Counts, percentiles from fixed bins, and exact intervals.
#include "fuzz/results/tally.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb {
namespace {

TEST(Histogram, PercentilesBoundTheValueFromAbove) {
  Histogram h;
  for (int i = 1; i <= 1000; ++i) h.add(i * 1e-6);
  EXPECT_GE(h.percentile(0.5), 500e-6);
  EXPECT_LE(h.percentile(0.5), 500e-6 * 1.1221);
  EXPECT_EQ(h.percentile(1), 1000e-6);
  EXPECT_EQ(h.max(), 1000e-6);
}

TEST(Histogram, WholeNumbersAreExact) {
  Histogram h(Histogram::Scale::whole);
  for (const int value : {0, 3, 3, 17, 99}) h.add(value);
  EXPECT_EQ(h.percentile(0.2), 0);
  EXPECT_EQ(h.percentile(0.5), 3);
  EXPECT_EQ(h.percentile(0.8), 17);
}

TEST(Histogram, ZeroInfinityAndNaN) {
  Histogram h;
  EXPECT_TRUE(std::isnan(h.percentile(0.5)));
  EXPECT_TRUE(h.summary().is_null());
  h.add(0);
  h.add(std::numeric_limits<double>::quiet_NaN());
  h.add(std::numeric_limits<double>::infinity());
  EXPECT_EQ(h.count(), 2u);
  EXPECT_EQ(h.percentile(0.5), 0);
  Histogram again;
  const Json kept = h.to_json();
  again.read(Field(kept));
  EXPECT_TRUE(std::isinf(again.max()));
  EXPECT_EQ(again.to_json(), h.to_json());
}

TEST(Tally, AnUnjudgedAnswerIsNotCalledRight) {
  Tally tally;
  Contact<double> answer;
  answer.status = Status::converged;
  Judgement judgement;
  judgement.angle_error_deg = judgement.overlap_error = judgement.point_error = std::nan("");
  add_answer(tally, {}, answer, judgement, 100);
  EXPECT_EQ(tally.unjudged, 1u);
  EXPECT_EQ(tally.of(FindingKind::none), 0u);
  EXPECT_EQ(tally.judged(), 0u);
}

TEST(Tally, SurvivesItsFile) {
  Tally tally;
  Contact<double> answer;
  answer.status = Status::converged;
  answer.iterations = 5;
  Judgement judgement;
  judgement.judged = true;
  judgement.finding = {FindingKind::misaligned, 1e6, "aligned", ""};
  judgement.angle_error_deg = 12.5;
  judgement.overlap_error = 1e-3;
  add_answer(tally, Place{1, 2, 3, 4}, answer, judgement, 1234);
  EXPECT_EQ(tally.angles_wrong, 1u);
  const Json kept = tally.to_json();
  EXPECT_EQ(Tally::read(Field(kept)).to_json(), kept);
}

// Clopper & Pearson (1934): 0 of n has the upper bound 1 - (alpha/2)^(1/n).
TEST(Share, IsExact) {
  EXPECT_EQ(share_of(0, 100).low, 0);
  EXPECT_NEAR(share_of(0, 100).high, 1 - std::pow(0.025, 0.01), 1e-12);
  EXPECT_NEAR(share_of(100, 100).low, std::pow(0.025, 0.01), 1e-12);
  EXPECT_EQ(share_of(100, 100).high, 1);
  EXPECT_TRUE(std::isnan(share_of(0, 0).share));
}

}  // namespace
}  // namespace plumb
