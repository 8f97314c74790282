// The frozen hard cases: files as the generators make them, the rule by which anybody may judge, and the program that applies it.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "properties/generators/families.hpp"
#include "properties/tests/corpus/programs.hpp"
#include "reports/stability/certified.hpp"
#include "reports/stability/rows.hpp"

namespace plumb::reports {
namespace {

const std::string kFolder = PLUMB_SOURCE_DIR "/corpus/cases/hard/";
constexpr double kEps = std::numeric_limits<double>::epsilon();

std::vector<CertifiedCase> ladder(const std::string& name) {
  std::vector<CertifiedCase> out;
  CaseReader reader(kFolder + name + ".jsonl");
  for (std::optional<Case> c = reader.next(); c; c = reader.next())
    out.push_back(read_certified(*std::move(c), name, reader.line()));
  return out;
}

Contact<Real50> own_answer(const CertifiedCase& c) {
  Contact<Real50> out;
  out.status = Status::converged;
  out.overlap = c.overlap.upper;
  out.verdict = c.overlap.upper > 0 ? Verdict::overlapping : Verdict::separated;
  out.normal = c.answers.at(0).normal;
  out.point1 = c.answers.at(0).point1;
  out.point2 = c.answers.at(0).point2;
  return out;
}

bool is_right(const CertifiedCase& c, const Contact<Real50>& answer, double epsilon = kEps) {
  return errors_against(c, answer, epsilon).is_right();
}

TEST(Frozen, EveryLadderIsKeptWholeAndAsItsGeneratorMakesIt) {
  for (const std::string_view name : hard_generators()) {
    const auto cases = ladder(std::string(name));
    ASSERT_EQ(cases.size(), 3 * ladder_steps(name).size()) << name;
    for (const CertifiedCase& c : cases) {
      const auto index = c.c.provenance.at("index").get<std::uint64_t>();
      const Case made = ladder_case(name, c.step - 1, 1, index);
      EXPECT_EQ(bodies_json(c.c.pair), bodies_json(made.pair)) << c.c.name;
      EXPECT_EQ(c.ladder, name);
      EXPECT_EQ(c.value, ladder_steps(name)[c.step - 1]);
      EXPECT_TRUE(c.c.expect.overlap.has_value()) << c.c.name;
    }
  }
}

TEST(Frozen, ACertificateHoldsItsOwnAnswerInEveryArithmetic) {
  for (const std::string_view name : hard_generators())
    for (const CertifiedCase& c : ladder(std::string(name))) {
      if (c.answers.empty()) continue;
      for (const double epsilon : {1.2e-7, kEps, 1e-19}) EXPECT_TRUE(is_right(c, own_answer(c), epsilon)) << c.c.name;
    }
}

TEST(Frozen, AnAnswerBeyondItsConditionIsWrong) {
  for (const char* name : {"needle", "deep_overlap", "length_unit", "quaternion_length", "shallow_spheroids"})
    for (const CertifiedCase& c : ladder(name)) {
      const double size = size_of(c.c.pair), scale = size + std::abs(static_cast<double>(c.overlap.upper));
      const Contact<Real50> truth = own_answer(c);
      Contact<Real50> deeper = truth, turned = truth, shifted = truth;
      deeper.overlap += 9 * c.condition.overlap * kEps * scale;
      const Vec3<Real50> across = truth.normal.unitOrthogonal();
      turned.normal += across * Real50(2 * std::max(8 * (1 + c.condition.normal) * kEps, c.answers[0].nearby_normal));
      const double far = std::max(c.c.pair.body1.position.norm(), c.c.pair.body2.position.norm());
      shifted.point2 +=
          across * Real50(2 * std::max(8 * c.condition.points * kEps * scale, c.answers[0].nearby_points) +
                          20 * kEps * (scale + far));
      EXPECT_FALSE(is_right(c, deeper)) << c.c.name;
      EXPECT_FALSE(is_right(c, turned)) << c.c.name;
      EXPECT_FALSE(is_right(c, shifted)) << c.c.name;
    }
}

TEST(Frozen, NaNIsWrong) {
  const CertifiedCase c = ladder("needle").front();
  const Real50 nan = std::numeric_limits<Real50>::quiet_NaN();
  for (const auto& spoil : std::vector<std::function<void(Contact<Real50>&)>>{[&](auto& a) { a.overlap = nan; },
                                                                              [&](auto& a) { a.normal[1] = nan; },
                                                                              [&](auto& a) { a.point2[0] = nan; }}) {
    Contact<Real50> answer = own_answer(c);
    spoil(answer);
    EXPECT_FALSE(is_right(c, answer));
  }
}

/// What an answer says of itself, without its certificate but for the sign of the overlap.
TEST(Frozen, AnAnswerThatContradictsItselfIsWrong) {
  const CertifiedCase c = ladder("near_touching_overlapping").front();
  Contact<Real50> other = own_answer(c), longer = other, exchanged = other, inside = other;
  other.verdict = Verdict::separated;
  longer.normal *= Real50(1 + 1e-12);
  std::swap(exchanged.point1, exchanged.point2);
  inside.point1 -= Real50(1e-9) * inside.normal;
  inside.point2 -= Real50(1e-9) * inside.normal;
  for (const Contact<Real50>& answer : {other, longer, exchanged, inside}) {
    EXPECT_FALSE(is_right(c, answer));
    EXPECT_FALSE(errors_against(c, answer, kEps).broken.empty());
  }
}

TEST(Frozen, OfATieAnyMinimumIsRightAndNoOther) {
  const auto cases = ladder("tie");
  const auto tied =
      std::find_if(cases.begin(), cases.end(), [](const CertifiedCase& c) { return c.answers.size() > 1; });
  ASSERT_NE(tied, cases.end());
  for (const CertifiedAnswer& one : tied->answers) {
    Contact<Real50> answer = own_answer(*tied);
    answer.normal = one.normal;
    answer.point1 = one.point1;
    answer.point2 = one.point2;
    answer.overlap = one.overlap.upper;
    const bool is_as_low = one.overlap.lower <= tied->overlap.upper;
    EXPECT_EQ(is_right(*tied, answer), is_as_low);
    answer.normal = -one.normal.unitOrthogonal();
    EXPECT_FALSE(is_right(*tied, answer));
  }
}

TEST(Frozen, DigitsAreThoseOfTheErrorAndNoMoreThanEpsilonHas) {
  EXPECT_DOUBLE_EQ(digits_of(1e-9, kEps), 9);
  EXPECT_DOUBLE_EQ(digits_of(0, 1e-16), 16);
  EXPECT_DOUBLE_EQ(digits_of(1e-30, 1e-16), 16);
  EXPECT_DOUBLE_EQ(digits_of(5, 1e-16), 0);
}

class Stability : public Commands {};

TEST_F(Stability, AutoIsRightInEveryArithmeticOfTheMachine) {
  const Ran ran = plumb("report-stability " + kFolder + "*.jsonl --samples 2 --json --threads 2");
  EXPECT_EQ(ran.code, 0) << ran.out;
  const auto lines = lines_of(ran.out);
  ASSERT_GT(lines.size(), 33u * 8u);
  EXPECT_EQ(lines[0].at("kind"), "run");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::string arithmetic = lines[i].at("arithmetic");
    for (const Json& wrong : lines[i].at("wrong")) EXPECT_EQ(wrong, 0) << lines[i].dump();
    if (arithmetic == "float" || arithmetic == "50 digits") continue;
    EXPECT_TRUE(lines[i].at("lets_go").is_null()) << lines[i].dump();
    EXPECT_GT(lines[i].at("digits").at("overlap").get<double>(), 13) << lines[i].dump();
  }
  EXPECT_EQ(plumb("report-stability " + kFolder + "*.jsonl --samples 2 --json --threads 1").out, ran.out);
}

TEST_F(Stability, APublishedMethodLetsGoAndThatIsAResult) {
  const Ran ran = plumb("report-stability " + kFolder + "needle.jsonl --method original_cn --arithmetic double --json");
  EXPECT_EQ(ran.code, 0);
  const auto lines = lines_of(ran.out);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[1].at("lets_go"), 1);
  EXPECT_EQ(lines[1].at("cases").size(), 7u);
}

