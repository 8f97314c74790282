// Answers by ladder and step: who lets go where.
#include "fuzz/results/ladders.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "fuzz/campaign/merge.hpp"
#include "fuzz/results/table.hpp"
#include "properties/generators/families.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

StepCounts one_answer(FindingKind kind, bool judged = true) {
  Contact<double> answer;
  answer.status = kind == FindingKind::nonconverged ? Status::stalled : Status::converged;
  Judgement judgement;
  judgement.judged = judged;
  judgement.finding.kind = kind;
  StepCounts step;
  step.add(answer, judgement);
  return step;
}

const StepCounts kRight = one_answer(FindingKind::none), kLost = one_answer(FindingKind::nonconverged),
                 kWrong = one_answer(FindingKind::misaligned), kUnjudged = one_answer(FindingKind::none, false);

TEST(Ladders, AStepCountsWhatWasAnswered) {
  StepCounts step;
  for (const StepCounts& one : {kRight, kRight, kLost, kWrong, kUnjudged}) step.merge(one);
  EXPECT_EQ(step.answers, 5u);
  EXPECT_EQ(step.judged(), 4u);
  EXPECT_EQ(step.not_converged, 1u);
  EXPECT_EQ(step.failures(), 2u);
}

TEST(Ladders, AMethodLetsGoAtTheEasiestStepWithAFinding) {
  EXPECT_EQ(lets_go({kRight, kUnjudged, kLost, kRight, kWrong}), 2u);
  EXPECT_EQ(lets_go({kWrong, kRight}), 0u);
  EXPECT_EQ(lets_go({kRight, kUnjudged, StepCounts{}}), std::nullopt);
}

TEST(Ladders, ACaseOfAStepCountsOnIt) {
  for (const std::string_view generator : hard_generators())
    for (std::size_t i = 0; i < ladder_steps(generator).size(); ++i) {
      Ladders ladders;
      StepCounts* const step = step_of_case(ladders, ladder_case(generator, i, 7, 0), "new_cn");
      EXPECT_EQ(step, &ladders.at(std::string(generator)).methods.at("new_cn")[i]) << generator << " " << i;
    }
}

TEST(Ladders, OtherCasesAreOnNone) {
  Ladders ladders;
  EXPECT_EQ(step_of_case(ladders, generate("spheroid", 7, 0), "new_cn"), nullptr);
  EXPECT_EQ(step_of_case(ladders, Case{}, "new_cn"), nullptr);
  EXPECT_TRUE(ladders.empty());
}

/// The family hard with one ladder of three steps: `auto` is right, new_cn misses the last.
FamilyResults made_up() {
  FamilyResults family;
  family.ladders["face_face"] = {
      "tilt", {1e-2, 2.5e-8, 0}, {{"auto", {kRight, kRight, kRight}}, {"new_cn", {kRight, kLost, kWrong}}}};
  for (const auto& [method, row] : family.ladders["face_face"].methods) {
    Tally& tally = family.generators["face_face"][method];
    for (const StepCounts& step : row) {
      ++tally.cases;
      ++tally.statuses[static_cast<std::size_t>(step.not_converged > 0 ? Status::stalled : Status::converged)];
      for (std::size_t i = 0; i < kFindingKinds; ++i) tally.findings[i] += step.findings[i];
    }
    family.methods[method] = tally;
  }
  return family;
}

TEST(Ladders, TheTableNamesTheValue) {
  const std::string text = ladders_text(made_up());
  EXPECT_NE(text.find(" lets go at                      auto     new_cn\n"), std::string::npos) << text;
  EXPECT_NE(text.find(" face_face                          -    2.5e-08\n"), std::string::npos) << text;
  EXPECT_EQ(ladders_text(FamilyResults{}), "");
}

TEST(Ladders, TheTableOfAllMethodsFillsItsColumns) {
  FamilyResults family = made_up();
  for (const char* method : {"geometric_potential_midway", "original_cn", "peer_libccd_epa", "an_unheardofsolver"})
    family.methods[method];
  const std::string text = ladders_text(family);
  EXPECT_NE(text.find("    _midway       _epa _unheardof\n"), std::string::npos) << text;
}

class LaddersOfShards : public testing::Test {
 protected:
  /// The folder of shard `number` of two.
  static std::string shard(std::uint64_t number, const FamilyResults& family) {
    Results results;
    results.asked = {7, {{"hard", 6}}, {"auto", "new_cn"}, "rounding", 2, {number}};
    results.families["hard"] = family;
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const fs::path folder =
        fs::path(testing::TempDir()) / (std::string("plumb_ladders_") + test->name() + std::to_string(number));
    prepare_folder(folder);
    write_results(results, folder);
    return folder.string();
  }

  static void expect_refused(const std::vector<std::string>& folders, const std::string& line) {
    try {
      (void)merge_folders(folders);
      ADD_FAILURE() << "not refused";
    } catch (const InputFailure& e) {
      EXPECT_EQ(e.what(), folders.back() + "/campaign.bins: " + line);
    }
  }
};

TEST_F(LaddersOfShards, AddUpInTheSummary) {
  const Json all = summary_json(merge_folders({shard(1, made_up()), shard(2, made_up())}))["x_ladders"]["face_face"];
  EXPECT_EQ(all["knob"], "tilt");
  EXPECT_EQ(all["steps"], Json({1e-2, 2.5e-8, 0.0}));
  EXPECT_EQ(all["methods"]["auto"]["lets_go"], nullptr);
  const Json& new_cn = all["methods"]["new_cn"];
  EXPECT_EQ(new_cn["answers"], Json({2, 2, 2}));
  EXPECT_EQ(new_cn["judged"], Json({2, 2, 2}));
  EXPECT_EQ(new_cn["not_converged"], Json({0, 2, 0}));
  EXPECT_EQ(new_cn["findings"], Json({{"nonconverged", {0, 2, 0}}, {"misaligned", {0, 0, 2}}, {"none", {2, 0, 0}}}));
  EXPECT_EQ(new_cn["lets_go"], Json({{"step", 2}, {"value", 2.5e-8}}));
}

TEST_F(LaddersOfShards, OfOtherStepsAreRefused) {
  FamilyResults other = made_up();
  other.ladders["face_face"].steps[1] = 1e-8;
  expect_refused({shard(1, made_up()), shard(2, other)},
                 "ladders.face_face: has other steps than in the folders before it");
}

TEST_F(LaddersOfShards, StepsThatAreNotTheWholeAreRefused) {
  FamilyResults other = made_up();
  other.ladders["face_face"].methods["new_cn"][0].merge(kRight);
  expect_refused({shard(1, other)},
                 "families.hard.ladders.face_face.methods.new_cn: does not add up to all of its answers");
  other = made_up();
  other.ladders["face_face"].methods["auto"].pop_back();
  expect_refused({shard(1, other)}, "families.hard.ladders.face_face.methods.auto: has counts of other steps");
  other = made_up();
  other.ladders["face_face"] = {};
  expect_refused({shard(1, other)}, "families.hard.ladders.face_face.steps: is empty");
}

}  // namespace
}  // namespace plumb
