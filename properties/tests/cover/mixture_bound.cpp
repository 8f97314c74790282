// Mixtures of witnesses as a lower bound of the overlap over a cell: against all mixtures, and against directions of the cell.
#include "solver/method/auto/cover/mixture_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "properties/generators/draft.hpp"
#include "solver/method/auto/cover/direction_cells.hpp"
#include "solver/pose.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::mixture_bound_tests {
namespace {

using Mixtures = MixtureBound<double>;
using Cell = DirectionCell<double>;

Cell draw_cell(Stream& stream, int least_depth, int depths) {
  Cell cell{0, 0, static_cast<int>(stream.below(Cell::faces)), 0};
  const auto depth = least_depth + static_cast<int>(stream.below(static_cast<std::size_t>(depths)));
  while (cell.depth < depth) cell = cell.part(static_cast<int>(stream.below(Cell::parts)));
  return cell;
}

double least_at_corners(const Vector3<double>& witness, const Mixtures::Corners& corners) {
  double out = dot(witness, corners[0]);
  for (const Vector3<double>& corner : corners) out = std::min(out, dot(witness, corner));
  return out;
}

/// Of three witnesses all mixtures, in steps of a 40th: the best of the grid is not above the linear program's, and near it.
TEST(MixtureBound, NoMixtureOfThreeIsHigher) {
  Stream stream("three witnesses", 1, 0);
  int mixed = 0;
  for (int draw = 0; draw < 400; ++draw) {
    const Mixtures::Corners corners = draw_cell(stream, 1, 6).corners();
    std::array<Vector3<double>, 3> witnesses;
    Mixtures mixtures;
    for (Vector3<double>& witness : witnesses) {
      witness = Vector3<double>::of(random_direction(stream));
      mixtures.add(witness);
    }
    const double best = least_at_corners(mixtures.solve(corners, -4).mixture, corners);
    double of_grid = -4, of_one = -4;
    constexpr int steps = 40;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        const Vector3<double> mixture = witnesses[0] * (1.0 * i / steps) + witnesses[1] * (1.0 * j / steps) +
                                        witnesses[2] * (1.0 * (steps - i - j) / steps);
        of_grid = std::max(of_grid, least_at_corners(mixture, corners));
      }
    for (const Vector3<double>& witness : witnesses) of_one = std::max(of_one, least_at_corners(witness, corners));
    EXPECT_LE(of_grid, best + 1e-12) << draw;
    EXPECT_GE(of_grid, best - 2.0 / steps) << draw;
    mixed += best > of_one + 1e-3 ? 1 : 0;
  }
  EXPECT_GT(mixed, 30);  // where more than one is needed
}

/// Two bodies, and o over directions.
struct Bodies {
  PlacedPair<double> pair;

  explicit Bodies(Stream& stream) {
    Pair drawn{{draw_shape(stream), Vec3<double>::Zero(), random_rotation(stream)},
               {draw_shape(stream), random_direction(stream) * stream.uniform(0, 0.4), random_rotation(stream)}};
    pair = place<double>(drawn);
  }

  [[nodiscard]] double overlap_along(const Vec3<double>& n) const {
    return support<double>(pair.body1.shape, pair.body1.to_body_direction(n)) +
           support<double>(pair.body2.shape, pair.body2.to_body_direction(-n)) - n.dot(pair.body2.centre);
  }
  /// p1 - p2 of the points farthest along n and -n.
  [[nodiscard]] Vector3<double> witness(const Vec3<double>& n) const {
    const auto point = [](const PlacedBody<double>& body, const Vec3<double>& u) {
      return body.to_pair(support_point<double>(body.shape, body.to_body_direction(u)).gradient);
    };
    return Vector3<double>::of(Vec3<double>(point(pair.body1, n) - point(pair.body2, -n)));
  }

 private:
  static Superellipsoid<double> draw_shape(Stream& stream) { return random_superellipsoid(stream, 4, 1.3, 20); }
};

Vec3<double> draw_in(const Cell& cell, Stream& stream) {
  const Vec3<double> corner = cell.at(-1, -1).eigen(), u = cell.at(1, -1).eigen() - corner,
                     v = cell.at(-1, 1).eigen() - corner;
  return (corner + stream.uniform() * u + stream.uniform() * v).normalized();
}

/// A mixture as high as a level at the corners, level > 0, is so all over the cell: no direction of it has a lower overlap.
TEST(MixtureBound, NoDirectionOfTheCellIsLowerThanTheMixtureAtItsCorners) {
  Stream stream("cells", 1, 0);
  int positive = 0;
  double closest = 1e9;
  for (int draw = 0; draw < 400; ++draw) {
    const Bodies bodies(stream);
    const Cell cell = draw_cell(stream, 2, 5);
    const Mixtures::Corners corners = cell.corners();
    Mixtures mixtures;
    for (std::size_t k = 0; k < 6; ++k)  // from anywhere in the cell, as a search sees them
      mixtures.add(bodies.witness(draw_in(cell, stream)));
    const double height = least_at_corners(mixtures.solve(corners, -1e9).mixture, corners);
    if (!(height > 0)) continue;
    ++positive;
    for (int k = 0; k < 60; ++k) {
      const double there = bodies.overlap_along(draw_in(cell, stream));
      EXPECT_GE(there, height - 1e-13) << draw;
      closest = std::min(closest, there - height);
    }
  }
  EXPECT_GT(positive, 100);
  EXPECT_LT(closest, 1e-3);
}

/// The game's other half: at `place` the best of the witnesses is as low as the best mixture at its worst corner, and no
/// direction of the cell is lower under all witnesses.
TEST(MixtureBound, ThePlaceIsWhereTheWitnessesAreTheLowest) {
  Stream stream("places", 1, 0);
  int inside = 0;
  for (int draw = 0; draw < 200; ++draw) {
    const Bodies bodies(stream);
    const Cell cell = draw_cell(stream, 2, 4);
    const Mixtures::Corners corners = cell.corners();
    Mixtures mixtures;
    std::vector<Vector3<double>> witnesses;
    for (std::size_t k = 0; k < 5; ++k) {
      witnesses.push_back(bodies.witness(draw_in(cell, stream)));
      mixtures.add(witnesses.back());
    }
    const auto [mixture, place] = mixtures.solve(corners, -1e9);
    const auto best_at = [&](const Vector3<double>& v) {
      double out = -1e9;
      for (const Vector3<double>& witness : witnesses) out = std::max(out, dot(witness, v));
      return out;
    };
    // `place` is a mixture of the corners with shares of any sum: so are others.
    const double value = least_at_corners(mixture, corners);
    for (int k = 0; k < 100; ++k) {
      std::array<double, 4> shares{};
      double total = 0;
      for (double& share : shares) total += share = stream.uniform();
      Vector3<double> other{0, 0, 0};
      for (std::size_t j = 0; j < 4; ++j) other = other + corners[j] * (shares[j] / total);
      EXPECT_GE(best_at(other), value - 1e-9) << draw;
    }
    EXPECT_TRUE(mixtures.reaches(best_at(place) / length(place) * (1 - 1e-9), place)) << draw;
    EXPECT_FALSE(mixtures.reaches(best_at(place) / length(place) + 1e-9, place)) << draw;
    inside += length(place) > 0 ? 1 : 0;
  }
  EXPECT_EQ(inside, 200);
}

}  // namespace
}  // namespace plumb::mixture_bound_tests