TEST_F(Stability, TakesTheFirstCasesOfEachStep) {
  const std::string args =
      "report-stability " + kFolder + "needle.jsonl --method original_cn --arithmetic double --json";
  const Json all = lines_of(plumb(args).out).at(1).at("cases"),
             two = lines_of(plumb(args + " --cases 2").out).at(1).at("cases");
  ASSERT_EQ(all.size(), two.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i], 3);
    EXPECT_EQ(two[i], 2);
  }
  EXPECT_EQ(plumb(args + " --cases 0 2>/dev/null").code, 2);
}

TEST_F(Stability, UnusableInput) {
  write_file(path_ / "plain.jsonl", format_case(ladder_case("needle", 0, 1, 0)) + "\n");
  expect_refusal("report-stability plain.jsonl", "plain.jsonl:1: provenance.certificate: missing");
  expect_refusal("report-stability none", "none: No such file or directory");
  expect_refusal("report-stability plain.jsonl --method geometric_potential",
                 "--method: geometric_potential: is no common-normal method of plumb's");
  EXPECT_EQ(plumb("report-stability plain.jsonl --arithmetic quad 2>/dev/null").code, 2);
  EXPECT_EQ(plumb("report-stability plain.jsonl --samples 0 2>/dev/null").code, 2);
}

class Ladders : public Commands {};

TEST_F(Ladders, AreFrozenWithCertificatesThatReportStabilityReads) {
  ASSERT_EQ(plumb("ladder unit_of_faces --variants 1 --seed 5 --write kept").code, 0);
  const Ran ran = plumb("report-stability kept --arithmetic double --json");
  EXPECT_EQ(ran.code, 0) << ran.out;
  EXPECT_EQ(lines_of(ran.out).size(), 2u);
  EXPECT_EQ(plumb("replay kept --quiet").code, 0);
}

TEST_F(Ladders, PrintAStep) {
  const Ran ran = plumb("ladder face_face --step 9 --seed 4 --index 2");
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.out, format_case(ladder_case("face_face", 8, 4, 2)) + "\n");
  expect_refusal("ladder face_face --step 10", "--step: face_face has 9 steps");
  EXPECT_EQ(plumb("ladder cubes 2>/dev/null").code, 2);
}

}  // namespace
}  // namespace plumb::reports
