// The claims of the source's study, as claims: which of the published equations hold and which do not, and how far answers to other
// questions are from the common normal.
#include <gtest/gtest.h>

#include <cmath>

#include "properties/tests/corpus/programs.hpp"
#include "reports/study/groups.hpp"
#include "reports/study/limits.hpp"
#include "reports/study/maps.hpp"
#include "reports/study/starts.hpp"

namespace plumb::reports {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr std::array kShapes{BedShape::spheroid, BedShape::superquadric};

const std::vector<Group>& groups_of(BedShape shape) {
  static const std::array all{find_groups(BedShape::spheroid, kSeed), find_groups(BedShape::superquadric, kSeed)};
  return all[shape == BedShape::spheroid ? 0 : 1];
}

template <class Check>
void each_answer(std::string_view method, const Check& check) {
  for (const BedShape shape : kShapes)
    for (const Group& group : groups_of(shape)) {
      ASSERT_GT(group.drawn, 0) << group.name;
      for (const GroupAnswer& answer : group.answers)
        if (answer.method == method) check(group, answer);
    }
}

/// Its own equations hold in every group, and R3, R4 or R5 say that its answer is none where the group says so.
TEST(Study, TheOriginalSolvesItsEquationsAndNotTheProblem) {
  each_answer("original_cn", [](const Group& group, const GroupAnswer& answer) {
    const Diagnosis& d = answer.studied.diagnosis;
    EXPECT_LT(std::max(std::abs(d.residues[0]), std::abs(d.residues[1])), 1e-10) << group.name << ' ' << answer.ratio;
    EXPECT_EQ(fails_of(d), group.fails) << group.name << ' ' << answer.ratio;
    const bool is_right = group.fails == Fails::nothing;
    EXPECT_EQ(std::max({d.d_n1, d.d_n2, d.n1_n2}) < 1e-9, is_right) << group.name << ' ' << answer.ratio;
  });
}

TEST(Study, TheNewSystemsAnglesVanish) {
  for (const std::string_view method : {"new_cn", "auto"})
    each_answer(method, [&](const Group& group, const GroupAnswer& answer) {
      const Diagnosis& d = answer.studied.diagnosis;
      EXPECT_LT(std::max({d.d_n1, d.d_n2, d.n1_n2}), 1e-9) << method << ' ' << group.name << ' ' << answer.ratio;
      ASSERT_TRUE(answer.certified);
      EXPECT_LT(answer.studied.off, 1e-9) << method << ' ' << group.name << ' ' << answer.ratio;
    });
}

/// Exchanged, each problem has the same answer seen from the other side.
TEST(Study, SwappingTheBodiesChangesTheSideAlone) {
  for (const BedShape shape : kShapes)
    for (const Group& group : groups_of(shape))
      for (const Problem problem : problems) {
        const Pair pair = pair_of(group.bed, 1e-2);
        const Truth a = truth_of(pair, problem), b = truth_of(swapped(pair), problem);
        ASSERT_TRUE(a.known && b.known) << name(problem) << ' ' << group.name;
        const Real50 off = (a.normal + b.normal).norm() + (a.point1 - b.point2).norm() + (a.point2 - b.point1).norm();
        EXPECT_LT(off + abs(Real50(a.overlap - b.overlap)), 1e-15) << name(problem) << ' ' << group.name;
      }
}

/// And so has each method that promises one; geometric_potential may stop at a stationary point that is not the deepest (S2 does).
TEST(Study, SwappingTheBodiesChangesNoMethodsAnswer) {
  for (const std::string_view method :
       {"new_cn", "minimum_distance", "geometric_potential_midway", "first_touch", "auto"})
    each_answer(method, [&](const Group& group, const GroupAnswer& answer) {
      const Contact<double>& a = answer.studied.contact;
      const Contact<double> b = find_method(method)->solve(swapped(pair_of(group.bed, answer.ratio)), {}, nullptr);
      ASSERT_EQ(a.status, b.status) << method << ' ' << group.name << ' ' << answer.ratio;
      if (a.status != Status::converged) return;
      const double off = (a.normal + b.normal).norm() + (a.point1 - b.point2).norm() + (a.point2 - b.point1).norm();
      EXPECT_LT(off + std::abs(a.overlap - b.overlap), 1e-9) << method << ' ' << group.name << ' ' << answer.ratio;
    });
}

/// Which of its solutions a start finds may change; that they are its solutions may not.
TEST(Study, SwappingTheBodiesKeepsTheOriginalsSolutions) {
  for (const Group& group : groups_of(BedShape::spheroid)) {
    const Pair pair = pair_of(group.bed, 1e-2);
    const SixRoots one = find_six_roots(pair), other = find_six_roots(swapped(pair));
    ASSERT_TRUE(one.complete && other.complete) << group.name;
    EXPECT_EQ(one.roots.size(), other.roots.size()) << group.name;
    for (const SixRoot& root : one.roots) {
      const std::size_t found =
          find_root(other, root.point2.cast<double>(), root.point1.cast<double>(), 1e-12).value_or(other.roots.size());
      ASSERT_LT(found, other.roots.size()) << group.name;
      EXPECT_EQ(other.roots[found].kind, root.kind) << group.name;
    }
  }
}

/// All its solutions but two or so are spurious, and most starts end at one of these.
TEST(Study, MostStartsOfTheOriginalEndAtSpuriousSolutions) {
  for (const Group& group : groups_of(BedShape::spheroid)) {
    const PairRoots found = find_roots(group.name, pair_of(group.bed, 1e-2), 200, kSeed);
    ASSERT_TRUE(found.set.complete) << group.name << ": " << found.set.reason;
    EXPECT_EQ(found.elsewhere, 0) << group.name;
    int spurious = 0, right = 0;
    for (const RootStarts& one : found.roots)
      (one.root.kind == SixRootKind::common_normal ? right : spurious) += one.starts;
    EXPECT_GT(spurious, 2 * right) << group.name;
  }
}

/// Of the systems in the order of limit_systems.
std::vector<Order> orders_of(const Bed& bed) {
  const int pairs = 6;
  std::vector<Order> out;
  const auto larger = limits_of("ratio", "", bed, 1e-5, 1e-5, pairs, kSeed, 2),
             smaller = limits_of("ratio", "", bed, 1e-6, 1e-6, pairs, kSeed, 2);
  for (std::size_t k = 0; k < larger.size(); ++k) {
    EXPECT_EQ(smaller[k].certified, pairs);
    out.push_back(order_of(larger[k], smaller[k]));
  }
  return out;
}

/// As the overlap goes to zero the normals of midway and first touch tend to the common normal as its first power, and so do points
/// and overlaps; the two deepest points' normal stays where it is.
TEST(Study, SmallOverlapsHaveTheirLimits) {
  for (const Bed& bed :
       {Bed{.aspect = 1.5}, Bed{.aspect = 2}, Bed{.aspect = 3}, Bed{.aspect = 1.5, .n1 = 3, .n2 = 3}}) {
    const std::vector<Order> orders = orders_of(bed);
    EXPECT_NEAR(orders[0].angle, 0, 1e-3);
    EXPECT_GT(orders[0].limit, 5);
    EXPECT_LT(orders[0].limit, 40);
    EXPECT_NEAR(orders[0].point, 1, 1e-2);
    EXPECT_NEAR(orders[0].overlap, 0, 1e-2);
    for (const std::size_t k : {1u, 2u}) {
      EXPECT_NEAR(orders[k].angle, 1, 1e-2) << orders[k].system;
      EXPECT_NEAR(orders[k].point, 1, 1e-2) << orders[k].system;
      EXPECT_NEAR(orders[k].overlap, 1, 1e-2) << orders[k].system;
    }
  }
}

/// Where both bodies have one n1, equal potentials are equal growth, and to grow both until they touch is to part the centres.
TEST(Study, MidwayAndFirstTouchHaveOneNormalWhereTheExponentsAreEqual) {
  for (const double n : {2.0, 3.5}) {
    Stream random("study_test", kSeed, 0);
    Pair pair = pair_of(any_orientation({.aspect = 2, .n1 = n}, random), 0.03);
    pair.body2.shape.semi_axes << 0.9, 1.1, 1.6;
    const Solution midway = find_problem_reference(pair, Problem::midway),
                   touch = find_problem_reference(pair, Problem::first_touch);
    ASSERT_TRUE(midway.proved && touch.proved);
    EXPECT_LT((midway.normal - touch.normal).norm(), 1e-40);
  }
}

TEST(Study, SharesDoNotDependOnThreads) {
  const auto one = find_shares(4, kSeed, 1), two = find_shares(4, kSeed, 2);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].pairs, 4) << "all are certified";
    EXPECT_EQ(one[i].off, two[i].off);
    EXPECT_EQ(one[i].median, two[i].median);
  }
}

class StudyCommand : public Commands {};

TEST_F(StudyCommand, TwoRunsGiveIdenticalTables) {
  const std::string command = "report-study --part groups,roots,limits --starts 20 --pairs 2";
  const Ran one = plumb(command + " --threads 1 --out one.jsonl"), two = plumb(command + " --out two.jsonl");
  ASSERT_EQ(one.code, 0) << one.out;
  EXPECT_EQ(one.out, two.out);
  EXPECT_EQ(run("cmp " + (path_ / "one.jsonl").string() + ' ' + (path_ / "two.jsonl").string()).code, 0);
}

TEST_F(StudyCommand, AnUnknownPartIsRefused) {
  EXPECT_EQ(plumb("report-study --part tables 2>/dev/null").code, 2);
}

}  // namespace
}  // namespace plumb::reports
