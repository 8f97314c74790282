// Seeded bugs: every row of the table fits the solver's sources and one that does not is named, no program holds a bug, and
// the engines that hunt them kill what is wrong, at its first run, and nothing else.
#include "reports/kills/table.hpp"

#include <fmt/format.h>

#include <cfenv>
#include <cmath>

#include "fuzz/bugs/seeded_bugs.hpp"
#include "properties/doors/host_modes.hpp"
#include "properties/generators/families.hpp"
#include "properties/generators/paths.hpp"
#include "properties/generators/shapes.hpp"
#include "properties/tests/corpus/programs.hpp"
#include "solver/method/convex.hpp"
#include "solver/method/methods.hpp"

namespace plumb::reports {
namespace {

class SeededBugs : public Commands {
 protected:
  [[nodiscard]] Ran seed(const std::string& tables) const {
    const std::string source = PLUMB_SOURCE_DIR;
    return run(fmt::format("cmake -D SOURCE={} -D 'TABLES={}' -D OUT={} -P {}/fuzz/bugs/seed.cmake 2>&1", source,
                           tables, (path_ / "seeded").string(), source));
  }
  [[nodiscard]] static std::string tables() {
    std::string out;
    for (const auto& entry : fs::directory_iterator(std::string(PLUMB_SOURCE_DIR) + "/fuzz/bugs"))
      if (entry.path().extension() == ".json") out += (out.empty() ? "" : ";") + entry.path().string();
    return out;
  }
  void expect_refused(const std::string& row, const std::string& reason) const {
    const Ran ran = seed(file("t.json", "[" + row + "]"));
    EXPECT_NE(ran.code, 0) << row;
    EXPECT_NE(ran.out.find("a-bug: " + reason), std::string::npos) << ran.out;
  }
};

TEST_F(SeededBugs, EveryRowFitsTheSources) {
  const Ran ran = seed(tables());
  ASSERT_EQ(ran.code, 0) << ran.out;
  EXPECT_GE(std::ranges::count(read("seeded/bugs.inc"), '{'), 40);
}

TEST_F(SeededBugs, ARowThatNoLongerFitsIsNamed) {
  const auto row = [](const std::string& right) {
    return R"({"name": "a-bug", "kind": "k", "seen": "s", "file": "contact.hpp", "wrong": "x", "right": ")" + right +
           R"("})";
  };
  expect_refused(row("no such text"), "in solver/contact.hpp, what it would find, is not there");
  expect_refused(row("template"), "in solver/contact.hpp, what it would find, is there more than once");
  expect_refused(R"({"name": "a-bug", "kind": "k", "file": "contact.hpp"})", "has no seen");
  expect_refused(row("swapped(const Pair& pair)") + "," + row("size_of(const Pair& pair)"),
                 "no name for a bug, or another's");
}

