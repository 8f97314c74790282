// Every law is shown able to fail: a right answer breaks none, and for each law there is a deliberately wrong answer that
// it rejects with the right finding.
#include "properties/laws.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>

#include "properties/families.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

using Solve = std::function<Contact<double>(const Pair&)>;

Contact<double> solve_new_cn(const Pair& pair) {
  return find_method("new_cn")->solve(pair, {}, nullptr);
}

/// Two spheroids of aspect 2, crossed, overlapping by about 2 %.
Pair crossed_spheroids() {
  Pair pair;
  pair.body1.shape.semi_axes << 1, 1, 2;
  pair.body2.shape.semi_axes << 1, 1, 2;
  pair.body2.quaternion = {0.8, 0.5, 0.2, 0.1};
  pair.body2.position << 1.1, 0.9, 1.7;
  return pair;
}

/// The evidence that holds a right answer, for one law to be broken at a time.
struct Bench {
  Pair pair = crossed_spheroids();
  Reference reference = find_reference(pair);
  Contact<double> answer = solve_new_cn(pair);
  Solve solve = solve_new_cn;
  Problem problem = Problem::common_normal;
  Solution own = reference.common_normal;

  void answer_by(std::string_view name) {
    const Method* method = find_method(name);
    problem = method->problem;
    own = find_problem_reference(pair, problem);
    solve = [method](const Pair& p) { return method->solve(p, {}, nullptr); };
    answer = solve(pair);
  }
  [[nodiscard]] Evidence evidence() const { return {pair, problem, answer, reference, own, solve, true}; }
  [[nodiscard]] Finding broken() const { return judge(evidence()).finding; }
  [[nodiscard]] Vec3<double> across() const { return answer.normal.unitOrthogonal(); }
};

TEST(Laws, ARightAnswerBreaksNone) {
  const Bench bench;
  ASSERT_TRUE(bench.reference.common_normal.solved);
  ASSERT_EQ(bench.reference.verdict, Verdict::overlapping);
  for (const Law& law : laws()) EXPECT_LE(law.check(bench.evidence()).severity, 1) << law.name;
  EXPECT_EQ(bench.broken().kind, FindingKind::none) << bench.broken().detail;
}

/// Two unit spheres 1.9 apart, answered by their far sides: a common normal, but not the one of lowest overlap.
void answer_far_sides_of_spheres(Bench& b) {
  b.pair = {};
  b.pair.body2.position << 1.9, 0, 0;
  b.reference = find_reference(b.pair);
  b.own = b.reference.common_normal;
  b.answer = solve_new_cn(b.pair);
  b.answer.overlap = 3.9;
  b.answer.normal << -1, 0, 0;
  b.answer.point1 << -1, 0, 0;
  b.answer.point2 << 2.9, 0, 0;
}

struct Wrong {
  FindingKind kind;
  std::function<void(Bench&)> spoil;
};

using WrongAnswers = std::map<std::string_view, Wrong>;

/// Answers that are wrong in themselves.
WrongAnswers wrong_fields() {
  return {
      {"finite", {FindingKind::not_finite, [](Bench& b) { b.answer.point2[1] = std::nan(""); }}},
      {"converges", {FindingKind::nonconverged, [](Bench& b) { b.answer.status = Status::stalled; }}},
      {"verdict", {FindingKind::missed_contact, [](Bench& b) { b.answer.verdict = Verdict::separated; }}},
      {"lowest", {FindingKind::wrong_branch, answer_far_sides_of_spheres}},
      {"opposite",
       {FindingKind::misaligned,
        [](Bench& b) { b.answer.point1 += 1e-9 * b.across(), b.answer.point2 -= 1e-9 * b.across(); }}},
      {"collinear", {FindingKind::misaligned, [](Bench& b) { b.answer.point1 += 1e-12 * b.across(); }}},
      {"normal", {FindingKind::misaligned, [](Bench& b) { b.answer.normal += 1e-12 * b.across(); }}},
      {"itself", {FindingKind::misaligned, [](Bench& b) { b.answer.normal += 1e-9 * b.across(); }}},
      {"surface",
       {FindingKind::off_surface,
        [](Bench& b) { b.answer.point1 += 1e-12 * b.answer.normal, b.answer.point2 -= 1e-12 * b.answer.normal; }}},
      {"overlap", {FindingKind::overlap_error, [](Bench& b) { b.answer.overlap *= 1 + 1e-10; }}},
      {"points", {FindingKind::point_error, [](Bench& b) { b.answer.point1 += 1e-12 * b.across(); }}},
      {"between", {FindingKind::point_error, [](Bench& b) { b.answer.contact_point.setZero(); }}},
      {"evaluations", {FindingKind::slow, [](Bench& b) { b.answer.evaluations = 2001; }}},
  };
}

