// The laws along a motion: each can fail, auto breaks none on the frozen motions, and those files are what the generator writes.
#include "properties/generators/paths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "properties/generators/families.hpp"
#include "properties/laws/motion/path.hpp"
#include "properties/tests/kept_references.hpp"
#include "solver/method/methods.hpp"
#include "solver/pose.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb {
namespace {

const Path& path_named(std::string_view name) {
  return *std::find_if(paths().begin(), paths().end(), [&](const Path& path) { return path.name == name; });
}

std::vector<Pair> poses_of(const Path& path) {
  std::vector<Pair> out;
  for (const Case& step : steps_of(path)) out.push_back(step.pair);
  return out;
}

/// What a method's answers along a path break.
std::vector<PathFinding> findings_of(std::string_view method_name, const std::vector<Pair>& poses) {
  const Method* method = find_method(method_name);
  PathJudge judge(poses, kept_references());
  return judge_path(judge.follow(
      method->problem, [&](const Pair& pair, const Contact<double>* last) { return method->solve(pair, {}, last); }));
}

std::string in_words(const std::vector<PathFinding>& findings) {
  std::ostringstream out;
  for (const auto& [step, finding] : findings)
    out << step << ' ' << name(finding.kind) << ' ' << finding.law << ": " << finding.detail << '\n';
  return out.str();
}

/// Two crossed spheroids, one moved by 1e-6: the evidence that holds right answers, for one law to be broken at a time.
struct PathBench {
  std::vector<Pair> poses = crossed();
  PathJudge judge{poses};
  PathEvidence evidence = judge.follow(Problem::common_normal, [](const Pair& pair, const Contact<double>* last) {
    return find_method("auto")->solve(pair, {}, last);
  });

  PathStep& last() { return evidence.steps.back(); }
  [[nodiscard]] Vec3<double> across() const { return evidence.steps.back().cold.normal.unitOrthogonal(); }

  static std::vector<Pair> crossed(double distance = 1) {
    Pair pair;
    pair.body1.shape.semi_axes << 1, 1, 2;
    pair.body2.shape.semi_axes << 1, 1, 2;
    pair.body2.quaternion = {0.8, 0.5, 0.2, 0.1};
    pair.body2.position = distance * Vec3<double>(1.1, 0.9, 1.7);
    Pair moved = pair;
    moved.body2.position[0] += 1e-6;
    return {pair, moved};
  }
};

TEST(PathLaws, RightAnswersBreakNone) {
  const PathBench bench;
  EXPECT_TRUE(judge_path(bench.evidence).empty()) << in_words(judge_path(bench.evidence));
}

struct WrongStep {
  std::string_view law;
  FindingKind kind;
  std::function<void(PathBench&)> spoil;
};

std::vector<WrongStep> wrong_steps() {
  return {
      {"lipschitz", FindingKind::overlap_error, [](PathBench& b) { b.last().cold.overlap += 3e-6; }},
      {"lipschitz", FindingKind::overlap_error, [](PathBench& b) { b.last().cold.overlap -= 3e-6; }},
      {"no_flicker", FindingKind::missed_contact, [](PathBench& b) { b.last().cold.verdict = Verdict::separated; }},
      {"no_flicker", FindingKind::missed_contact, [](PathBench& b) { b.last().cold.verdict = Verdict::undecided; }},
      {"normal_follows", FindingKind::misaligned, [](PathBench& b) { b.last().cold.normal *= -1; }},
      {"normal_rate", FindingKind::misaligned, [](PathBench& b) { b.last().cold.normal += 1e-4 * b.across(); }},
      {"warm_is_cold", FindingKind::nondeterministic, [](PathBench& b) { b.last().warm.overlap += 1e-12; }},
      {"warm_is_cold", FindingKind::nondeterministic, [](PathBench& b) { b.last().warm.verdict = Verdict::undecided; }},
      {"warm_is_cold", FindingKind::nondeterministic,
       [](PathBench& b) { b.last().broken_warm = {FindingKind::misaligned, 2, "normal", "", 0}; }},
  };
}

TEST(PathLaws, EachRejectsAWrongAnswer) {
  std::set<std::string_view> tried;
  for (const WrongStep& wrong : wrong_steps()) {
    PathBench bench;
    wrong.spoil(bench);
    const std::vector<PathFinding> findings = judge_path(bench.evidence);
    const bool is_found = std::any_of(findings.begin(), findings.end(), [&](const PathFinding& found) {
      return found.step == 1 && found.finding.law == wrong.law && found.finding.kind == wrong.kind;
    });
    EXPECT_TRUE(is_found) << wrong.law << '\n' << in_words(findings);
    tried.insert(wrong.law);
  }
  EXPECT_EQ(tried.size(), path_laws().size());
}

TEST(PathLaws, BodiesApartMayNotBeCalledOverlapping) {
  PathBench bench{PathBench::crossed(1.2)};
  ASSERT_TRUE(judge_path(bench.evidence).empty()) << in_words(judge_path(bench.evidence));
  bench.last().cold.verdict = Verdict::overlapping;
  const std::vector<PathFinding> findings = judge_path(bench.evidence);
  ASSERT_FALSE(findings.empty());
  EXPECT_EQ(findings[0].finding.kind, FindingKind::false_contact) << in_words(findings);
  EXPECT_EQ(findings[0].finding.law, "no_flicker");
}

TEST(PathLaws, NoAnswerIsNonconvergedAtItsStep) {
  PathJudge judge(PathBench::crossed());
  const PathEvidence evidence =
      judge.follow(Problem::common_normal, [](const Pair&, const Contact<double>*) { return Contact<double>{}; });
  const std::vector<PathFinding> findings = judge_path(evidence);
  ASSERT_EQ(findings.size(), 2U) << in_words(findings);
  for (std::size_t step = 0; step < 2; ++step) {
    EXPECT_EQ(findings[step].step, step);
    EXPECT_EQ(findings[step].finding.kind, FindingKind::nonconverged);
  }
}

/// o(n), as the laws' theorem has it.
double overlap_at(const Pair& pair, const Vec3<double>& n) {
  const PlacedPair<double> placed = place<double>(pair);
  const double support1 = support<double>(placed.body1.shape, placed.body1.to_body_direction(n));
  const double support2 = support<double>(placed.body2.shape, placed.body2.to_body_direction(-n));
  return placed.to_world_length(support1 + support2 - n.dot(placed.body2.centre));
}

TEST(Displacement, BoundsTheChangeOfTheOverlapInEveryDirection) {
  for (std::uint64_t i = 0; i < 400; ++i) {
    const Case from = generate("superquadric", 3, i), to = generate("superquadric", 4, i);
    Pair moved = from.pair;
    moved.body1.quaternion = to.pair.body1.quaternion;
    moved.body2.quaternion = to.pair.body2.quaternion;
    moved.body2.position = to.pair.body2.position;
    Stream stream("displacement", 1, i);
    for (int k = 0; k < 20; ++k) {
      const Vec3<double> n = random_direction(stream);
      EXPECT_LE(std::abs(overlap_at(moved, n) - overlap_at(from.pair, n)), displacement(from.pair, moved) + 1e-14);
    }
  }
}

TEST(Displacement, IsNoneOfACommonShiftAndTheLengthOfAShift) {
  const Pair from = PathBench::crossed()[0];
  Pair to = from;
  for (Body* body : {&to.body1, &to.body2}) body->position += Vec3<double>(1, 2, 3);
  EXPECT_LT(displacement(from, to), 1e-15);
  to.body2.position[1] += 0.25;
  EXPECT_NEAR(displacement(from, to), 0.25, 1e-15);
  EXPECT_NEAR(relative_motion(from, to), 0.125, 1e-15);
  Pair turned = to;
  turned.body1.quaternion = {1, 0, 0, 1e-9};
  EXPECT_NEAR(relative_motion(turned, to), 2e-9, 1e-18);
}

TEST(Paths, AreLegalNamedAndRecorded) {
  std::set<std::string_view> names;
  for (const Path& path : paths()) {
    EXPECT_TRUE(names.insert(path.name).second) << path.name;
    const std::vector<Case> steps = steps_of(path);
    EXPECT_GE(steps.size(), 30U) << path.name;
    EXPECT_LE(steps.size(), 80U) << path.name;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      EXPECT_TRUE(is_valid(steps[i].pair)) << steps[i].name;
      EXPECT_EQ(steps[i].provenance.at("path"), path.name);
      EXPECT_EQ(steps[i].provenance.at("step"), i);
      EXPECT_EQ(steps[i].provenance.at("steps"), steps.size());
      EXPECT_GT(steps[i].provenance.size(), 3U) << "what is steered";
    }
  }
}