/// Whether the file has the mark of the library of seeded bugs.
bool is_marked(const fs::path& path) {
  std::string bytes(fs::file_size(path), '\0');
  std::ifstream(path, std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes.find(PLUMB_SEEDED_BUGS_MARK) != std::string::npos;
}

TEST_F(SeededBugs, NoProgramHoldsOne) {
  ASSERT_TRUE(is_marked(file("marked", std::string("\0ELF", 4) + PLUMB_SEEDED_BUGS_MARK)));
  std::size_t programs = 0;
  for (const char* folder : {"/bin", "/bin/peers", "/bin/variants", "/solver"})
    for (const auto& entry : fs::directory_iterator(PLUMB_BINARY_DIR + std::string(folder))) {
      // The tests know the mark, to look for it.
      if (!entry.is_regular_file() || entry.path().filename().string().starts_with("test_")) continue;
      ++programs;
      EXPECT_FALSE(is_marked(entry.path())) << entry.path();
    }
  EXPECT_GT(programs, 10u);
}

/// auto, and bugs that are told apart by what they do to its answers.
SeededSolver solver_with(const std::vector<std::function<void(Contact<double>&, const Pair&, bool warm)>>& bugs) {
  SeededSolver out;
  for (std::size_t i = 0; i < bugs.size(); ++i) out.bugs.push_back({fmt::format("bug-{}", i + 1), "k", "f", "s", ""});
  out.solve = [bugs](std::size_t bug, const Pair& pair, const Want& want, const Contact<double>* last) {
    Contact<double> answer = find_method("auto")->solve(pair, want, last);
    if (bug > 0) bugs[bug - 1](answer, pair, last != nullptr);
    return answer;
  };
  return out;
}

Case drawn(std::size_t i) {
  return generate("ellipsoid", 1, i);
}

TEST(KillEngines, AWrongAnswerDiesAtItsFirstCaseWhateverTheThreads) {
  const double third = drawn(2).pair.body2.position[0];
  const SeededSolver seeded = solver_with({
      [](Contact<double>&, const Pair&, bool) {},
      [](Contact<double>& answer, const Pair&, bool) { answer.overlap += 1e-9 * std::abs(answer.overlap); },
      [&](Contact<double>& answer, const Pair& pair, bool) {
        if (pair.body2.position[0] == third) answer.status = Status::stalled;
      },
  });
  for (const unsigned threads : {1u, 3u}) {
    const Hunt hunt = hunt_cases({seeded, {1, 2, 3}, threads}, 6, drawn);
    EXPECT_EQ(hunt.control_findings, 0u);
    EXPECT_EQ(hunt.kills[0].run, 0u);
    EXPECT_FALSE(hunt.kills[0].changed);
    EXPECT_EQ(hunt.kills[1].run, 1u);
    EXPECT_TRUE(hunt.kills[1].changed);
    EXPECT_TRUE(hunt.kills[1].finding.starts_with("overlap_error")) << hunt.kills[1].finding;
    EXPECT_EQ(hunt.kills[2].run, 3u);
    EXPECT_EQ(hunt.kills[2].finding, "nonconverged (converges)");
  }
}

TEST(KillEngines, AControlThatIsNotAutoIsRefused) {
  SeededSolver seeded = solver_with({});
  seeded.solve = [](std::size_t, const Pair& pair, const Want& want, const Contact<double>* last) {
    Contact<double> answer = find_method("auto")->solve(pair, want, last);
    answer.overlap = std::nextafter(answer.overlap, 1);
    return answer;
  };
  EXPECT_THROW((void)hunt_cases({seeded, {}, 1}, 1, drawn), ControlDiffers);
}

TEST(KillEngines, ABugOfAShapeDiesAtItsFirstPair) {
  SeededSolver seeded = solver_with({});
  seeded.solve_convex = [](std::size_t bug, const ConvexPair& pair) {
    Contact<double> answer = solve_convex(pair, {}, nullptr);
    const bool has_box = std::holds_alternative<Box>(pair.body1.shape) || std::holds_alternative<Box>(pair.body2.shape);
    if (bug == 1 && has_box) answer.point2[0] += 1e-9;
    return answer;
  };
  const auto draw = [](std::size_t i) {
    Stream stream("kills", 1, i);
    return draw_shape_pair({1, i == 3 ? 5UL : 1UL}, stream);
  };
  const Hunt hunt = hunt_shapes({seeded, {1}, 2}, 5, draw);
  EXPECT_EQ(hunt.control_findings, 0u);
  EXPECT_EQ(hunt.kills[0].run, 4u);
  seeded.solve_convex = [](std::size_t, const ConvexPair&) { return Contact<double>{}; };
  EXPECT_THROW((void)hunt_shapes({seeded, {1}, 1}, 1, draw), ControlDiffers);
}

Track motion(std::size_t steps) {
  Track out;
  for (const Case& step : steps_of(paths().front())) out.push_back(step.pair);
  out.resize(steps);
  return out;
}

TEST(KillEngines, AWarmStartThatIsStaleDiesAtTheSecondStep) {
  const SeededSolver seeded = solver_with({
      [](Contact<double>& answer, const Pair&, bool warm) {
        if (warm) answer.overlap += 1e-6;
      },
      [](Contact<double>&, const Pair&, bool) {},
  });
  const Hunt hunt = hunt_motions({seeded, {1, 2}, 2}, {motion(1), motion(3)});
  EXPECT_EQ(hunt.runs, 4u);
  EXPECT_EQ(hunt.kills[0].run, 3u);
  EXPECT_EQ(hunt.kills[1].run, 0u);
}

TEST(KillEngines, WorkDiesBeyondItsBoundsAlone) {
  const SeededSolver seeded = solver_with({
      [](Contact<double>& answer, const Pair&, bool) { answer.evaluations *= 2; },
      [](Contact<double>& answer, const Pair&, bool) { answer.iterations = 0; },
      [](Contact<double>& answer, const Pair&, bool) { answer.overlap = 0; },
  });
  int evaluations = 0, iterations = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Contact<double> answer = find_method("auto")->solve(drawn(i).pair, {}, nullptr);
    evaluations += answer.evaluations;
    iterations += answer.iterations;
  }
  const Hunt hunt = hunt_work({seeded, {1, 2, 3}, 2}, {{"a", {drawn(0).pair, drawn(1).pair}, false}});
  EXPECT_EQ(hunt.kills[0].finding, fmt::format("a: {} evaluations for {}, {} iterations for {}", 2 * evaluations,
                                               evaluations, iterations, iterations));
  EXPECT_EQ(hunt.kills[1].run, 2u);
  EXPECT_EQ(hunt.kills[2].run, 0u);
}