WrongAnswers wrong_potentials() {
  const auto not_deepest = [](Bench& b) {
    b.answer_by("geometric_potential");
    b.answer.point1 = b.pair.body1.position + Vec3<double>(0, 0, 2);
  };
  const auto not_midway = [](Bench& b) {
    b.answer_by("geometric_potential_midway");
    b.answer.contact_point += 1e-12 * b.across();
  };
  const auto not_undone = [](Bench& b) {
    b.pair.motion << 1, 2, 3;
    b.answer_by("first_touch");
    b.answer.point2 += 1e-12 * b.across();
  };
  return {{"deepest", {FindingKind::point_error, not_deepest}},
          {"balance", {FindingKind::misaligned, not_midway}},
          {"undone", {FindingKind::misaligned, not_undone}}};
}

/// new_cn, and then a fault of its own for some pairs.
template <class Fault>
std::function<void(Bench&)> solver_with(Fault fault) {
  return [fault](Bench& b) {
    b.solve = [fault, first = b.pair.body1.position](const Pair& p) mutable {
      Contact<double> c = solve_new_cn(p);
      fault(p, p.body1.position != first, c);
      return c;
    };
  };
}

/// Solvers whose answers to related pairs do not fit together.
WrongAnswers wrong_solvers() {
  using Answer = Contact<double>;
  const auto depends_on_order = [](const Pair&, bool exchanged, Answer& c) { c.overlap *= exchanged ? 1 + 1e-9 : 1; };
  const auto sees_the_worlds_axes = [](const Pair&, bool, Answer& c) { c.point1[2] *= 1 + 1e-9; };
  const auto another_code_for_superquadrics = [](const Pair& p, bool, Answer& c) {
    c.overlap *= p.body1.shape.n1 == 2 ? 1 : 1 + 1e-9;
  };
  const auto absolute_tolerance = [](const Pair&, bool, Answer& c) { c.overlap += 1e-12; };
  const auto remembers = [calls = 0](const Pair&, bool, Answer& c) mutable {
    c.point1[0] = std::nextafter(c.point1[0], 2 + ++calls);
  };
  return {{"swap", {FindingKind::asymmetric, solver_with(depends_on_order)}},
          {"motion", {FindingKind::asymmetric, solver_with(sees_the_worlds_axes)}},
          {"limit", {FindingKind::asymmetric, solver_with(another_code_for_superquadrics)}},
          {"unit", {FindingKind::asymmetric, solver_with(absolute_tolerance)}},
          {"repeat", {FindingKind::nondeterministic, solver_with(remembers)}}};
}

const WrongAnswers& wrong_answers() {
  static const WrongAnswers all = [] {
    WrongAnswers out = wrong_fields();
    out.merge(wrong_potentials());
    out.merge(wrong_solvers());
    return out;
  }();
  return all;
}

TEST(Laws, EachRejectsItsWrongAnswer) {
  for (const Law& law : laws()) {
    const auto found = wrong_answers().find(law.name);
    ASSERT_NE(found, wrong_answers().end()) << "no wrong answer for the law " << law.name;
    Bench bench;
    found->second.spoil(bench);
    const Finding finding = law.check(bench.evidence());
    EXPECT_GT(finding.severity, 1) << law.name;
    EXPECT_EQ(finding.kind, found->second.kind) << law.name;
  }
}

TEST(Laws, TheFirstThatAppliesIsReported) {
  Bench bench;
  answer_far_sides_of_spheres(bench);
  EXPECT_EQ(bench.broken().kind, FindingKind::wrong_branch) << bench.broken().detail;
  bench.answer.verdict = Verdict::separated;
  EXPECT_EQ(bench.broken().kind, FindingKind::missed_contact);
  bench.answer.status = Status::iteration_limit;
  EXPECT_EQ(bench.broken().kind, FindingKind::nonconverged);
}

TEST(Laws, ASeparatedPairCalledOverlappingIsAFalseContact) {
  Bench bench;
  bench.pair.body2.position *= 1.5;
  bench.reference = find_reference(bench.pair);
  bench.own = bench.reference.common_normal;
  bench.answer = solve_new_cn(bench.pair);
  ASSERT_EQ(bench.reference.verdict, Verdict::separated);
  EXPECT_EQ(bench.broken().kind, FindingKind::none) << bench.broken().detail;
  bench.answer.verdict = Verdict::overlapping;
  EXPECT_EQ(bench.broken().kind, FindingKind::false_contact);
}

