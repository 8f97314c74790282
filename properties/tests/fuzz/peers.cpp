// The peers: what they answer where the answer is known, what they say they cannot do, and who lists them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "corpus/solvers/solver.hpp"
#include "properties/generators/families.hpp"
#include "properties/tests/corpus/programs.hpp"

namespace plumb {
namespace {

constexpr double kAccuracy = 1e-5;  // of the size: all three stop at about 1e-6

/// A peer's answer to a pair. A build without libccd or FCL has no such peer.
class Peers : public Commands {
 protected:
  [[nodiscard]] static bool has(const std::string& name) {
    const auto names = peer_names();
    return std::find(names.begin(), names.end(), name) != names.end();
  }
  [[nodiscard]] static Contact<double> ask(const std::string& name, const Pair& pair) {
    return load_peer(name).solve(pair, {}, nullptr);
  }
};

Pair two_ellipsoids(const Vec3<double>& axes1, const Vec3<double>& axes2, const Vec3<double>& offset) {
  Pair pair;
  pair.body1.shape.semi_axes = axes1;
  pair.body2.shape.semi_axes = axes2;
  pair.body2.position = offset;
  return pair;
}

const Vec3<double> kAlong = Vec3<double>(2, -1, 2) / 3;

void expect_spheres(const Contact<double>& contact, double unit, const Vec3<double>& shift) {
  ASSERT_EQ(contact.status, Status::converged);
  EXPECT_EQ(contact.verdict, Verdict::overlapping);
  EXPECT_NEAR(contact.overlap, 0.1 * unit, kAccuracy * unit);
  EXPECT_LT((contact.normal - kAlong).norm(), 1e-2);  // the root of the depth's accuracy over the depth
  EXPECT_LT((contact.point1 - shift - unit * kAlong).norm(), 1e-2 * unit);
  EXPECT_LT((contact.point2 - shift - unit * 0.9 * kAlong).norm(), 1e-2 * unit);
  EXPECT_GT(contact.evaluations, 0);
}

TEST_F(Peers, SpheresAreRightWithinTheirAccuracyInAnyUnitAnywhere) {
  if (peer_names().empty()) GTEST_SKIP() << "built without peers";
  for (const std::string& name : peer_names())
    for (const double unit : {1e-9, 1.0, 1e6}) {
      SCOPED_TRACE(name + fmt::format(" in units of {}", unit));
      const Vec3<double> shift = unit * Vec3<double>(3, -70, 500);
      Pair pair = two_ellipsoids(Vec3<double>::Constant(unit), Vec3<double>::Constant(unit / 2), 1.4 * unit * kAlong);
      pair.body1.position += shift;
      pair.body2.position += shift;
      expect_spheres(ask(name, pair), unit, shift);
    }
}

TEST_F(Peers, LibccdKnowsOfBodiesApartThatTheyAreAndNoMore) {
  if (!has("peer_libccd_epa")) GTEST_SKIP() << "built without libccd";
  const Pair apart = two_ellipsoids(Vec3<double>::Ones(), Vec3<double>::Ones(), 2.5 * kAlong);
  for (const char* name : {"peer_libccd_epa", "peer_libccd_mpr"}) {
    const Contact<double> contact = ask(name, apart);
    EXPECT_EQ(contact.verdict, Verdict::separated) << name;
    EXPECT_NE(contact.status, Status::converged) << name;
    EXPECT_TRUE(std::isnan(contact.overlap)) << name;
  }
}

TEST_F(Peers, LibccdTakesAnyExponents) {
  if (!has("peer_libccd_epa")) GTEST_SKIP() << "built without libccd";
  Pair blocks = two_ellipsoids({1, 2, 3}, {3, 2, 1}, {3.9, 0, 0});
  blocks.body1.shape.n1 = blocks.body2.shape.n2 = 8;
  const Contact<double> contact = ask("peer_libccd_epa", blocks);
  ASSERT_EQ(contact.status, Status::converged);
  EXPECT_NEAR(contact.overlap, 0.1, kAccuracy);
}

// EPA has no limit of its own; this is the pair of 200 000 at which it needs one.
TEST_F(Peers, LibccdIsStoppedWhereItWouldNotStop) {
  if (!has("peer_libccd_epa")) GTEST_SKIP() << "built without libccd";
  const Contact<double> contact = ask("peer_libccd_epa", generate("superquadric", 7, 26668).pair);
  EXPECT_EQ(contact.status, Status::iteration_limit);
  EXPECT_LT(contact.evaluations, 2100);
}

TEST_F(Peers, FclKnowsEllipsoidsOverlappingAndApart) {
  if (!has("peer_fcl")) GTEST_SKIP() << "built without FCL";
  for (const double overlap : {0.1, -0.5}) {
    const Pair pair = two_ellipsoids({1, 2, 3}, {3, 2, 1}, {4 - overlap, 0, 0});
    const Contact<double> contact = ask("peer_fcl", pair);
    ASSERT_EQ(contact.status, Status::converged) << overlap;
    EXPECT_EQ(contact.verdict, overlap > 0 ? Verdict::overlapping : Verdict::separated);
    EXPECT_NEAR(contact.overlap, overlap, kAccuracy);
    EXPECT_LT((contact.normal - Vec3<double>::UnitX()).norm(), 1e-2);
    EXPECT_LT((contact.point1 - Vec3<double>::UnitX()).norm(), 1e-2);
  }
}

TEST_F(Peers, FclRefusesOtherExponents) {
  if (!has("peer_fcl")) GTEST_SKIP() << "built without FCL";
  Pair pair = two_ellipsoids({1, 2, 3}, {3, 2, 1}, {3.9, 0, 0});
  pair.body2.shape.n1 = 4;
  EXPECT_EQ(ask("peer_fcl", pair).status, Status::invalid_input);
}

TEST_F(Peers, AreListedWhereTheirLibrariesLie) {
  const std::string here = plumb("methods").out;
  for (const std::string& name : peer_names()) EXPECT_NE(here.find("\n" + name + " "), std::string::npos) << here;
  fs::copy(std::string(PLUMB_BINARY_DIR) + "/bin/plumb-methods", path_);
  const Ran elsewhere = run((path_ / "plumb-methods").string());
  EXPECT_EQ(elsewhere.code, 0);
  EXPECT_EQ(elsewhere.out.find("peer_"), std::string::npos) << elsewhere.out;
  EXPECT_NE(elsewhere.out.find("new_cn"), std::string::npos) << elsewhere.out;
}

TEST_F(Peers, TheirFindingsAreACampaignsResult) {
  if (peer_names().empty()) GTEST_SKIP() << "built without peers";
  for (const Solver& solver : all_solvers()) EXPECT_TRUE(solver.published || !solver.name.starts_with("peer_"));
  const Ran ran = plumb("campaign --family spheroid --cases 5 --seed 1 --method " + peer_names()[0] + " 2>/dev/null");
  EXPECT_EQ(ran.code, 0);
  EXPECT_NE(ran.out.find("misaligned"), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace plumb