TEST(KillEngines, WhatDependsOnTheHostsModeDies) {
  const SeededSolver seeded = solver_with({
      [](Contact<double>& answer, const Pair&, bool) { answer.overlap = std::nearbyint(2.5); },
      [](Contact<double>&, const Pair&, bool) { std::fesetround(FE_TONEAREST); },
      [](Contact<double>& answer, const Pair&, bool) { answer.overlap = 0; },
  });
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < host_modes().size(); ++i) pairs.push_back(drawn(i).pair);
  const Hunt hunt = hunt_in_modes({seeded, {1, 2, 3}}, pairs);
  EXPECT_EQ(hunt.control_findings, 0u);
  EXPECT_TRUE(hunt.kills[0].finding.starts_with("other bits in another mode")) << hunt.kills[0].finding;
  EXPECT_TRUE(hunt.kills[1].finding.starts_with("the host's mode is not put back")) << hunt.kills[1].finding;
  EXPECT_EQ(hunt.kills[2].run, 0u);
}

TEST(KillEngines, NoIterationsAreAsManyAsNone) {
  Pair spheres;
  spheres.body2.position << 0, 0, 1.5;
  ASSERT_EQ(find_method("auto")->solve(spheres, {}, nullptr).iterations, 0);
  const SeededSolver seeded = solver_with({[](Contact<double>&, const Pair&, bool) {}});
  EXPECT_EQ(hunt_work({seeded, {1}, 1}, {{"spheres", {spheres}, false}}).kills[0].run, 0u);
}

TEST(KillTable, MediansOverSeedsCountWhatSurvivedAsLater) {
  const EngineHunts engine{"e", "cases", {{9, {{3, "f", true}}, 0}, {9, {{0, "", true}}, 0}, {9, {{1, "f", true}}, 0}}};
  const Killed found = killed(engine, 0);
  EXPECT_EQ(found.kills, 2u);
  EXPECT_EQ(found.least, 1u);
  EXPECT_EQ(found.median, 3u);
  EXPECT_EQ(found.greatest, 0u);
  EXPECT_NE(kill_table({{"bug-1", "k", "f", "s", ""}}, {engine}).find("3 [1, >9]"), std::string::npos);
}

TEST(KillTable, ComplainsOfSurvivorsWithoutAReasonAndOfReasonsThatAreRefuted) {
  const Bugs bugs{{"dead", "k", "f", "s", ""},
                  {"alive", "k", "f", "s", ""},
                  {"explained", "k", "f", "s", "changes nothing"},
                  {"refuted", "k", "f", "s", "changes nothing"}};
  const std::vector<EngineHunts> engines{{"e", "cases", {{1, {{1, "f", true}, {}, {}, {1, "f", true}}, 0}}}};
  const std::vector<std::string> found = complaints(bugs, engines);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_TRUE(found[0].starts_with("alive "));
  EXPECT_TRUE(found[1].starts_with("refuted "));
}

}  // namespace
}  // namespace plumb::reports