TEST(Laws, AFlippedNormalIsMisaligned) {
  Bench bench;
  bench.answer.normal *= -1;
  EXPECT_EQ(bench.broken().kind, FindingKind::misaligned);
}

TEST(Laws, WordsAreTheContracts) {
  EXPECT_EQ(name(FindingKind::none), "none");
  EXPECT_EQ(name(FindingKind::crash), "crash");
  EXPECT_EQ(name(FindingKind::nondeterministic), "nondeterministic");
}

/// A right answer to another problem breaks none of the laws either.
TEST(Laws, OtherProblemsAreJudgedByTheirOwn) {
  for (const char* name : {"geometric_potential", "geometric_potential_midway", "first_touch"})
    for (const bool moves : {false, true}) {
      Bench bench;
      if (moves) bench.pair.motion << -1, 2, -0.5;
      bench.answer_by(name);
      ASSERT_TRUE(bench.own.solved) << name;
      EXPECT_EQ(bench.broken().kind, FindingKind::none) << name << ": " << bench.broken().law << bench.broken().detail;
    }
}

/// Where flat faces leave the condition numbers infinite, the answer's own equations still hold it.
TEST(Laws, AnAbsurdPotentialBetweenFlatFacesIsFound) {
  for (const char* name : {"geometric_potential", "geometric_potential_midway"}) {
    Bench bench;
    for (Body* body : {&bench.pair.body1, &bench.pair.body2}) {
      body->shape = {Vec3<double>::Ones(), 8, 8};
      body->quaternion = {1, 0, 0, 0};
    }
    bench.pair.body2.position << 0, 0, 1.9;
    bench.reference = find_reference(bench.pair);
    bench.answer_by(name);
    bench.solve = {};
    EXPECT_EQ(bench.broken().kind, FindingKind::none) << name << ": " << bench.broken().law << bench.broken().detail;
    bench.answer.overlap *= 10;
    EXPECT_EQ(bench.broken().kind, FindingKind::overlap_error) << name;
  }
}

/// From contact to a million radii: what rounding allows grows with the distance, and so does what a double can hold.
TEST(Laws, SpheresAreRightAtAnyDistance) {
  for (const double distance : {1.9, 2.5, 40.0, 375.3, 1.4e6, 3.3e20}) {
    Bench bench;
    bench.pair = {};
    bench.pair.body2.position << 0.6 * distance, 0.8 * distance, 0;
    bench.reference = find_reference(bench.pair);
    bench.own = bench.reference.common_normal;
    bench.answer = solve_new_cn(bench.pair);
    EXPECT_EQ(bench.broken().kind, FindingKind::none)
        << distance << ": " << bench.broken().law << ", " << bench.broken().detail;
  }
}

/// The laws of symmetry see a wrong point, and only that, in any unit of length.
TEST(Laws, SymmetryIsSeenAtBothEndsOfTheRange) {
  for (const double unit : {1e-200, 1e-170, 1e-100, 1.0, 1e170, 1e300}) {
    Bench bench;
    for (Body* body : {&bench.pair.body1, &bench.pair.body2}) {
      body->shape.semi_axes *= unit;
      body->position *= unit;
    }
    bench.reference = find_reference(bench.pair);
    bench.own = bench.reference.common_normal;
    bench.answer = solve_new_cn(bench.pair);
    EXPECT_EQ(bench.broken().kind, FindingKind::none) << unit << ": " << bench.broken().law << bench.broken().detail;
    bench.solve = [first = bench.pair.body1.position](const Pair& p) {
      Contact<double> c = solve_new_cn(p);
      if (p.body1.position != first) c.point1 *= 1.1;
      return c;
    };
    EXPECT_EQ(bench.broken().kind, FindingKind::asymmetric) << unit;
  }
}

/// A field that is not there cannot be wrong.
TEST(Laws, APartialAnswerIsJudgedByWhatItHolds) {
  Bench bench;
  bench.solve = {};
  bench.answer.point1 = bench.answer.point2 = bench.answer.contact_point = not_valid<double>();
  EXPECT_EQ(bench.broken().kind, FindingKind::none) << bench.broken().detail;
  bench.answer.overlap = std::nan("");
  EXPECT_EQ(bench.broken().kind, FindingKind::none) << bench.broken().detail;
  bench.answer.normal *= -1;
  EXPECT_EQ(bench.broken().kind, FindingKind::misaligned);
}

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

FindingKind judged(const Pair& pair, const Contact<double>& answer) {
  return Judge(pair).judge(Problem::common_normal, answer).finding.kind;
}

