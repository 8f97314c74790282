// What the tests of the covers share: a solver without local solves, and the common normals that a search may start from.
//
// A cover that looks at all directions sees a lower overlap wherever there is one, whatever its local solves find: so with a
// solver that finds nothing, from a common normal that is not the lowest, it must end with a lower overlap seen, and from the
// lowest with all excluded. A gap between cells, or a bound that is not below the overlap, shows as a minimum that is missed.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "properties/generators/draft.hpp"
#include "solver/method/auto/ellipsoid/ellipsoid_solver.hpp"
#include "solver/method/auto/surface/surface_solver.hpp"

namespace plumb::covers_tests {

[[nodiscard]] inline EllipsoidPair<double> framed_ellipsoids(const Pair& pair) {
  return ellipsoid_pair(framed_pair(pair, PairFrame<double>(pair)));
}

[[nodiscard]] inline SuperellipsoidPair<double> framed_superellipsoids(const Pair& pair) {
  const Superellipsoid<double>&shape1 = pair.body1.shape, &shape2 = pair.body2.shape;
  return superellipsoid_pair<double>(framed_pair(pair, PairFrame<double>(pair)), per_body<double>(shape1.n1, shape2.n1),
                                     per_body<double>(shape1.n2, shape2.n2));
}

/// From concentric to a fair overlap: `farthest` is of the least semi-axes.
[[nodiscard]] inline Pair draw_deep_pair(Stream& stream, const Superellipsoid<double>& shape1,
                                         const Superellipsoid<double>& shape2, double farthest = 0.7) {
  const double reach = shape1.semi_axes.minCoeff() + shape2.semi_axes.minCoeff();
  return {{shape1, Vec3<double>::Zero(), random_rotation(stream)},
          {shape2, random_direction(stream) * (reach * stream.uniform(0, farthest)), random_rotation(stream)}};
}

/// A solver whose solves never converge.
template <class Solver>
struct WithoutSolves {
  using Answer = typename Solver::Answer;

  const Solver& of;

  [[nodiscard]] double inner_rolling_radius() const { return of.inner_rolling_radius(); }
  [[nodiscard]] Vector3<double> centre() const { return of.centre(); }
  [[nodiscard]] double size() const { return of.size(); }
  [[nodiscard]] Vector3<double> farthest(const Vector3<double>& v) const { return of.farthest(v); }
  [[nodiscard]] Vector3<PerBody<double>> farthest_points(const Vector3<double>& v) const {
    return of.farthest_points(v);
  }
  [[nodiscard]] auto support_shapes() const { return of.support_shapes(); }
  [[nodiscard]] PerBody<double> inner_rolling_radii() const { return of.inner_rolling_radii(); }
  [[nodiscard]] Vector3<PerBody<double>> to_gauge(const Vector3<PerBody<double>>& p) const { return of.to_gauge(p); }
  [[nodiscard]] Vector3<PerBody<double>> from_gauge(const Vector3<PerBody<double>>& p) const {
    return of.from_gauge(p);
  }
  [[nodiscard]] Vector3<double> point1(const Answer& found) const { return of.point1(found); }
  [[nodiscard]] Vector3<double> point2(const Answer& found) const { return of.point2(found); }
  [[nodiscard]] Answer solve(const Vector3<double>& /*start*/, Attempts /*attempts*/) const {
    Answer out;
    out.evaluations = 0;
    out.status = Status::stalled;
    return out;
  }
};

/// What a cover says of a common normal.
enum class Said { is_lowest, sees_lower, is_unfinished };

/// By all its cells, or until a lower overlap is seen.
template <class Cells, class Solver, class... Geometry>
[[nodiscard]] Said what_says(const Solver& solver, const typename Solver::Answer& first, int budget,
                             const Geometry&... geometry) {
  typename Cells::Incumbent incumbent(solver, first, budget);
  Cells cells(incumbent, geometry...);
  const double lower = first.overlap - incumbent.rounding();
  cells.start();
  while (!cells.is_empty() && incumbent.may_go_on()) {
    cells.look_at_next();
    if (incumbent.bound() < lower) return Said::sees_lower;
  }
  return cells.is_empty() && !cells.has_left_out() ? Said::is_lowest : Said::is_unfinished;
}

/// How often a cover was right of a lowest and of a higher common normal, and how often it said nothing.
struct Tally {
  int lowest = 0, higher = 0, unfinished = 0;

