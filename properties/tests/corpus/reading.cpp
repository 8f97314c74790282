// What the reader takes, what it refuses and in which words.
#include <gtest/gtest.h>

#include <cmath>

#include "corpus/case/case.hpp"
#include "corpus/case/contract_words.hpp"
#include "properties/laws/laws.hpp"
#include "properties/tests/corpus/sample.hpp"
#include "solver/pose.hpp"

namespace plumb {
namespace {

std::string error_of(const std::string& text) {
  try {
    (void)parse_case(text, "a.jsonl", 7);
  } catch (const InputFailure& error) {
    return error.what();
  }
  return "none";
}

Case parsed(const std::string& text) {
  return parse_case(text, "a.json");
}

TEST(Reading, DefaultsAreTheContracts) {
  const Case c = parsed(sample_case());
  EXPECT_EQ(c.name, "sample");
  EXPECT_EQ(c.pair.body1.shape.n1, 2);
  EXPECT_EQ(c.pair.body1.shape.n2, 2);
  EXPECT_TRUE(c.expect.empty());
  EXPECT_TRUE(c.provenance.is_null());
}

TEST(Reading, ExponentsComeInLiggghtssOrder) {
  const Case c = parsed(sample_with("[2, 2]", "[8, 3]"));
  EXPECT_EQ(c.pair.body2.shape.n1, 8);
  EXPECT_EQ(c.pair.body2.shape.n2, 3);
}

class Refused : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(Refused, WithFileLineFieldAndReason) {
  EXPECT_EQ(error_of(GetParam().first), "a.jsonl:7: " + GetParam().second);
}

const std::string shape2 = "bodies[1].shape.superellipsoid.";

INSTANTIATE_TEST_SUITE_P(
    Numbers, Refused,
    testing::Values(
        std::pair{sample_with("[1, 1, 1]", "[1, 0, 1]"), shape2 + "semi_axes[1]: must be finite and above 0"},
        std::pair{sample_with("[1, 1, 1]", "[1, 1, -2]"), shape2 + "semi_axes[2]: must be finite and above 0"},
        std::pair{sample_with("[1, 1, 1]", "[1, 1]"), shape2 + "semi_axes: must be an array of 3 numbers, not 2"},
        std::pair{sample_with("[1, 1, 1]", "[1, 1, \"1\"]"), shape2 + "semi_axes[2]: must be a number, not a string"},
        std::pair{sample_with("[1, 1, 1]", "[1, 1, null]"), shape2 + "semi_axes[2]: must be a number, not null"},
        std::pair{sample_with("[2, 2]", "[1, 2]"), shape2 + "exponents[0]: must be finite and above 1"},
        std::pair{sample_with("[2, 2]", "[2, 0.5]"), shape2 + "exponents[1]: must be finite and above 1"},
        std::pair{sample_with("[1, 0, 0, 0]", "[0, 0, 0, 0]"),
                  std::string("bodies[0].orientation.quaternion_wxyz: must not be zero")},
        std::pair{sample_with("1.5", "1e999"),
                  std::string("bodies[1].position[0]: broken JSON: a number beyond the range of a double")}));

INSTANTIATE_TEST_SUITE_P(
    Fields, Refused,
    testing::Values(
        std::pair{sample_plus(R"("colour": "red")"), std::string("colour: unknown field")},
        std::pair{sample_with(R"("exponents")", R"("exponent")"), shape2 + "exponent: unknown field"},
        std::pair{sample_plus(R"("": "red")"), std::string("\"\": unknown field")},
        std::pair{sample_plus(R"("provenance": {"": 1, "": 2})"), std::string("provenance.\"\": stands twice")},
        std::pair{sample_plus(R"("name": "again")"), std::string("name: stands twice")},
        std::pair{sample_plus(R"("provenance": {"a": [{"b": 1, "b": 2}]})"),
                  std::string("provenance.a[0].b: stands twice")},
        std::pair{sample_with("plumb/case-1", "plumb/case-3"),
                  std::string("format: must be one of plumb/case-1, plumb/case-2")},
        std::pair{sample_with(R"("format": "plumb/case-1", )", ""), std::string("format: missing")},
        std::pair{sample_with("superellipsoid", "box"),
                  std::string("bodies[1].shape: is no superellipsoid: takes \"format\": \"plumb/case-2\"")},
        std::pair{sample_with(R"("position": [1.5, 0, 0],)", ""), std::string("bodies[1].position: missing")},
        std::pair{sample_with(R"("euler_zxz": [0, 0.5, 0])", R"("euler_zxz": [0, 0, 0], "euler_zxz_deg": [0, 0, 0])"),
                  std::string("bodies[1].orientation: must hold one of quaternion_wxyz, euler_zxz, euler_zxz_deg")},
        std::pair{std::string("[1]"), std::string("must be an object, not an array")},
        std::pair{std::string(R"({"format": "plumb/case-1", "bodies": [{}, {}, {}]})"),
                  std::string("bodies: must be an array of 2 bodies, not 3")}));

const std::string verdict_words_text = "expect.verdict: must be one of undecided, overlapping, separated";

INSTANTIATE_TEST_SUITE_P(
    Expectations, Refused,
    testing::Values(std::pair{sample_plus(R"("expect": {"verdict": "touching"})"), verdict_words_text},
                    std::pair{sample_plus(R"("expect": {"overlap": [2, 1]})"),
                              std::string("expect.overlap: lower bound above the upper one")},
                    std::pair{sample_plus(R"("expect": {"normal": [0, 0, 0]})"),
                              std::string("expect.normal: must not be zero")},
                    std::pair{sample_plus(R"("expect": {"normal_radius": 1})"),
                              std::string("expect.normal_radius: says nothing without normal")},
                    std::pair{sample_plus(R"("expect": {"answer": 1})"), std::string("expect.answer: unknown field")}));

INSTANTIATE_TEST_SUITE_P(
    Placements, Refused,
    testing::Values(std::pair{sample_plus(R"("placement": {"line_deg": [0, 0], "overlap_ratio": 0})"),
                              std::string("placement: stands instead of bodies[1].position: give only one of them")},
                    std::pair{placed_sample(R"({"line_deg": [0, 0], "overlap_ratio": 1})"),
                              std::string("placement.overlap_ratio: must be below 1")},
                    std::pair{placed_sample(R"({"line_deg": [0, 0]})"),
                              std::string("placement.overlap_ratio: missing")}));

TEST(Reading, BrokenTextNamesThePlace) {
  EXPECT_TRUE(
      error_of(sample_with("1.5", "NaN")).starts_with("a.jsonl:7: bodies[1].position[0]: broken JSON: NaN and"));
  EXPECT_TRUE(
      error_of(sample_with("1.5", "-Infinity")).starts_with("a.jsonl:7: bodies[1].position[0]: broken JSON: NaN"));
  EXPECT_TRUE(error_of("{\"format\": ").starts_with("a.jsonl:7: format: broken JSON: parse error at line 1"));
  EXPECT_TRUE(error_of("").starts_with("a.jsonl:7: broken JSON: "));
  EXPECT_EQ(error_of(sample_case() + '\0' + "tail"), "a.jsonl:7: broken JSON: holds a zero byte");
  EXPECT_EQ(error_of(std::string(100000, '[')), "a.jsonl:7: nested deeper than 64 levels");
}

TEST(Reading, ErrorsStayOnOneLine) {
  EXPECT_EQ(error_of(sample_plus(R"("two\nlines": 1)")), "a.jsonl:7: two lines: unknown field");
}

TEST(Reading, ForeignNamesAreKept) {
  const Case c = parsed(sample_plus(R"("x_note": {"a": [1]}, "provenance": [1, "two", {"three": null}])"));
  EXPECT_EQ(c.extra["x_note"]["a"][0], 1);
  EXPECT_EQ(parsed(format_case(c)).extra, c.extra);
  EXPECT_EQ(parsed(format_case(c)).provenance, c.provenance);
}

TEST(Reading, QuarterTurnsInDegreesAreExact) {
  const auto turned = [](const std::string& degrees) {
    return parsed(sample_with(R"("euler_zxz": [0, 0.5, 0])", R"("euler_zxz_deg": )" + degrees)).pair.body2.quaternion;
  };
  EXPECT_EQ(turned("[0, 180, 0]"), (std::array<double, 4>{0, 1, 0, 0}));
  EXPECT_EQ(turned("[180, 0, 0]"), (std::array<double, 4>{0, 0, 0, 1}));
  EXPECT_EQ(turned("[-90, 180, 90]"), (std::array<double, 4>{0, 0, -1, 0}));
  EXPECT_EQ(turned("[0, 60, 0]")[1], 0.5);
  EXPECT_EQ(turned("[7200000000000, 0, 0]"), (std::array<double, 4>{1, 0, 0, 0}));
}

TEST(Reading, DegreesAgreeWithTheSolversRadians) {
  const auto q =
      parsed(sample_with(R"("euler_zxz": [0, 0.5, 0])", R"("euler_zxz_deg": [10, -70, 1234.5])")).pair.body2.quaternion;
  const double degree = std::acos(-1.0) / 180;
  const auto expected = quaternion_from_euler_zxz<double>({10 * degree, -70 * degree, 1234.5 * degree});
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(q[i], expected[i], 1e-14);
}

TEST(Reading, PlacementIsMeasuredFromFirstTouch) {
  const auto placed = [](const std::string& placement) { return parsed(placed_sample(placement)).pair.body2.position; };
  EXPECT_EQ(placed(R"({"line_deg": [90, 0], "overlap_ratio": 0.25})"), (Vec3<double>{1.5, 0, 0}));
  EXPECT_EQ(placed(R"({"line_deg": [0, 0], "overlap_ratio": -0.5})"), (Vec3<double>{0, 0, 3}));
  EXPECT_EQ(placed(R"({"line_deg": [90, 90], "overlap_ratio": 0})"), (Vec3<double>{0, 2, 0}));
}

TEST(Reading, FindingWordsAreThoseOfTheLaws) {
  const auto words = finding_words();
  ASSERT_EQ(words.size(), static_cast<std::size_t>(FindingKind::none) + 1);
  for (std::size_t i = 0; i < words.size(); ++i) EXPECT_EQ(words[i], name(static_cast<FindingKind>(i)));
}

}  // namespace
}  // namespace plumb