Pair concentric(const Vec3<double>& semi_axes1, const Vec3<double>& semi_axes2) {
  Pair pair;
  pair.body1.shape.semi_axes = semi_axes1;
  pair.body2.shape.semi_axes = semi_axes2;
  return pair;
}

const Vec3<double> ex(1, 0, 0), ey(0, 1, 0), ez(0, 0, 1), absent = not_valid<double>();

TEST(Laws, PointsAloneAreJudgedByTheTieTheyBelongTo) {
  const Pair pair = concentric({1, 1.5, 2}, {1, 1.5, 2});
  for (const double side : {1.0, -1.0}) {
    EXPECT_EQ(judged(pair, given(2, absent, side * ex, -side * ex)), FindingKind::none);
    EXPECT_NE(judged(pair, given(2, absent, side * ey, -side * ey)), FindingKind::none);
  }
}

TEST(Laws, OnARingAnyOfItsNormalsAndNoOther) {
  const Pair pair = concentric({1, 1, 0.9}, {0.2, 0.2, 0.9});  // 1.2 on the equator, 1.8 at the poles
  const Vec3<double> n = Vec3<double>(0.6, 0.8, 0).normalized();
  EXPECT_EQ(judged(pair, given(1.2, n, n, -0.2 * n)), FindingKind::none);
  EXPECT_EQ(judged(pair, given(1.2, ez)), FindingKind::misaligned);
  EXPECT_EQ(judged(pair, given(1.2, absent, 0.9 * ez, -0.9 * ez)), FindingKind::overlap_error);
  EXPECT_EQ(judged(pair, given(std::nan(""), absent, 0.9 * ez, -0.9 * ez)), FindingKind::point_error);
  for (const double length : {0.0, 9.0, 1e-300, 1e300})
    EXPECT_EQ(judged(pair, given(1.2, length * n)), FindingKind::misaligned);
}

/// Nearly of revolution: nothing is proved but bounds, and the mirror image of the answer that is found is as good.
TEST(Laws, WhatMayTieIsNotFlagged) {
  Pair pair = concentric({1, 1, 2}, {0.9, 0.9, 1.8});
  pair.body1.shape.n1 = 2.5;
  pair.body1.shape.n2 = 1.9999993144483852;
  pair.body2.position << 0, 0, 0.1;
  const double a = 0.7070982689206692, b = 0.7069795061075875, c = 0.636365460570671, overlap = 1.8997995409163861;
  for (const double side : {1.0, -1.0}) {
    const Vec3<double> n(side * a, -side * a, 0.004906748290477945), p1(side * b, -side * b, 0.09165818220241116),
        p2(-side * c, side * c, 0.08233634405276889);
    EXPECT_EQ(judged(pair, given(overlap, n, p1, p2)), FindingKind::none);
    EXPECT_EQ(judged(pair, given(overlap, ez)), FindingKind::misaligned);
  }
}

/// No local solve finds a common normal of these; the bounds are proved all the same.
TEST(Laws, BoundsAloneContradictAnAnswer) {
  Pair pair = concentric({1, 1, 1.1}, {1, 1, 1.1});
  pair.body2.position << 0, 0, 0.3;
  pair.body2.quaternion = {1, 1.5538308190117619e-09, 0, 0};
  EXPECT_EQ(judged(pair, given(-1, ez)), FindingKind::missed_contact);
  EXPECT_EQ(judged(pair, given(1, absent)), FindingKind::overlap_error);
  EXPECT_EQ(judged(pair, given(1.889821, absent)), FindingKind::none);
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

/// The mission's claim on a sample (the campaign repeats it on 100 000): convergence of the original says nothing.
TEST(Laws, OriginalConvergesToWhatIsNoCommonNormal) {
  const int cases = 300;
  int converged = 0, misaligned = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const Case c = generate("spheroid", 1, i);
    const Contact<double> answer = find_method("original_cn")->solve(c.pair, {}, nullptr);
    if (answer.status != Status::converged) continue;
    ++converged;
    const FindingKind kind = Judge(c.pair).judge(Problem::common_normal, answer).finding.kind;
    misaligned += kind == FindingKind::misaligned;
  }
  EXPECT_GT(converged, cases * 9 / 10);
  EXPECT_GT(misaligned, converged / 2);
}

TEST(Laws, NewConvergesToCommonNormalsOnSpheroids) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Case c = generate("spheroid", 1, i);
    const Contact<double> answer = solve_new_cn(c.pair);
    const Finding finding = Judge(c.pair).judge(Problem::common_normal, answer, solve_new_cn, true).finding;
    EXPECT_EQ(finding.kind, FindingKind::none) << c.name << ": " << finding.law << ", " << finding.detail;
  }
}

}  // namespace
}  // namespace plumb
