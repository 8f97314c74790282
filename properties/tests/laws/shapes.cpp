// Judgements on pairs of convex bodies at the ends of lengths, and on verdicts that are left open.
#include <gtest/gtest.h>

#include <array>

#include "properties/laws/laws_convex.hpp"
#include "solver/method/convex.hpp"
#include "solver/shape/hull.hpp"

namespace plumb {
namespace {

using Vec = Vec3<double>;

ConvexPair pair_of(const Shape& shape, const Vec& position) {
  ConvexPair out;
  out.body1.shape = out.body2.shape = shape;
  out.body2.position = position;
  return out;
}

Shape tetrahedron(double size) {
  const std::array<Vec, 4> corners{Vec(1, 1, 1), Vec(-1, -1, 1), Vec(1, -1, -1), Vec(-1, 1, -1)};
  std::array<Vec, 4> out;
  for (std::size_t i = 0; i < 4; ++i) out[i] = size * corners[i];
  return make_polyhedron(out);
}

Finding finding_of(const ConvexPair& pair, const Contact<double>& answer) {
  return judge_convex(pair, answer, {}, false).finding;
}

Contact<double> undecided(double overlap) {
  Contact<double> out;
  out.status = Status::converged;
  out.verdict = Verdict::undecided;
  out.overlap = overlap;
  return out;
}

TEST(JudgedShapes, AVerdictIsLeftOpenOnlyWhereRoundingDecides) {
  const Box cube{{1, 1, 1}};
  EXPECT_EQ(finding_of(pair_of(cube, {5, 0, 0}), undecided(-3)).kind, FindingKind::false_contact);
  EXPECT_EQ(finding_of(pair_of(cube, {1.5, 0, 0}), undecided(0.5)).kind, FindingKind::missed_contact);
  EXPECT_EQ(finding_of(pair_of(cube, {2, 0, 0}), undecided(0)).kind, FindingKind::none);
}

TEST(JudgedShapes, OfTwoEqualPointsNothingIsMisaligned) {
  const ConvexPair pair = pair_of(make_polyhedron(std::array<Vec, 1>{Vec(0, 0, 0)}), {0, 0, 0});
  const Finding found = finding_of(pair, solve_convex(pair, {}, nullptr));
  EXPECT_EQ(found.kind, FindingKind::none) << found.detail;
}

TEST(JudgedShapes, TheLargestAreJudgedAsThoseOfSizeOne) {
  for (const double size : {1.0, 0.5e308}) {
    const ConvexPair pair = pair_of(tetrahedron(size), {size, size / 8, size / 32});
    Contact<double> answer = solve_convex(pair, {}, nullptr);
    EXPECT_EQ(finding_of(pair, answer).kind, FindingKind::none) << size;
    answer.point1[0] += 1e-6 * size;
    EXPECT_NE(finding_of(pair, answer).kind, FindingKind::none) << size;
  }
}

}  // namespace
}  // namespace plumb
