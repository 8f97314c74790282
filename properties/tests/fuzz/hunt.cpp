// Guided fuzzing finds faults that were planted in a foreign library, and what is left of a case has the same fault.
#include "fuzz/hunt/hunt.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "fuzz/hunt/guide.hpp"
#include "fuzz/hunt/inputs.hpp"
#include "fuzz/shrink/explain.hpp"
#include "properties/tests/corpus/programs.hpp"
#include "properties/tests/draws.hpp"
#include "solver/pose.hpp"

namespace plumb::hunting {
namespace {

const std::string kPlanted = std::string(PLUMB_BINARY_DIR) + "/tests/foreign_planted.so";
/// Far below what a processor tries in a minute: some 400 000.
constexpr std::uint64_t kInputs = 2000;

/// Programs and libraries that find in their environment which fault they have.
class Hunt : public Commands {
 protected:
  void TearDown() override {
    ::unsetenv("PLUMB_PLANTED");
    Commands::TearDown();
  }
  static Solver planted(const std::string& fault) {
    ::setenv("PLUMB_PLANTED", fault.c_str(), 1);
    return load_solver(kPlanted);
  }
};

HuntOptions inputs(std::uint64_t count, std::uint64_t seed = 1) {
  HuntOptions out;
  out.inputs = count;
  out.seed = seed;
  return out;
}

bool is_in_the_octant(const Pair& pair) {
  const Mat3<double> to_body1 = rotation<double>(pair.body1.quaternion).transpose();
  return ((to_body1 * (pair.body2.position - pair.body1.position)).array() > 0).all();
}

/// Shrinking must not leave the fault that was found for another one, or for one of another size.
void expect_found(const Solver& solver, const std::set<FindingKind>& kinds,
                  const std::function<bool(const Pair&)>& is_where_it_fails) {
  for (std::uint64_t seed = 1; seed <= draws(5, 3); ++seed) {
    const Hunted hunted = hunt(solver, inputs(kInputs, seed));
    if (!hunted.found) FAIL() << "seed " << seed;
    const Pair& pair = hunted.found->pair;
    const Explained explained = shrink_and_explain(pair, solver);
    const Shrunk& shrunk = explained.shrunk;
    EXPECT_TRUE(kinds.contains(shrunk.found.judgement.finding.kind)) << explained.sentence;
    EXPECT_TRUE(is_where_it_fails(shrunk.pair)) << explained.sentence;
    EXPECT_TRUE(is_same(defect_of(pair, hunted.judged), defect_of(shrunk.pair, shrunk.found))) << explained.sentence;
  }
}

TEST_F(Hunt, FindsAWrongSignInOneOctant) {
  expect_found(planted("octant"), {FindingKind::misaligned}, is_in_the_octant);
}

TEST_F(Hunt, FindsWhatIsWrongAboveHalfAnOverlap) {
  expect_found(planted("deep"), {FindingKind::overlap_error}, [](const Pair& pair) {
    const double distance = (pair.body2.position - pair.body1.position).norm();
    return Judge(pair).reference().common_normal.overlap > distance;
  });
}

TEST_F(Hunt, FindsWhatIsWrongAtEqualAxesAlone) {
  expect_found(planted("equal_axes"), {FindingKind::misaligned}, [](const Pair& pair) {
    const Vec3<double>& a = pair.body1.shape.semi_axes;
    return a[0] == a[1] || a[1] == a[2] || a[2] == a[0];
  });
}

/// Float answers as double does where it holds all numbers of the pair.
bool is_between_floats(const Pair& pair) {
  const auto is_float = [](double x) { return static_cast<double>(static_cast<float>(x)) == x; };
  const auto is_exact = [&](const Body& body) {
    return std::all_of(body.shape.semi_axes.begin(), body.shape.semi_axes.end(), is_float) && is_float(body.shape.n1) &&
           is_float(body.shape.n2) && std::all_of(body.position.begin(), body.position.end(), is_float) &&
           std::all_of(body.quaternion.begin(), body.quaternion.end(), is_float);
  };
  return !is_exact(pair.body1) || !is_exact(pair.body2);
}

TEST_F(Hunt, FindsFloatInThePlaceOfDouble) {
  expect_found(planted("float"), {FindingKind::misaligned, FindingKind::missed_contact}, is_between_floats);
}

TEST_F(Hunt, FindsNothingInARightLibrary) {
  const Hunted hunted = hunt(planted("none"), inputs(draws(20000, 2000)));
  EXPECT_FALSE(hunted.found);
  EXPECT_EQ(hunted.inputs, draws(20000, 2000));
  EXPECT_GT(hunted.answered, hunted.inputs / 2);
  EXPECT_GT(hunted.cells, 500U);
}

/// A solver whose error grows towards one shape and one direction, and is a finding very near to them alone.
Solver rising() {
  Solver solver = find_solvers("auto").front();
  solver.solve = [right = solver.solve](const Pair& pair, const Want& want, const Contact<double>* last) {
    Contact<double> answer = right(pair, want, last);
    const Mat3<double> to_body1 = rotation<double>(pair.body1.quaternion).transpose();
    const Vec3<double> line = to_body1 * (pair.body2.position - pair.body1.position);
    const Vec3<double>& a = pair.body1.shape.semi_axes;
    const double turned = (line.stableNormalized() - Vec3<double>(0.6, 0, 0.8)).norm();
    const double away = turned + std::abs(std::log(a[2] / a[0]) - 0.5);
    answer.overlap += size_of(pair) * std::pow(10, -1 - 8 * away);
    return answer;
  };
  return solver;
}

constexpr std::uint64_t kClimbed = 20'000;

HuntOptions to_the_top() {
  HuntOptions out = inputs(kClimbed);
  out.accuracy.overlap = 0.05;  // within 0.04 of both
  out.accuracy.normal = 0.1;
  return out;
}

TEST_F(Hunt, ClimbsToWhatIsNotDrawn) {
  const Solver solver = rising();
  const HuntOptions options = to_the_top();
  EXPECT_TRUE(hunt(solver, options).found);
  const Guide guide(solver.abilities, options.accuracy);
  for (std::uint64_t i = 0; i < kClimbed; ++i) {
    Stream stream("drawn", 1, i);
    Input input = drawn(layouts_for(solver.abilities), stream);
    bring_home(input);
    const Pair pair = case_of(input, solver.abilities).pair;
    ASSERT_LE(guide.of(pair, solver.solve(pair, Want{}, nullptr), guide.second(pair)).overlap,
              options.accuracy.overlap);
  }
}

TEST_F(Hunt, IsTheSameEachTime) {
  const Solver solver = planted("octant");
  const Hunted one = hunt(solver, inputs(kInputs)), two = hunt(solver, inputs(kInputs));
  if (!one.found || !two.found) FAIL();
  EXPECT_EQ(format_case(*one.found), format_case(*two.found));
  EXPECT_EQ(one.inputs, two.inputs);
}

/// A solver of its own abilities is asked for nothing else.
TEST_F(Hunt, AsksForWhatIsClaimed) {
  Solver solver = find_solvers("auto").front();
  solver.abilities.shapes = Shapes::ellipsoids;
  solver.abilities.apart = Apart::none;
  std::size_t others = 0, asked = 0;
  solver.solve = [&, right = solver.solve](const Pair& pair, const Want& want, const Contact<double>* last) {
    const Contact<double> answer = right(pair, want, last);
    others += solver.abilities.takes(pair) && answer.verdict == Verdict::overlapping ? 0 : 1;
    ++asked;
    return answer;
  };
  const Hunted hunted = hunt(solver, inputs(500));
  EXPECT_EQ(others, 0U);
  EXPECT_EQ(hunted.answered, asked);
  EXPECT_GT(asked, 100U);
}

TEST_F(Hunt, StopsAtTheKindsThatWereAskedFor) {
  const Solver solver = planted("octant");
  HuntOptions options = inputs(100);
  options.kinds = AbortRule("overlap_error,crash");
  EXPECT_FALSE(hunt(solver, options).found);
  EXPECT_TRUE(hunt(solver, inputs(100)).found);
}

TEST_F(Hunt, TheCommandKeepsTheCaseAndItsSentence) {
  ::setenv("PLUMB_PLANTED", "octant", 1);
  const Ran ran = plumb("fuzz --inputs 500 --solver " + kPlanted);
  EXPECT_EQ(ran.code, 1) << ran.out;
  std::size_t shrunk = 0;
  for (const auto& entry : fs::directory_iterator(path_ / "plumb-fuzz" / "failures"))
    if (entry.path().string().ends_with("--shrunk.json")) {
      ++shrunk;
      const Json kept = Json::parse(read("plumb-fuzz/failures/" + entry.path().filename().string()));
      EXPECT_TRUE(ran.out.starts_with(kept.at("provenance").at("explanation").get<std::string>() + "\n")) << ran.out;
    }
  EXPECT_EQ(shrunk, 1U);
  EXPECT_EQ(plumb("replay plumb-fuzz/failures --solver " + kPlanted + " 2>&1").code, 0);
  ::setenv("PLUMB_PLANTED", "none", 1);
  const Ran right = plumb("fuzz --inputs 500 --solver " + kPlanted);
  EXPECT_EQ(right.code, 0) << right.out;
  EXPECT_NE(right.out.find("no finding in 500 inputs"), std::string::npos) << right.out;
}

/// In the place of libFuzzer's program its target, run over the seeds as the engine does first: what is said to it, and what is
/// made of what it leaves.
TEST_F(Hunt, TheEngineIsToldWhomToAsk) {
  ::setenv("PLUMB_PLANTED", "octant", 1);
  (void)file("fuzz-contact",
             "#!/bin/sh\nexec " PLUMB_BINARY_DIR "/bin/replay-contact " PLUMB_SOURCE_DIR "/fuzz/seeds/contact/*\n");
  fs::permissions(path_ / "fuzz-contact", fs::perms::owner_all);
  const std::string command = "fuzz --inputs 10 --engine ./fuzz-contact --solver " + kPlanted;
  const Ran ran = plumb(command + " 2>/dev/null");
  EXPECT_EQ(ran.code, 1) << ran.out;
  EXPECT_NE(ran.out.find("is misaligned (normal "), std::string::npos) << ran.out;
  EXPECT_EQ(plumb(command + " --kinds crash 2>/dev/null").code, 0);
  EXPECT_EQ(plumb(command + " --accuracy normal=3.2rad,overlap=1 2>/dev/null").code, 0);
  EXPECT_EQ(plumb("fuzz --engine ./none --solver " + kPlanted + " 2>/dev/null").code, 2);
}

/// What float does to the overlap is within a thousandth of the size; needles of 1 to 1000 turn their normals by degrees.
TEST_F(Hunt, FloatIsRightWhereNoMoreIsAskedFor) {
  const Solver solver = planted("float");
  HuntOptions options = inputs(draws(3000, 500));
  options.accuracy = parse_accuracy("normal=3.2rad,overlap=1e-3,points=10");
  EXPECT_FALSE(hunt(solver, options).found);
  options.accuracy = parse_accuracy("normal=1e-9rad,overlap=1e-9");
  EXPECT_TRUE(hunt(solver, options).found);
}

TEST_F(Hunt, ACrashIsAFindingAndNotTheEnd) {
  ::setenv("PLUMB_MISBEHAVIOUR", "crash_some", 1);
  const std::string library = std::string(PLUMB_BINARY_DIR) + "/tests/foreign_misbehaving.so";
  const Ran ran = plumb("fuzz --inputs 500 --solver " + library);
  ::unsetenv("PLUMB_MISBEHAVIOUR");
  EXPECT_EQ(ran.code, 1) << ran.out;
  EXPECT_NE(ran.out.find(" crashes for "), std::string::npos) << ran.out;
}

TEST_F(Hunt, Refuses) {
  expect_refusal("fuzz --inputs 5", "plumb fuzz: --solver: is missing: which solver?");
  EXPECT_EQ(plumb("fuzz --method auto --kinds magic 2>/dev/null").code, 2);
  EXPECT_EQ(plumb("fuzz --method auto --accuracy fine 2>/dev/null").code, 2);
  EXPECT_EQ(plumb("fuzz --solver /nowhere.so 2>/dev/null").code, 2);
}

}  // namespace
}  // namespace plumb::hunting
