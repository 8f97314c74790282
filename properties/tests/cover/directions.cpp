// The cover of all directions: its cells leave no direction out, and what it excludes is not lower.
#include "solver/method/auto/cover/directions.hpp"

#include "properties/tests/cover/covers.hpp"
#include "solver/pose.hpp"

namespace plumb::directions_tests {
namespace {

using namespace covers_tests;
using Cell = DirectionCell<double>;

/// Leaves of a tree that divides where it likes.
void grow(const Cell& cell, int deepest, Stream& stream, std::vector<Cell>& leaves) {
  if (cell.depth < deepest && (cell.depth < 2 || stream.chance(0.5)))
    for (int part = 0; part < Cell::parts; ++part) grow(cell.part(part), deepest, stream, leaves);
  else
    leaves.push_back(cell);
}

/// Whether a direction lies in a cell, from its own middle and corners.
bool holds(const Cell& cell, const Vec3<double>& n) {
  const Vec3<double> middle = cell.middle().eigen();
  const int axis = cell.face / 2;
  const double along = n[axis] * middle[axis];
  if (!(along > 0)) return false;
  const Vec3<double> there = n / along;
  return ((there - middle).cwiseAbs().array() <= cell.half()).all();
}

TEST(Directions, EachLiesInOneLeafOfAnyTree) {
  Stream stream("leaves", 1, 0);
  for (int tree = 0; tree < 10; ++tree) {
    std::vector<Cell> leaves;
    for (int face = 0; face < Cell::faces; ++face) grow({0, 0, face, 0}, 2 + tree % 5, stream, leaves);
    for (int k = 0; k < 200; ++k) {
      const Vec3<double> n = random_direction(stream);
      EXPECT_EQ(std::count_if(leaves.begin(), leaves.end(), [&](const Cell& leaf) { return holds(leaf, n); }), 1)
          << n.transpose();
    }
  }
}

/// The parts have the corners of the cell between them, and its middle in common.
TEST(Directions, PartsMeetInTheMiddleAndReachTheCorners) {
  Stream stream("parts", 1, 0);
  for (int draw = 0; draw < 200; ++draw) {
    Cell cell{0, 0, static_cast<int>(stream.below(Cell::faces)), 0};
    const auto depth = static_cast<int>(stream.below(Cell::deepest));
    while (cell.depth < depth) cell = cell.part(static_cast<int>(stream.below(Cell::parts)));
    const auto corners = cell.corners();
    const Vec3<double> middle = cell.middle().eigen().normalized();
    int at_corners = 0, at_middle = 0;
    for (int part = 0; part < Cell::parts; ++part)
      for (const Vector3<double>& of_part : cell.part(part).corners()) {
        EXPECT_NEAR(length(of_part), 1, 1e-15);
        at_middle += (of_part.eigen() - middle).norm() < 1e-15 ? 1 : 0;
        at_corners += std::any_of(corners.begin(), corners.end(),
                                  [&](const Vector3<double>& corner) { return length(corner - of_part) < 1e-15; })
                          ? 1
                          : 0;
      }
    EXPECT_EQ(at_middle, 4) << draw;
    EXPECT_EQ(at_corners, 4) << draw;
  }
}

constexpr int generous = 12'000;  // evaluations

/// Common normals of a pair, the lowest or not, and what the cover says of each.
template <class Solver>
void judge(const Solver& solver, const std::vector<Vector3<double>>& grid,
           const std::optional<RotationDerivative<double>>& rotation, Stream& stream, Tally& tally) {
  using Cover = DirectionCover<double, WithoutSolves<Solver>, generous>;
  judge_each<Cover>(solver, grid, stream, generous, tally, rotation);
}

TEST(Directions, OfEllipsoidsNoLowerOneIsExcluded) {
  const std::vector<Vector3<double>> grid = grid_of_directions(24);
  Tally tally;
  for (std::uint64_t draw = 0; draw < 80; ++draw) {
    Stream stream("ellipsoids", 1, draw);
    const Pair pair = draw_deep_pair(stream, random_ellipsoid(stream, 4), random_ellipsoid(stream, 4));
    const EllipsoidPair<double> framed = framed_ellipsoids(pair);
    const Want want;
    judge(EllipsoidSolver<double>{framed, want, {}}, grid, std::nullopt, stream, tally);
  }
  EXPECT_GT(tally.lowest, 25);
  EXPECT_GT(tally.higher, 40);
  EXPECT_LT(tally.unfinished, 5);
}

TEST(Directions, OfSuperellipsoidsNoLowerOneIsExcluded) {
  const std::vector<Vector3<double>> grid = grid_of_directions(20);
  Tally tally;
  for (std::uint64_t draw = 0; draw < 24; ++draw) {
    Stream stream("superellipsoids", 1, draw);
    const auto shape = [&] { return random_superellipsoid(stream, 3, draw % 3 == 0 ? 1.3 : 2, 8); };
    const Superellipsoid<double> shape1 = shape(), shape2 = shape();
    const Pair pair = draw_deep_pair(stream, shape1, shape2);
    const SuperellipsoidPair<double> framed = framed_superellipsoids(pair);
    const Want want;
    judge(SurfaceSolver<double>(framed, want), grid, std::nullopt, stream, tally);
  }
  EXPECT_GT(tally.lowest, 15);
  EXPECT_GT(tally.higher, 40);
  EXPECT_LT(tally.unfinished, 5);
}

/// Of revolution: with the sign of the derivative about an axis, which alone tells nearly coaxial directions apart.
TEST(Directions, OfBodiesOfRevolutionNoLowerOneIsExcluded) {
  const std::vector<Vector3<double>> grid = grid_of_directions(24);
  Tally tally;
  for (std::uint64_t draw = 0; draw < 40; ++draw) {
    Stream stream("spheroids", 1, draw);
    Superellipsoid<double> shape1, shape2;
    shape1.semi_axes[2] = stream.log_uniform(0.3, 3);
    shape2.semi_axes[2] = stream.log_uniform(0.3, 3);
    const Pair pair = draw_deep_pair(stream, shape1, shape2);
    const EllipsoidPair<double> framed = framed_ellipsoids(pair);
    const Want want;
    judge(EllipsoidSolver<double>{framed, want, {}}, grid, RotationDerivative<double>::of(place<double>(pair)), stream,
          tally);
  }
  EXPECT_GT(tally.lowest, 20);
  EXPECT_GT(tally.higher, 15);
  EXPECT_LT(tally.unfinished, 5);
}

}  // namespace
}  // namespace plumb::directions_tests