  /// `least`: the lowest overlap of many directions.
  void judge(Said said, double overlap, double least, double rounding) {
    if (said == Said::is_unfinished) ++unfinished;
    if (said == Said::is_lowest) {
      EXPECT_GE(least, overlap - rounding);
    }
    if (least < overlap - rounding) {
      EXPECT_NE(said, Said::is_lowest);
    }
    lowest += said == Said::is_lowest ? 1 : 0;
    higher += said == Said::sees_lower ? 1 : 0;
  }
};

/// The unit vectors to the middles of the squares of a cube's faces, so many a side.
inline std::vector<Vector3<double>> grid_of_directions(int side) {
  std::vector<Vector3<double>> out;
  for (int face = 0; face < 6; ++face)
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) {
        Vec3<double> v;
        v[face / 2] = face % 2 == 0 ? 1 : -1;
        v[(face / 2 + 1) % 3] = (2 * i + 1.0) / side - 1;
        v[(face / 2 + 2) % 3] = (2 * j + 1.0) / side - 1;
        out.push_back(Vector3<double>::of(Vec3<double>(v.normalized())));
      }
  return out;
}

/// The lowest overlap of the grid's directions.
template <class Solver>
[[nodiscard]] double lowest_of_grid(const Solver& solver, const std::vector<Vector3<double>>& grid) {
  double out = std::numeric_limits<double>::infinity();
  for (const Vector3<double>& n : grid) out = std::min(out, dot(solver.farthest(n), n));
  return out;
}

/// Different common normals, from many starts.
template <class Solver>
[[nodiscard]] std::vector<typename Solver::Answer> common_normals(const Solver& solver, Stream& stream, int starts) {
  std::vector<typename Solver::Answer> out;
  for (int k = 0; k < starts; ++k) {
    const auto found = solver.solve(Vector3<double>::of(random_direction(stream)), Attempts::several);
    if (found.status != Status::converged || !(found.overlap > 0)) continue;
    const bool is_known = std::any_of(out.begin(), out.end(), [&](const auto& other) {
      return std::abs(other.overlap - found.overlap) < 1e-9 && largest(other.normal - found.normal) < 1e-5;
    });
    if (!is_known) out.push_back(found);
  }
  return out;
}

/// Calls `use(first, least)` with each common normal that so many starts find, as a search's first answer, and with the lowest
/// overlap that they and the grid's directions show.
template <class Solver, class Use>
void for_each_common_normal(const Solver& solver, const std::vector<Vector3<double>>& grid, Stream& stream, int starts,
                            const Use& use) {
  auto found = common_normals(solver, stream, starts);
  double least = lowest_of_grid(solver, grid);
  for (const auto& first : found) least = std::min(least, first.overlap);
  for (auto& first : found) {
    first.evaluations = 0;
    use(first, least);
  }
}

/// What a cover over WithoutSolves<Solver> says of each common normal that may not be the lowest.
template <class Cells, class Solver, class... Geometry>
void judge_each(const Solver& solver, const std::vector<Vector3<double>>& grid, Stream& stream, int budget,
                Tally& tally, const Geometry&... geometry) {
  const WithoutSolves<Solver> silent{solver};
  for_each_common_normal(solver, grid, stream, 12, [&](const auto& first, double least) {
    if (first.overlap <= solver.inner_rolling_radius()) return;  // nothing is lower, and nothing is looked at
    tally.judge(what_says<Cells>(silent, first, budget, geometry...), first.overlap, least, 1e-13 * solver.size());
  });
}

}  // namespace plumb::covers_tests
