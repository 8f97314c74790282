// `plumb doctor`: adapters with planted mistakes are told them, right ones are sane, and nobody is told what is not so.
#include <gtest/gtest.h>

#include <cstdlib>

#include "properties/doctor/diagnosis.hpp"
#include "properties/tests/corpus/programs.hpp"
#include "solver/reference/reference.hpp"

namespace plumb::doctor {
namespace {

const std::string kTests = std::string(PLUMB_BINARY_DIR) + "/tests/";
const std::string kMistaken = kTests + "foreign_mistaken.so";

/// The library that makes these mistakes and claims this; both are read from the environment at each call.
class Doctor : public Commands {
 protected:
  void TearDown() override {
    ::unsetenv("PLUMB_MISTAKE");
    ::unsetenv("PLUMB_CLAIMS");
    Commands::TearDown();
  }
  static Diagnosis examine(const std::string& mistakes, const std::string& claims = "") {
    ::setenv("PLUMB_MISTAKE", mistakes.c_str(), 1);
    ::setenv("PLUMB_CLAIMS", claims.c_str(), 1);
    return diagnose(load_solver_in_process(kMistaken));
  }
  [[nodiscard]] Ran run_doctor(const std::string& mistakes, const std::string& options = "") const {
    ::setenv("PLUMB_MISTAKE", mistakes.c_str(), 1);
    return plumb("doctor --solver " + kMistaken + " " + options + " 2>&1");
  }
};

TEST_F(Doctor, EveryQuestionIsCertifiedAndHasOneAnswer) {
  const std::vector<Question> all = all_questions(), asked = questions_for({});
  ASSERT_EQ(asked.size(), all.size());
  for (const Question& question : asked) {
    SCOPED_TRACE(question.words);
    const Reference reference = find_reference(question.pair, Effort::proof);
    EXPECT_EQ(reference.global, Claim::proved);
    EXPECT_EQ(reference.unique, Claim::proved);
    EXPECT_EQ(reference.verdict, question.truth.verdict);
    EXPECT_LT(reference.common_normal.condition.normal, 20);
  }
}

TEST_F(Doctor, OtherProblemsHaveQuestionsOfEachKind) {
  for (const Problem problem : {Problem::deepest_points, Problem::midway}) {
    Abilities abilities;
    abilities.problem = problem;
    int of_kind[3] = {};
    for (const Question& question : questions_for(abilities)) ++of_kind[static_cast<int>(question.kind)];
    EXPECT_GE(of_kind[0], 8) << name(problem);
    EXPECT_GE(of_kind[1], 3) << name(problem);
    EXPECT_GE(of_kind[2], 1) << name(problem);
  }
}

TEST_F(Doctor, ASaneAdapterIsSane) {
  for (const char* claims : {"", "spheres", "ellipsoids", "apart_none", "apart_verdict", "midway", "no_points",
                             "no_normal", "deepest_points", "midway_problem"}) {
    const Diagnosis d = examine("", claims);
    EXPECT_TRUE(d.sane) << claims << ": " << d.said.sentence;
    EXPECT_FALSE(d.evidence) << claims;
    EXPECT_GE(d.replies.size(), 5U) << claims;
  }
}

TEST_F(Doctor, OneOfLittleAccuracyIsSaneAndToldHowLittle) {
  const Diagnosis d = examine("noise");
  ASSERT_TRUE(d.sane) << d.said.sentence;
  EXPECT_GT(d.worst.overlap, 3e-5);
  EXPECT_LT(d.worst.overlap, 3e-4);
  EXPECT_GT(d.worst.normal, 3e-5);
  EXPECT_LT(d.worst.normal, 3e-4);
  EXPECT_EQ(examine("coarse").said.word, "coarse");
  EXPECT_TRUE(examine("coarse", "tolerance").sane);
}

struct Planted {
  const char *mistake, *word;
};

TEST_F(Doctor, EachPlantedMistakeIsNamed) {
  const Planted all[] = {{"normal_reversed", "normal_reversed"},
                         {"normal_in_body1", "normal_in_body1"},
                         {"normal_in_body2", "normal_in_body2"},
                         {"normal_long", "normal_length"},
                         {"normal_of_length_3", "normal_length"},
                         {"normal_along_centres", "normal_along_centres"},
                         {"depth_negative", "depth_negative"},
                         {"depth_negative_and_verdict", "depth_negative"},
                         {"distance_positive", "distance_positive"},
                         {"overlap_half", "overlap_factor"},
                         {"overlap_in_millimetres", "overlap_factor"},
                         {"all_in_millimetres", "lengths_factor"},
                         {"all_over_size", "unit_lost"},
                         {"always_overlapping", "always_overlapping"},
                         {"verdict_reversed", "verdict_reversed"},
                         {"verdict_missing", "verdict_missing"},
                         {"points_exchanged", "points_exchanged"},
                         {"bodies_exchanged", "bodies_exchanged"},
                         {"points_from_body1", "points_from_body1"},
                         {"points_in_body1", "points_in_body1"},
                         {"points_in_bodies", "points_in_bodies"},
                         {"all_in_body1", "all_in_body1"},
                         {"one_point", "one_point"},
                         {"contact_point_at_centre", "contact_point"},
                         {"quaternion_xyzw", "quaternion_order"},
                         {"quaternion_wxyz", "quaternion_order"},
                         {"quaternion_length", "quaternion_length"},
                         {"rotation_inverted", "rotation_inverted"},
                         {"rotation_ignored", "rotation_ignored"},
                         {"rotation_twice", "rotation_of_body1_twice"},
                         {"degrees_rpy", "degrees"},
                         {"degrees_zxz", "degrees"},
                         {"degrees_vector", "degrees"},
                         {"twice_as_large", "twice_as_large"},
                         {"half_as_large", "half_as_large"},
                         {"axes_sorted_away", "axes_order"},
                         {"shape_twice", "shape_of_body1_twice"},
                         {"exponents_exchanged", "exponents_exchanged"},
                         {"exponents_inverted", "exponents_inverted"},
                         {"exponents_ignored", "exponents_ignored"},
                         {"position1_ignored", "position1_ignored"},
                         {"position2_from_body1", "position2_from_body1"},
                         {"line_not_turned", "line_not_turned"},
                         {"absolute_tolerance", "unit"},
                         {"far_from_origin", "far_from_origin"},
                         {"nan_points", "not_finite"},
                         {"status_missing", "status_missing"},
                         {"refuses_all", "refuses_all"},
                         {"refuses_exponents", "exponents"},
                         {"refuses_ellipsoids", "shapes"},
                         {"refuses_apart", "apart"},
                         {"refuses_ellipsoids+refuses_apart", "refuses_many"},
                         {"two_answers", "nondeterministic"}};
  for (const auto& [mistake, word] : all) {
    const Diagnosis d = examine(mistake);
    EXPECT_FALSE(d.sane) << mistake;
    EXPECT_EQ(d.said.word, word) << mistake << ": " << d.said.sentence;
    EXPECT_TRUE(d.evidence) << mistake;
    EXPECT_TRUE(d.others.empty()) << mistake << " or " << d.others.front().word;
  }
}

TEST_F(Doctor, AnglesReadAsDegreesAreNextToNone) {
  const Diagnosis d = examine("radians_rpy");
  EXPECT_TRUE(d.said.word == "radians" || d.said.word == "rotation_ignored") << d.said.word << d.said.sentence;
}

TEST_F(Doctor, LimitedSolversAreToldTheirMistakesToo) {
  const Planted spheres[] = {{"normal_reversed", "normal_reversed"},   {"normal_in_body1", "normal_in_body1"},
                             {"depth_negative", "depth_negative"},     {"twice_as_large", "twice_as_large"},
                             {"points_exchanged", "points_exchanged"}, {"all_in_millimetres", "lengths_factor"}};
  for (const auto& [mistake, word] : spheres) EXPECT_EQ(examine(mistake, "spheres").said.word, word);
  for (const char* claims :
       {"ellipsoids", "apart_none", "apart_verdict", "midway", "no_points", "deepest_points", "midway_problem"})
    for (const auto& [mistake, word] : {Planted{"normal_reversed", "normal_reversed"},
                                        {"depth_negative", "depth_negative"},
                                        {"normal_in_body1", "normal_in_body1"},
                                        {"rotation_inverted", "rotation_inverted"},
                                        {"quaternion_xyzw", "quaternion_order"}})
      EXPECT_EQ(examine(mistake, claims).said.word, word) << claims;
  EXPECT_EQ(examine("rotation_inverted", "no_normal").said.word, "rotation_inverted");
  EXPECT_EQ(examine("points_in_body1", "midway").said.word, "points_in_body1");
}

TEST_F(Doctor, MistakesThatNothingClaimedTellsApartAreAllNamed) {
  const Diagnosis reversed = examine("bodies_exchanged", "no_points");
  EXPECT_EQ(reversed.said.word, "normal_reversed");
  ASSERT_EQ(reversed.others.size(), 1U);
  EXPECT_EQ(reversed.others.front().word, "bodies_exchanged");
  const Diagnosis apart = examine("half_as_large", "apart_verdict");
  EXPECT_EQ(apart.said.word, "always_separated");
  ASSERT_EQ(apart.others.size(), 1U);
  EXPECT_EQ(apart.others.front().word, "half_as_large");
}

TEST_F(Doctor, TwoMistakesAreBothNamed) {
  for (const auto& [mistake, word] : {Planted{"normal_reversed+depth_negative", "normal_reversed+depth_negative"},
                                      {"rotation_inverted+points_exchanged", "rotation_inverted+points_exchanged"},
                                      {"twice_as_large+normal_in_body1", "twice_as_large+normal_in_body1"}}) {
    const Diagnosis d = examine(mistake);
    const std::size_t plus = d.said.word.find('+');
    ASSERT_NE(plus, std::string::npos) << mistake << ": " << d.said.sentence;
    const std::string turned = d.said.word.substr(plus + 1) + "+" + d.said.word.substr(0, plus);
    EXPECT_TRUE(d.said.word == word || turned == word) << mistake << ": " << d.said.word;
    EXPECT_NE(d.said.sentence.find(" And: "), std::string::npos);
  }
}

/// What is said of two mistakes without the words that are true of them. Some two are a third one by its definition.
std::string falsely_said(std::string said, const Planted& first, const Planted& second) {
  if (said == "bodies_exchanged") said = "normal_reversed+points_exchanged";
  if (said == "all_in_body1") said = "normal_in_body1+points_in_body1";
  for (const char* word : {first.word, second.word})
    if (const std::size_t at = said.find(word); at != std::string::npos) said.erase(at, std::string(word).size());
  return said == "+" ? "" : said;
}

TEST_F(Doctor, NobodyIsToldAMistakeThatHeDoesNotMake) {
  const Planted all[] = {{"normal_reversed", "normal_reversed"},
                         {"normal_in_body1", "normal_in_body1"},
                         {"depth_negative", "depth_negative"},
                         {"overlap_half", "overlap_factor"},
                         {"points_exchanged", "points_exchanged"},
                         {"points_in_body1", "points_in_body1"},
                         {"quaternion_xyzw", "quaternion_order"},
                         {"rotation_inverted", "rotation_inverted"},
                         {"degrees_zxz", "degrees"},
                         {"twice_as_large", "twice_as_large"},
                         {"shape_twice", "shape_of_body1_twice"},
                         {"exponents_exchanged", "exponents_exchanged"},
                         {"exponents_ignored", "exponents_ignored"},
                         {"absolute_tolerance", "unit"},
                         {"position1_ignored", "position1_ignored"},
                         {"line_not_turned", "line_not_turned"}};
  int named = 0;
  for (const Planted& first : all)
    for (const Planted& second : all) {
      if (&first >= &second) continue;
      const Diagnosis d = examine(std::string(first.mistake) + "+" + second.mistake);
      EXPECT_FALSE(d.sane);
      EXPECT_EQ(falsely_said(d.said.word, first, second), "") << first.mistake << ", " << second.mistake;
      named += !d.said.word.empty();
    }
  EXPECT_GE(named, 70);  // all but those where both are of the pair that is handed on
}

TEST_F(Doctor, ThreeMistakesAreNotExplainedByTwo) {
  for (const char* three :
       {"normal_reversed+depth_negative+points_in_body1", "quaternion_xyzw+twice_as_large+shape_twice",
        "rotation_inverted+normal_in_body2+overlap_half"}) {
    const Diagnosis d = examine(three);
    EXPECT_FALSE(d.sane);
    EXPECT_EQ(d.said.word, "") << three;
    EXPECT_TRUE(d.evidence);
  }
}

TEST_F(Doctor, OneWrongAnswerProvesNoMistake) {
  const Diagnosis d = examine("distance_positive_once", "spheres");
  EXPECT_FALSE(d.sane);
  EXPECT_NE(d.said.word, "distance_positive") << d.said.sentence;
  EXPECT_EQ(d.questions.at(d.evidence.value_or(0)).words, "two spheres apart");
}

TEST_F(Doctor, OneThatIsWrongInNoUsualWayIsToldWhere) {
  const Ran ran = plumb("doctor --solver " + kTests + "foreign_example.so");
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.out.find("Right on 8 of 8 pairs of spheres, 0 of 9 of ellipsoids, 0 of 4 of superellipsoids; no usual"),
            std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("  expected  overlapping, overlap 0.218901"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("  got       overlapping, overlap 1.2"), std::string::npos) << ran.out;
}

TEST_F(Doctor, TheCommandSaysItByItsExitCode) {
  const Ran sane = run_doctor("");
  EXPECT_EQ(sane.code, 0);
  EXPECT_TRUE(sane.out.starts_with("solver:mistaken: Sane: right on 21 of 21 pairs")) << sane.out;
  const Ran wrong = run_doctor("normal_reversed");
  EXPECT_EQ(wrong.code, 1);
  EXPECT_TRUE(wrong.out.starts_with("solver:mistaken: All normals point from body 2 to body 1")) << wrong.out;
  EXPECT_NE(wrong.out.find("normal (-0.48, 0.6, -0.64)"), std::string::npos) << wrong.out;
  expect_refusal("doctor", "plumb doctor: --solver: or --solver-command is missing");
  EXPECT_EQ(plumb("doctor --solver nowhere.so 2>/dev/null").code, 2);
}

TEST_F(Doctor, TheJsonHoldsWhatTheTextSays) {
  const Json sane = Json::parse(run_doctor("noise", "--json").out);
  EXPECT_EQ(sane.at("solver"), "solver:mistaken");
  EXPECT_EQ(sane.at("sane"), true);
  EXPECT_TRUE(sane.at("mistake").is_null());
  EXPECT_EQ(sane.at("pairs").at("spheres"), Json::parse(R"({"asked": 8, "answered": 8, "right": 8})"));
  EXPECT_GT(sane.at("worst").at("normal_deg"), 0.001);
  EXPECT_FALSE(sane.contains("evidence"));
  const Json wrong = Json::parse(run_doctor("depth_negative", "--json").out);
  EXPECT_EQ(wrong.at("sane"), false);
  EXPECT_EQ(wrong.at("mistake"), "depth_negative");
  EXPECT_EQ(wrong.at("pairs").at("spheres").at("right"), 0);
  EXPECT_EQ(wrong.at("evidence").at("bodies").size(), 2U);
  EXPECT_EQ(wrong.at("evidence").at("expected").at("overlap").get<double>(),
            -wrong.at("evidence").at("got").at("overlap").get<double>());
}

TEST_F(Doctor, OneThatEndsOrHangsIsToldWithWhichPair) {
  const Ran crash = run_doctor("crash_apart");
  EXPECT_EQ(crash.code, 1);
  EXPECT_NE(crash.out.find("There is no answer to two spheres apart: ended by signal 6"), std::string::npos)
      << crash.out;
  const Ran hang = run_doctor("hang_apart", "--solver-limit 0.05 --json");
  EXPECT_EQ(hang.code, 1);
  EXPECT_EQ(Json::parse(hang.out).at("mistake"), "slow") << hang.out;
}

}  // namespace
}  // namespace plumb::doctor
