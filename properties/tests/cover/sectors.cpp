// The cover of sectors: it leaves no direction out, what it excludes is not lower, and it does what it is for.
#include "solver/method/auto/cover/sectors.hpp"

#include "properties/tests/cover/covers.hpp"

namespace plumb::sectors_tests {
namespace {

using namespace covers_tests;

constexpr int generous = 1000;  // evaluations, more than it may spend

template <class Solver>
using Cover = SectorCover<double, WithoutSolves<Solver>>;

template <class Solver>
void judge(const Solver& solver, const std::vector<Vector3<double>>& grid, Stream& stream, Tally& tally) {
  judge_each<Cover<Solver>>(solver, grid, stream, generous, tally, nullptr);
}

TEST(Sectors, OfEllipsoidsNoLowerOneIsExcluded) {
  const std::vector<Vector3<double>> grid = grid_of_directions(24);
  Tally tally;
  for (std::uint64_t draw = 0; draw < 3000; ++draw) {
    Stream stream("ellipsoids", 2, draw);
    const Pair pair = draw_deep_pair(stream, random_ellipsoid(stream, 8), random_ellipsoid(stream, 8));
    const EllipsoidPair<double> framed = framed_ellipsoids(pair);
    const Want want;
    judge(EllipsoidSolver<double>{framed, want, {}}, grid, stream, tally);
  }
  EXPECT_GT(tally.lowest, 100);
  EXPECT_GT(tally.higher, 100);
}

TEST(Sectors, OfSuperellipsoidsNoLowerOneIsExcluded) {
  const std::vector<Vector3<double>> grid = grid_of_directions(20);
  Tally tally;
  for (std::uint64_t draw = 0; draw < 500; ++draw) {
    Stream stream("superellipsoids", 2, draw);
    const auto shape = [&] { return random_superellipsoid(stream, 4, draw % 3 == 0 ? 1.3 : 2, 20); };
    const Superellipsoid<double> shape1 = shape();
    const SuperellipsoidPair<double> framed = framed_superellipsoids(draw_deep_pair(stream, shape1, shape()));
    const Want want;
    judge(SurfaceSolver<double>(framed, want), grid, stream, tally);
  }
  EXPECT_GT(tally.lowest, 20);
  EXPECT_GT(tally.higher, 40);
}

/// Overlaps of up to a twentieth of the distance, which the cheaper conditions of surface_guard.hpp leave open.
TEST(Sectors, OfBlocksThatTouchMostAreProvedByAFewWitnesses) {
  int open = 0, proved = 0, evaluations = 0;
  for (std::uint64_t draw = 0; draw < 400; ++draw) {
    Stream stream("blocks", 1, draw);
    Draft draft;
    draft.pair.body1.shape = random_superellipsoid(stream, 5, 8, 40);
    draft.pair.body2.shape = random_superellipsoid(stream, 5, 8, 40);
    draft.pair.body2.quaternion = random_rotation(stream);
    place_on_random_line(stream, draft, stream.log_uniform(1e-3, 5e-2));
    const SuperellipsoidPair<double> framed = framed_superellipsoids(draft.pair);
    const Want want;
    const SurfaceSolver<double> solver(framed, want);
    auto first = solver.local(draft.pair, nullptr);
    if (first.status != Status::converged || solver.is_surely_lowest(first)) continue;
    first.evaluations = 0;
    ++open;
    std::optional<Witnesses<double>> witnesses;
    const auto found = proved_by_sectors<double>(solver, first, witnesses);
    if (found.status != Status::converged) continue;
    ++proved;
    evaluations += found.evaluations;
  }
  EXPECT_GT(open, 50);
  EXPECT_GT(proved, 0.9 * open);
  EXPECT_LT(evaluations, 8 * proved);
}

/// Whether v, unit, is a sum of three of the corners, none of them negative, to rounding.
bool holds(const MixtureBound<double>::Corners& corners, const Vector3<double>& v) {
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    const Vector3<double>&p = corners[(left_out + 1) % 4], &q = corners[(left_out + 2) % 4],
          &r = corners[(left_out + 3) % 4];
    const double sign = std::copysign(1, dot(cross(p, q), r));
    const double least = std::min({sign * dot(cross(q, r), v), sign * dot(cross(r, p), v), sign * dot(cross(p, q), v)});
    if (least >= -1e-15) return true;
  }
  return false;
}

/// Also where n is all but across the line of centres.
TEST(Sectors, EachDirectionForwardsIsInTheSquareOrInOne) {
  Stream stream("forwards", 1, 0);
  for (int draw = 0; draw < 2000; ++draw) {
    const Vec3<double> n = random_direction(stream), across = random_direction(stream).cross(n).normalized();
    const Tangent<double> basis = tangent_basis<double>(n);
    const DirectionSquare<double> square{Vector3<double>::of(n),
                                         {Vector3<double>::of(basis.col(0)), Vector3<double>::of(basis.col(1))},
                                         stream.log_uniform(1e-6, 0.1)};
    const Vec3<double> c = n * stream.log_uniform(1e-12, 1) + across;
    const auto sectors = sectors_about(square, Vector3<double>::of(c));
    for (int k = 0; k < 20; ++k) {
      // Half of them on the plane across c, where rounding decides.
      const Vec3<double> any = random_direction(stream);
      const Vec3<double> v = k % 2 == 0 ? Vec3<double>((any - c * (any.dot(c) / c.squaredNorm())).normalized())
                                        : Vec3<double>(any * (any.dot(c) < 0 ? -1 : 1));
      const Vector3<double> direction = Vector3<double>::of(v);
      EXPECT_TRUE(square.holds(direction) ||
                  std::any_of(sectors.begin(), sectors.end(), [&](const auto& of) { return holds(of, direction); }))
          << draw << ": " << v.transpose();
    }
  }
}

/// Without a common normal, or with the centres in one place or nearly so, there is nothing to begin with.
TEST(Sectors, GivesUpWhereItCanNotBegin) {
  const Superellipsoid<double> shape{{1, 1, 3}, 2, 2};
  const auto says = [&](const Vec3<double>& centre, Status status) {
    const EllipsoidPair<double> framed = framed_ellipsoids({{shape, Vec3<double>::Zero()}, {shape, centre}});
    const Want want;
    const EllipsoidSolver<double> solver{framed, want, {}};
    auto first = solver.solve({0.1, 0.2, 1});
    first.status = status;
    return what_says<Cover<EllipsoidSolver<double>>>(WithoutSolves<EllipsoidSolver<double>>{solver}, first, generous,
                                                     nullptr);
  };
  EXPECT_EQ(says({0.5, 0, 0}, Status::stalled), Said::is_unfinished);
  EXPECT_EQ(says({0, 0, 0}, Status::converged), Said::is_unfinished);
  EXPECT_EQ(says({1e-309, 1e-310, 1e-309}, Status::converged), Said::is_unfinished);
}

}  // namespace
}  // namespace plumb::sectors_tests