TEST(Paths, AreTheFrozenOnes) {
  const std::filesystem::path folder = PLUMB_SOURCE_DIR "/corpus/cases/hard/paths";
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files += entry.path().extension() == ".jsonl";
  EXPECT_EQ(files, paths().size());
  for (const Path& path : paths()) {
    std::ifstream in(folder / (std::string(path.name) + ".jsonl"));
    std::ostringstream frozen;
    frozen << in.rdbuf();
    EXPECT_EQ(frozen.str(), format_steps(steps_of(path))) << path.name << ": plumb path --write " << folder;
  }
}

class AlongPath : public testing::TestWithParam<std::size_t> {};

TEST_P(AlongPath, AutoBreaksNoLaw) {
  const std::vector<PathFinding> findings = findings_of("auto", poses_of(paths()[GetParam()]));
  EXPECT_TRUE(findings.empty()) << in_words(findings);
}

INSTANTIATE_TEST_SUITE_P(Paths, AlongPath, testing::Range<std::size_t>(0, paths().size()), [](const auto& info) {
  std::string word(paths()[info.param].name);
  std::replace(word.begin(), word.end(), '.', '_');
  return word;
});

/// How often each law is broken.
std::map<std::string, int> broken_laws(std::string_view method, std::string_view path) {
  std::map<std::string, int> out;
  for (const PathFinding& found : findings_of(method, poses_of(path_named(path)))) ++out[found.finding.law];
  return out;
}

TEST(PathLaws, FindWhatPublishedMethodsDoWrong) {
  std::map<std::string, int> new_cn = broken_laws("new_cn", "spin_about_axis_0.6");
  for (const char* law : {"lipschitz", "normal_follows", "normal_rate", "warm_is_cold"})
    EXPECT_GT(new_cn[law], 0) << law;
  EXPECT_GT(broken_laws("original_cn", "slide_over_edge_4")["no_flicker"], 0);
}

}  // namespace
}  // namespace plumb
