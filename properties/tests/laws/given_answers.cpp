// Answers of which only a part is given, at ties, on rings, where nothing is proved but bounds, and the certified truth in doubles.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "properties/generators/families.hpp"
#include "properties/laws/laws.hpp"

namespace plumb {
namespace {

/// What somebody gives of an answer; NaN stands for what is not given.
Contact<double> given(double overlap, const Vec3<double>& normal, const Vec3<double>& point1 = not_valid<double>(),
                      const Vec3<double>& point2 = not_valid<double>()) {
  Contact<double> out;
  out.status = Status::converged;
  out.overlap = overlap;
  out.verdict = overlap > 0 ? Verdict::overlapping : (overlap < 0 ? Verdict::separated : Verdict::undecided);
  out.normal = normal;
  out.point1 = point1;
  out.point2 = point2;
  return out;
}

FindingKind judged(Judge& judge, const Contact<double>& answer) {
  return judge.judge(Problem::common_normal, answer).finding.kind;
}

Pair concentric(const Vec3<double>& semi_axes1, const Vec3<double>& semi_axes2) {
  Pair pair;
  pair.body1.shape.semi_axes = semi_axes1;
  pair.body2.shape.semi_axes = semi_axes2;
  return pair;
}

const Vec3<double> ex(1, 0, 0), ey(0, 1, 0), ez(0, 0, 1), absent = not_valid<double>();

TEST(Laws, PointsAloneAreJudgedByTheTieTheyBelongTo) {
  Judge judge(concentric({1, 1.5, 2}, {1, 1.5, 2}));
  for (const double side : {1.0, -1.0}) {
    EXPECT_EQ(judged(judge, given(2, absent, side * ex, -side * ex)), FindingKind::none);
    EXPECT_NE(judged(judge, given(2, absent, side * ey, -side * ey)), FindingKind::none);
  }
}

TEST(Laws, OnARingAnyOfItsNormalsAndNoOther) {
  Judge judge(concentric({1, 1, 0.9}, {0.2, 0.2, 0.9}));  // 1.2 on the equator, 1.8 at the poles
  const Vec3<double> n = Vec3<double>(0.6, 0.8, 0).normalized();
  EXPECT_EQ(judged(judge, given(1.2, n, n, -0.2 * n)), FindingKind::none);
  EXPECT_EQ(judged(judge, given(1.2, ez)), FindingKind::misaligned);
  EXPECT_EQ(judged(judge, given(1.2, absent, 0.9 * ez, -0.9 * ez)), FindingKind::overlap_error);
  EXPECT_EQ(judged(judge, given(std::nan(""), absent, 0.9 * ez, -0.9 * ez)), FindingKind::point_error);
  for (const double length : {0.0, 9.0, 1e-300, 1e300})
    EXPECT_EQ(judged(judge, given(1.2, length * n)), FindingKind::misaligned);
}

/// Nearly of revolution: nothing is proved but bounds, and the mirror image of the answer that is found is as good.
TEST(Laws, WhatMayTieIsNotFlagged) {
  Pair pair = concentric({1, 1, 2}, {0.9, 0.9, 1.8});
  pair.body1.shape.n1 = 2.5;
  pair.body1.shape.n2 = 1.9999993144483852;
  pair.body2.position << 0, 0, 0.1;
  Judge judge(pair);
  const double a = 0.7070982689206692, b = 0.7069795061075875, c = 0.636365460570671, overlap = 1.8997995409163861;
  for (const double side : {1.0, -1.0}) {
    const Vec3<double> n(side * a, -side * a, 0.004906748290477945), p1(side * b, -side * b, 0.09165818220241116),
        p2(-side * c, side * c, 0.08233634405276889);
    EXPECT_EQ(judged(judge, given(overlap, n, p1, p2)), FindingKind::none);
    EXPECT_EQ(judged(judge, given(overlap, ez)), FindingKind::misaligned);
  }
}

/// No local solve finds a common normal of these; the bounds are proved all the same.
TEST(Laws, BoundsAloneContradictAnAnswer) {
  const Vec3<double> not_quite_round(1, std::nextafter(1.0, 2.0), 1.1);  // what is round is proved to more digits
  Pair pair = concentric(not_quite_round, not_quite_round);
  pair.body2.position << 0, 0, 0.3;
  pair.body2.quaternion = {1, 1.5538308190117619e-09, 0, 0};
  Judge judge(pair);
  EXPECT_EQ(judged(judge, given(-1, ez)), FindingKind::missed_contact);
  EXPECT_EQ(judged(judge, given(1, absent)), FindingKind::overlap_error);
  EXPECT_EQ(judged(judge, given(1.889821, absent)), FindingKind::none);
}

/// What the certified solution becomes in doubles: no answer is better, so whatever a law says of it is the law's fault.
void expect_rounded_truth_breaks_none(const Pair& pair, std::string_view name) {
  const Reference found = find_reference(pair);
  const Solution& truth = found.common_normal;
  if (!truth.solved) return;
  Contact<double> answer = given(static_cast<double>(truth.overlap), truth.normal.cast<double>(),
                                 truth.point1.cast<double>(), truth.point2.cast<double>());
  answer.verdict = found.verdict;
  const Finding finding = Judge(pair).judge(Problem::common_normal, answer).finding;
  EXPECT_EQ(finding.kind, FindingKind::none)
      << name << ": " << finding.law << ", " << finding.severity << ", " << finding.detail;
}

TEST(Laws, TheRoundedTruthBreaksNone) {
  for (std::uint64_t i = 0; i < 2; ++i)
    for (const std::string_view generator : hard_generators()) {
      const Case c = generate_hard(generator, 3, i);
      expect_rounded_truth_breaks_none(c.pair, c.name);
    }
}

/// A tip of exponent 1.1 in a sphere: the normal turns by 66 degrees between one double and the next.
TEST(Laws, TheRoundedTruthOnATipBreaksNone) {
  Pair pair;
  pair.body1.shape = {{1, 1.0 / 3, 0.001}, 1.1, 1.1};
  for (const double angle : {0.0, 0.3, 0.7, 1.1, 1.5}) {
    const Eigen::Quaterniond q(Eigen::AngleAxisd(angle, Eigen::Vector3d(0.9, 0.1, 0.2).normalized()));
    pair.body1.quaternion = {q.w(), q.x(), q.y(), q.z()};
    pair.body2.position << 0, 0, 1.3;
    expect_rounded_truth_breaks_none(pair, std::to_string(angle));
  }
  pair.body1.quaternion = {0.7865660120376684, 0.6035534523129826, 0.07945884248980635, 0.1035540016533347};
  pair.body2.position << 0, 0, 1.3050643400521098;
  expect_rounded_truth_breaks_none(pair, "tip-between-doubles");
}

}  // namespace
}  // namespace plumb
