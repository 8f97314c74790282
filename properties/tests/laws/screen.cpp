// The screen: it passes what is right, and each of its checks is shown able to suspect.
#include "properties/laws/screen.hpp"

#include <gtest/gtest.h>

#include "properties/doors/agreement.hpp"
#include "properties/generators/families.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

Contact<double> solve_by_auto(const Pair& pair) {
  return find_method("auto")->solve(pair, {}, nullptr);
}

/// The first of the family that overlaps by a hundredth of its size.
Pair overlapping_pair() {
  for (std::uint64_t i = 0;; ++i) {
    const Pair pair = generate("ellipsoid", 31, i).pair;
    if (solve_by_auto(pair).overlap > 0.01 * size_of(pair)) return pair;
  }
}

double severity(const Screening& screening, ScreenCheck check) {
  return screening.severity[static_cast<std::size_t>(check)];
}

TEST(Screen, PassesWhatIsRight) {
  int asked = 0;
  for (const std::string_view family : {"spheroid", "ellipsoid", "superquadric", "hard"})
    for (std::uint64_t i = 0; i < 300; ++i) {
      const Pair pair = generate(family, 31, i).pair;
      const Contact<double> answer = solve_by_auto(pair);
      if (answer.status != Status::converged) continue;
      ++asked;
      EXPECT_LE(screen(pair, answer, {}).worst, 1) << family << ' ' << i;
    }
  EXPECT_GT(asked, 1190);
}

struct WrongAnswer {
  const char* name;
  ScreenCheck suspects;
  void (*spoil)(Contact<double>&);
};

TEST(Screen, EachCheckSuspectsWhatIsWrong) {
  const std::vector<WrongAnswer> wrong{
      {"status", ScreenCheck::converges, [](Contact<double>& c) { c.status = Status::stalled; }},
      {"NaN", ScreenCheck::converges, [](Contact<double>& c) { c.point1[0] = std::nan(""); }},
      {"overlap", ScreenCheck::itself, [](Contact<double>& c) { c.overlap *= 1 + 1e-9; }},
      {"normal", ScreenCheck::itself, [](Contact<double>& c) { c.normal *= -1; }},
      {"points", ScreenCheck::surface, [](Contact<double>& c) { c.point1 += 1e-9 * c.normal; }},
      {"point", ScreenCheck::opposite, [](Contact<double>& c) { c.point1 += 1e-6 * c.normal.unitOrthogonal(); }},
      {"exchanged", ScreenCheck::collinear, [](Contact<double>& c) { std::swap(c.point1, c.point2); }},
      {"depth", ScreenCheck::own_depth, [](Contact<double>& c) { c.overlap += 1e-9; }},
      {"contact", ScreenCheck::between,
       [](Contact<double>& c) { c.contact_point += 1e-3 * c.normal.unitOrthogonal(); }},
      {"verdict", ScreenCheck::verdict, [](Contact<double>& c) { c.verdict = Verdict::separated; }}};
  const Pair pair = overlapping_pair();
  const Contact<double> right = solve_by_auto(pair);
  for (const WrongAnswer& w : wrong) {
    Contact<double> answer = right;
    w.spoil(answer);
    EXPECT_GT(severity(screen(pair, answer, {}), w.suspects), 1) << w.name;
  }
}

/// The far side of a sphere is a common normal in all but one respect, and a witness shows it.
TEST(Screen, AWitnessShowsThatThereIsALower) {
  Pair pair;
  pair.body2.position << 1.9, 0, 0;
  Contact<double> far = solve_by_auto(pair);
  far.overlap = 3.9;
  far.normal << -1, 0, 0;
  far.point1 << -1, 0, 0;
  far.point2 << 2.9, 0, 0;
  EXPECT_LE(screen(pair, far, {}).worst, 1);
  const std::array<Vec3<double>, 1> witness{Vec3<double>(1, 0, 0)};
  EXPECT_GT(severity(screen(pair, far, witness), ScreenCheck::lowest), 1);
}

TEST(Agreement, AutoAgreesWithItself) {
  for (const std::string_view family : {"ellipsoid", "superquadric", "hard"})
    for (std::uint64_t i = 0; i < 200; ++i) {
      const Pair pair = generate(family, 32, i).pair;
      const Contact<double> whole = solve_by_auto(pair);
      if (whole.status != Status::converged) continue;
      for (const auto& laws : {question_laws(), scalar_laws()}) {
        const Finding finding = worst_disagreement(laws, pair, whole);
        EXPECT_EQ(finding.kind, FindingKind::none) << family << ' ' << i << ": " << finding.detail;
      }
    }
}

/// A whole answer that is wrong is contradicted by every other.
TEST(Agreement, EachLawSeesAWrongAnswer) {
  const Pair pair = overlapping_pair();
  Contact<double> wrong = solve_by_auto(pair);
  wrong.overlap = -wrong.overlap;
  wrong.verdict = Verdict::separated;
  for (const auto& laws : {question_laws(), scalar_laws()})
    for (const AgreementLaw& law : laws) EXPECT_GT(law.check(pair, wrong).severity, 1) << law.name;
}

}  // namespace
}  // namespace plumb
