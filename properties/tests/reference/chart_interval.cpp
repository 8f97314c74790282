// Krawczyk's test on the chart equations: what it proves of a box, against the equations at points of it and against local solves
// from there.
#include "solver/reference/interval/chart_interval.hpp"

#include <gtest/gtest.h>

#include "properties/generators/families.hpp"
#include "properties/tests/reference/inside.hpp"
#include "solver/reference/reference.hpp"

namespace plumb::reference::chart_interval_tests {
namespace {

using namespace inside_tests;
using Fine = Real50;
using I = Interval80;

/// A pair with the chart pair of its common normal, to 1e-45 or so.
struct Solved {
  Pair pair;
  PlacedPair<Fine> placed;
  EnclosedPair<I> enclosed_pair;
  ChartPair<Fine> at;

  Solved(const std::string& family, std::uint64_t index)
      : pair(generate(family, 61, index).pair), placed(place<Fine>(pair)), enclosed_pair(enclose<I>(pair)) {
    const Solution found = find_reference(pair).common_normal;
    EXPECT_TRUE(found.solved) << found.reason;
    const auto near = charts_of_direction<Fine>(placed, found.normal);
    at = solve_on_charts<Fine>(placed, {}, near, Fine("1e-48"), 30).at;
  }
};

const std::vector<Solved>& all_solved() {
  static const std::vector<Solved> out = [] {
    std::vector<Solved> list;
    for (const char* family : {"spheroid", "ellipsoid", "superquadric"})
      for (std::uint64_t i = 0; i < 4; ++i) list.emplace_back(family, i);
    return list;
  }();
  return out;
}

/// Both chart points changed by up to `reach` in each coordinate.
ChartPair<Fine> draw_near(const ChartPair<Fine>& at, const Fine& reach, Stream& stream) {
  ChartPair<Fine> out = at;
  for (CubePoint<Fine>* point : {&out.at1, &out.at2})
    for (int k = 0; k < 2; ++k) point->w[point->minor(k)] += reach * Fine(stream.uniform(-1, 1));
  return out;
}

/// The largest difference of chart coordinates.
Fine distance(const ChartPair<Fine>& a, const ChartPair<Fine>& b) {
  return std::max((a.at1.w - b.at1.w).cwiseAbs().maxCoeff(), (a.at2.w - b.at2.w).cwiseAbs().maxCoeff());
}

/// The same face's coordinates of a chart pair that a solve may have taken to another face.
ChartPair<Fine> on_faces_of(const ChartPair<Fine>& of, const ChartPair<Fine>& like) {
  ChartPair<Fine> out = of;
  const auto bring = [](CubePoint<Fine>& point, const CubePoint<Fine>& face) {
    point.w /= Fine(abs(point.w[face.major]));
    point.major = face.major;
  };
  bring(out.at1, like.at1);
  bring(out.at2, like.at2);
  return out;
}

TEST(ChartInterval, BothBodiesOverABoxHoldTheirSurfaces) {
  Stream stream("jets", 1, 0);
  for (const Solved& s : all_solved()) {
    const double radius = stream.log_uniform(1e-9, 1e-2);
    const ContactJet<I> jet = contact_jet(s.enclosed_pair, s.at, I(radius));
    for (int k = 0; k < 4; ++k) {
      const ChartResidual<Fine> there = chart_residual<Fine>(s.placed, {}, draw_near(s.at, radius, stream));
      EXPECT_TRUE(are_in(jet.body1.point, there.point1));
      EXPECT_TRUE(are_in(jet.body1.normal, there.normal1));
      EXPECT_TRUE(are_in(IVec3<I>(jet.body2.point + jet.centre2), there.point2));
    }
  }
}

/// |1 - C J| at points of the box is not above its bound over the box.
TEST(ChartInterval, TheContractionIsAnUpperBound) {
  Stream stream("contraction", 1, 0);
  int contracts = 0;
  for (const Solved& s : all_solved()) {
    const SquareForm form = square_form(s.placed, s.at);
    const double radius = stream.log_uniform(1e-9, 1e-3);
    const ContactJet<I> jet = contact_jet(s.enclosed_pair, s.at, I(radius));
    const double bound = high(contraction(form, equations_jacobian<I>(jet, {})));
    contracts += bound < 1 ? 1 : 0;
    Eigen::Matrix<Fine, 4, 6> choice;
    Eigen::Matrix<Fine, 4, 4> inverse;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 6; ++j) {
        choice(i, j) = middle<Fine>(form.choice(i, j));
        if (j < 4) inverse(i, j) = middle<Fine>(form.inverse(i, j));
      }
    for (int k = 0; k < 4; ++k) {
      const ChartResidual<Fine> there = chart_residual<Fine>(s.placed, {}, draw_near(s.at, radius, stream));
      const Eigen::Matrix<Fine, 4, 4> rest =
          Eigen::Matrix<Fine, 4, 4>::Identity() - inverse * (choice * there.jacobian);
      EXPECT_LE(rest.cwiseAbs().rowwise().sum().maxCoeff(), Fine(bound) + Fine("1e-30"));
    }
  }
  EXPECT_GT(contracts, 6);
}

/// From anywhere in a proved box a solve ends in the one common normal, and that is as near as it says.
TEST(ChartInterval, AProvedBoxHoldsJustOneCommonNormal) {
  Stream stream("boxes", 1, 0);
  int proved = 0;
  for (const Solved& s : all_solved())
    for (const double off : {0.0, 1e-12, 1e-6}) {
      const ChartPair<Fine> guess = draw_near(s.at, off, stream);
      const double radius = std::max(1e-9, 8 * off);
      const ChartProof proof = prove_on_box(s.enclosed_pair, square_form(s.placed, guess), guess, I(radius));
      if (!proof.exists) continue;
      ++proved;
      EXPECT_LE(proof.radius, radius);
      EXPECT_LE(distance(guess, s.at), Fine(proof.error) + Fine("1e-40"));
      if (off > 0) {
        EXPECT_LE(proof.error, 3 * off);
      }
      for (int k = 0; k < 2; ++k) {
        const ChartPair<Fine> start = draw_near(guess, proof.radius, stream);
        const LocalSolution<Fine> found = solve_on_charts<Fine>(s.placed, {}, start, Fine("1e-45"), 40);
        ASSERT_TRUE(found.converged);
        EXPECT_LE(distance(on_faces_of(found.at, s.at), s.at), Fine("1e-30"));
      }
    }
  EXPECT_GT(proved, 25);
}

TEST(ChartInterval, ABoxThatMissesItIsRefused) {
  Stream stream("misses", 1, 0);
  int tried = 0;
  for (const Solved& s : all_solved())
    for (const double off : {1e-3, 1e-6, 1e-12, 1e-25}) {
      ChartPair<Fine> beside = s.at;
      beside.at1.w[beside.at1.minor(static_cast<int>(stream.below(2)))] += Fine(stream.sign() * off);
      const ChartProof proof = prove_on_box(s.enclosed_pair, square_form(s.placed, beside), beside, I(off / 2));
      EXPECT_FALSE(proof.exists) << off;
      ++tried;
    }
  EXPECT_EQ(tried, 48);
}

/// Where the normals are the same and not opposite the four equations hold as well: that is no common normal.
TEST(ChartInterval, EqualNormalsAreNone) {
  Pair pair;  // two spheres, the one within the other: n1 = n2 on the line of centres
  pair.body1.shape.semi_axes.setConstant(1.5);
  pair.body2.position << 0, 0.2, 0;
  const CubePoint<Fine> top = CubePoint<Fine>::of(Vec3<Fine>(Fine(0), Fine(1), Fine(0)));
  const PlacedPair<Fine> placed = place<Fine>(pair);
  const ChartPair<Fine> same{top, top};
  EXPECT_FALSE(prove_on_box(enclose<I>(pair), square_form(placed, same), same, I(1e-6)).exists);
  const ChartPair<Fine> opposite{top, CubePoint<Fine>::of(Vec3<Fine>(Fine(0), Fine(-1), Fine(0)))};
  EXPECT_TRUE(prove_on_box(enclose<I>(pair), square_form(placed, opposite), opposite, I(1e-6)).exists);
}

}  // namespace
}  // namespace plumb::reference::chart_interval_tests
