// A shrunk case keeps its finding, nothing simpler does, and what is said of it is true when it is tried by hand.
#include "fuzz/shrink/shrink.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <stdexcept>

#include "fuzz/results/failure_store.hpp"
#include "fuzz/shrink/explain.hpp"
#include "properties/generators/families.hpp"
#include "properties/tests/corpus/programs.hpp"
#include "properties/tests/draws.hpp"

namespace plumb {
namespace {

constexpr std::uint64_t kShrinkSeed = 1;

struct Failing {
  Case c;
  Solver solver;
};

FindingKind kind_of(const Pair& pair, const Solver& solver) {
  Judge judge(pair);
  return solve_and_judge(judge, pair, solver).judgement.finding.kind;
}

/// Of each published method the first failure of each kind among some of three families; by day each second of these.
const std::vector<Failing>& failing() {
  static const std::vector<Failing> all = [] {
    std::vector<Failing> out;
    int found = 0;
    for (const Solver& solver : find_solvers("original_cn,corrected_cn,new_cn,minimum_distance,geometric_potential,"
                                             "geometric_potential_midway,first_touch")) {
      std::set<FindingKind> seen{FindingKind::none};
      for (const char* family : {"spheroid", "ellipsoid", "superquadric"})
        for (std::uint64_t i = 0; i < draws(40, 12); ++i) {
          Case c = generate(family, kShrinkSeed, i);
          if (!seen.insert(kind_of(c.pair, solver)).second) continue;
          if (is_nightly() || found++ % 2 == 0) out.push_back({std::move(c), solver});
        }
    }
    return out;
  }();
  return all;
}

Case in_file(const Described& described) {
  Json text{{"format", "plumb/case-1"}, {"name", "by hand"}};
  text.update(described_json(described));
  return parse_case(write_json(text), "by hand");
}

TEST(Shrink, ThereIsSomethingToShrink) {
  std::set<FindingKind> kinds;
  for (const auto& [c, solver] : failing()) kinds.insert(kind_of(c.pair, solver));
  EXPECT_GE(kinds.size(), 3u);
}

TEST(Shrink, KeepsTheFindingAndHalfOfItsSeverity) {
  for (const auto& [c, solver] : failing()) {
    const Shrunk shrunk = shrink(c.pair, solver);
    Judge judge(shrunk.pair);
    const Finding again = solve_and_judge(judge, shrunk.pair, solver).judgement.finding;
    EXPECT_EQ(again.kind, shrunk.from.judgement.finding.kind) << c.name << ' ' << solver.name;
    EXPECT_GE(again.severity, shrunk.from.judgement.finding.severity / 2) << c.name << ' ' << solver.name;
    EXPECT_TRUE(in_domain(shrunk.pair)) << c.name;
    EXPECT_LE(cost(shrunk.described), cost({c.pair, {}, {}})) << c.name;
    if (!c.name.starts_with("superquadric")) {
      EXPECT_LE(simplicity(shrunk.pair)[0], simplicity(c.pair)[0]) << c.name;
    }
    EXPECT_EQ(shrunk.stopped, shrunk.counts.work >= most_work) << c.name;
  }
}

/// The first of a family whose normal is as far off as that.
Pair far_off(const char* family, const Solver& solver, double least_degrees) {
  for (std::uint64_t i = 0; i < 500; ++i) {
    const Pair pair = generate(family, kShrinkSeed, i).pair;
    Judge judge(pair);
    const Judgement judgement = solve_and_judge(judge, pair, solver).judgement;
    if (judgement.finding.kind == FindingKind::misaligned && judgement.angle_error_deg > least_degrees) return pair;
  }
  throw std::runtime_error("none is as far off");
}

TEST(Shrink, AHundredDegreesStayMoreThanFifty) {
  const Solver solver = find_solvers("corrected_cn").front();
  const Explained explained = shrink_and_explain(far_off("ellipsoid", solver, 100), solver);
  const double from = explained.shrunk.from.judgement.angle_error_deg;
  const double left = explained.shrunk.found.judgement.angle_error_deg;
  EXPECT_GE(left, from / 2);
  EXPECT_LT(cost(explained.shrunk.described), cost({far_off("ellipsoid", solver, 100), {}, {}}));
  EXPECT_NE(explained.sentence.find(fmt::format("(normal {:.3g} degrees off)", left)), std::string::npos)
      << explained.sentence;
}

/// Another answer to a pair.
JudgedAnswer with_finding(FindingKind kind, double angle_deg, double overlap) {
  JudgedAnswer out;
  out.judgement.finding.kind = kind;
  out.judgement.angle_error_deg = angle_deg;
  out.judgement.overlap = overlap;
  return out;
}

TEST(Defect, IsTheSameWithinAFactor) {
  const Pair pair = generate("spheroid", kShrinkSeed, 0).pair;
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  const auto turned = [&](double degrees) {
    return defect_of(pair, with_finding(FindingKind::misaligned, degrees, unknown));
  };
  EXPECT_TRUE(is_same(turned(131), turned(66)));
  EXPECT_FALSE(is_same(turned(131), turned(0.003)));
  EXPECT_FALSE(is_same(turned(0.003), turned(131)));
  EXPECT_TRUE(is_same(turned(1e-13), turned(1e-9))) << "both are noise";
  EXPECT_TRUE(is_same(turned(unknown), turned(131)));
  EXPECT_FALSE(is_same(turned(131), turned(unknown)));
  const auto missed = [&](double overlap) {
    return defect_of(pair, with_finding(FindingKind::missed_contact, unknown, overlap));
  };
  EXPECT_FALSE(is_same(turned(131), missed(131)));
  EXPECT_TRUE(is_same(missed(0.3), missed(-0.2)));
  EXPECT_FALSE(is_same(missed(0.3), missed(0.01)));
}

TEST(Explain, OverlapsAreToldAsExpectedAndGot) {
  Solver solver = find_solvers("auto").front();
  solver.solve = [right = solver.solve](const Pair& pair, const Want& want, const Contact<double>* last) {
    Contact<double> answer = right(pair, want, last);
    answer.overlap = -answer.overlap;
    answer.verdict = answer.overlap > 0 ? Verdict::overlapping : Verdict::separated;
    return answer;
  };
  const Explained explained = shrink_and_explain(generate("spheroid", kShrinkSeed, 0).pair, solver);
  const double got = explained.shrunk.found.answer.overlap;
  const std::string told = fmt::format("(expected overlap {:.6g}, got {:.6g})", -got, got);
  EXPECT_NE(explained.sentence.find(told), std::string::npos) << explained.sentence;
}

TEST(Shrink, IsReadFromItsFileBitForBit) {
  for (const auto& [c, solver] : failing()) {
    const Shrunk shrunk = shrink(c.pair, solver);
    EXPECT_EQ(bodies_json(in_file(shrunk.described).pair), bodies_json(shrunk.pair)) << c.name;
  }
}

TEST(Shrink, IsTheSameEachTime) {
  for (const auto& [c, solver] : failing()) {
    const Shrunk one = shrink(c.pair, solver), two = shrink(c.pair, solver);
    EXPECT_EQ(described_json(one.described), described_json(two.described));
    EXPECT_EQ(one.counts.judged, two.counts.judged);
  }
}

TEST(Shrink, NoSimplificationIsLeft) {
  for (const auto& [c, solver] : failing()) {
    const Shrunk shrunk = shrink(c.pair, solver);
    if (shrunk.stopped) continue;
    const Finding& from = shrunk.from.judgement.finding;
    Trials trials(solver, from.kind, true);
    for (const Simplification& simplify : simplifications()) {
      Described next = shrunk.described;
      simplify(next);
      const auto pair = pair_of(next);
      if (cost(next) >= cost(shrunk.described) || !pair || !in_domain(*pair)) continue;
      const JudgedAnswer found = trials.of(*pair);
      EXPECT_TRUE(found.judgement.finding.severity < from.severity / 2 ||
                  !is_same(defect_of(c.pair, shrunk.from), defect_of(*pair, found)))
          << c.name << ' ' << solver.name << ' ' << described_json(next);
    }
  }
}

Case case_of(const std::string& name) {
  const std::optional<Case> c = CaseReader(PLUMB_SOURCE_DIR "/corpus/cases/" + name + ".json").next();
  if (!c) throw std::runtime_error(name + " holds no case");
  return *c;
}

/// Not quite of revolution: of bodies that are, the reference is cheap.
Case dear_case() {
  Case out = case_of("incubating/blocks-near-coaxial-settled");
  for (Body* body : {&out.pair.body1, &out.pair.body2})
    body->shape.semi_axes[1] = std::nextafter(body->shape.semi_axes[1], 1.0);
  return out;
}

/// A case whose own reference takes longer than all trials may: what they may take is theirs.
TEST(Shrink, ADearCaseIsTriedAsWell) {
  const Shrunk shrunk = shrink(dear_case().pair, find_solvers("geometric_potential").front());
  EXPECT_EQ(shrunk.found.judgement.finding.kind, FindingKind::not_finite);
  EXPECT_GT(shrunk.counts.work, most_work);
  EXPECT_GT(shrunk.counts.solved, 1U);
  EXPECT_FALSE(shrunk.stopped);
}

/// A pair whose reference takes longer than all trials may.
TEST(Shrink, ATrialEndsWhereItsWorkDoes) {
  const Pair pair = dear_case().pair;
  const Solver method = find_solvers("minimum_distance").front();
  Judge judge(pair);
  const FindingKind kind = solve_and_judge(judge, pair, method).judgement.finding.kind;
  ASSERT_NE(kind, FindingKind::none);
  Trials trials(method, kind, false);
  EXPECT_EQ(trials.of(pair).judgement.finding.kind, FindingKind::none);
  EXPECT_TRUE(trials.is_over());
  EXPECT_EQ(trials.counts().judged, 0U);
  EXPECT_LT(trials.counts().work, most_work + 10'000'000);
}

TEST(Shrink, WhatIsRightIsLeftAlone) {
  const Case c = generate("spheroid", kShrinkSeed, 0);
  const Shrunk shrunk = shrink(c.pair, find_solvers("auto").front());
  EXPECT_EQ(shrunk.from.judgement.finding.kind, FindingKind::none);
  EXPECT_EQ(bodies_json(shrunk.pair), bodies_json(c.pair));
}

/// A solver that fails by rule: where the failure begins and ends is known.
Solver failing_when(const std::function<bool(const Pair&)>& fails) {
  Solver solver = find_solvers("auto").front();
  solver.name = "by_rule";
  solver.solve = [fails, right = solver.solve](const Pair& pair, const Want& want, const Contact<double>* last) {
    Contact<double> answer = right(pair, want, last);
    if (fails(pair)) answer.status = Status::stalled;
    return answer;
  };
  return solver;
}

TEST(Explain, ARuleIsFoundOut) {
  const Solver solver = failing_when([](const Pair& pair) {
    return pair.body1.shape.semi_axes.maxCoeff() > 3 * pair.body1.shape.semi_axes.minCoeff();
  });
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Case c = generate("ellipsoid", kShrinkSeed, i);
    const Explained explained = shrink_and_explain(c.pair, solver);
    if (explained.sentence.empty()) continue;
    std::size_t mattering = 0;
    for (const Range& range : explained.ranges) {
      const bool of_body1 = range.number.field.starts_with("bodies[0");
      EXPECT_TRUE(of_body1 || !range.matters()) << explained.sentence;
      mattering += range.matters() ? 1 : 0;
    }
    EXPECT_GE(mattering, 1u) << explained.sentence;
    return;
  }
  FAIL() << "no ellipsoid is longer than three times its width";
}

TEST(Explain, TheRangesAreTrueWhenTriedByHand) {
  for (const auto& [c, solver] : failing()) {
    const Explained explained = shrink_and_explain(c.pair, solver);
    const FindingKind kind = explained.shrunk.from.judgement.finding.kind;
    const auto try_at = [&, &by = solver](const Range& range, double x) {
      Described changed = explained.shrunk.described;
      range.number.set(changed, x);
      return kind_of(in_file(changed).pair, by);
    };
    for (const Range& range : explained.ranges) {
      const std::string where = c.name + " " + explained.sentence + " | " + range.number.field;
      for (const double x : {range.low, range.number.value, range.high}) EXPECT_EQ(try_at(range, x), kind) << where;
      if (range.gone_below) {
        EXPECT_NE(try_at(range, *range.gone_below), kind) << where;
      }
      if (range.gone_above) {
        EXPECT_NE(try_at(range, *range.gone_above), kind) << where;
      }
      EXPECT_LE(range.low, range.number.value);
      EXPECT_LE(range.number.value, range.high);
    }
  }
}

/// One whose trials end while its numbers are tried.
TEST(Explain, WhatWasNotTriedIsNotSaid) {
  const Pair pair = case_of("regressions/coaxial-about-y").pair;
  const Explained explained = shrink_and_explain(pair, find_solvers("corrected_cn").front());
  int unknown = 0;
  for (const Range& range : explained.ranges) {
    EXPECT_FALSE((range.gone_below && range.open_low) || (range.gone_above && range.open_high)) << range.number.words;
    const bool knows_low = range.gone_below || range.open_low, knows_high = range.gone_above || range.open_high;
    EXPECT_TRUE((knows_low && knows_high) || !range.finished) << range.number.words;
    unknown += range.matters() && !(knows_low && knows_high) ? 1 : 0;
  }
  EXPECT_GT(unknown, 0);
  EXPECT_EQ(explained.sentence.find("exactly"), std::string::npos) << explained.sentence;
  EXPECT_NE(explained.sentence.find("was not tried)"), std::string::npos) << explained.sentence;
  EXPECT_EQ(explained.sentence.find("no number matters"), std::string::npos) << explained.sentence;
  const std::size_t untried = explained.sentence.find("; not tried to the end: ");
  ASSERT_NE(untried, std::string::npos) << explained.sentence;
  for (const Range& range : explained.ranges) {
    EXPECT_GT(range.tried, 1u) << range.number.words;  // each has its share
    const bool is_named = explained.sentence.find(range.number.words, untried) != std::string::npos;
    EXPECT_TRUE(range.finished || is_named) << explained.sentence;
  }
}

TEST(Explain, TheKeptCaseExpectsItsFindingAndSaysWhy) {
  const auto& [c, solver] = failing().front();
  const Explained explained = shrink_and_explain(c.pair, solver);
  const Case kept = parse_case(format_case(kept_shrunk(c, explained, solver.name)), "kept");
  EXPECT_EQ(kept.expect.method, solver.name);
  EXPECT_EQ(kept.expect.finding, name(kind_of(kept.pair, solver)));
  EXPECT_EQ(kept.provenance.at("explanation"), explained.sentence);
  EXPECT_TRUE(explained.sentence.starts_with(solver.name + " ")) << explained.sentence;
}

class ShrinkCommand : public Commands {};

TEST_F(ShrinkCommand, ShrinksAndTheResultReplays) {
  const auto& [c, solver] = failing().front();
  (void)file("case.json", format_case(c) + "\n");
  const Ran ran = plumb("shrink case.json --json --out shrunk.json --method " + solver.name);
  EXPECT_EQ(ran.code, 1);
  const Json out = Json::parse(ran.out);
  for (const char* field : {"name", "method", "finding", "severity", "from_severity", "case", "explanation", "matters",
                            "indifferent", "judged", "solved", "stopped"})
    EXPECT_TRUE(out.contains(field)) << field;
  EXPECT_GT(out["work_ms"].get<double>(), 0);
  EXPECT_EQ(plumb("replay shrunk.json").code, 0);
  EXPECT_EQ(plumb("shrink shrunk.json").code, 1);
  EXPECT_EQ(plumb("shrink case.json").code, 0);  // by auto, which has no finding there
}

TEST_F(ShrinkCommand, Refuses) {
  (void)file("case.json", format_case(failing().front().c) + "\n");
  expect_refusal("shrink none.json", "none.json: No such file or directory");
  expect_refusal("shrink case.json --method new_cn,auto", "--method: new_cn,auto: shrink takes one method");
  EXPECT_EQ(plumb("shrink case.json --method magic 2>/dev/null").code, 2);
  EXPECT_EQ(plumb("shrink case.json --solver /nowhere.so 2>/dev/null").code, 2);
}

TEST_F(ShrinkCommand, ACampaignShrinksWhatItKeeps) {
  ASSERT_EQ(plumb("campaign --family spheroid --cases 20 --method original_cn --shrink --out out 2>&1").code, 0);
  std::size_t simplest = 0, shrunk = 0;
  for (const auto& entry : fs::directory_iterator(path_ / "out" / "failures")) {
    simplest += entry.path().string().ends_with(kSimplest) ? 1 : 0;
    shrunk += entry.path().string().ends_with(kShrunk) ? 1 : 0;
  }
  EXPECT_GT(shrunk, 0u);
  EXPECT_EQ(shrunk, simplest);
  EXPECT_EQ(plumb("replay out/failures").code, 0);
  EXPECT_EQ(plumb("merge out --out merged").code, 0);
}

}  // namespace
}  // namespace plumb
