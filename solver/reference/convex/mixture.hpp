// Mixtures of points of A: the one that reaches furthest along all corners of a cell at once, and the one nearest to the origin.
// Nothing here has to be right for a bound to be right.
#pragma once

#include <array>
#include <vector>

#include "solver/contact.hpp"

namespace plumb::reference::cores {

using Points = std::vector<Vec3<double>>;
/// Four directions whose cone is a cell.
using CornersOfCell = std::array<Vec3<double>, 4>;

/// Weights of points, none below 0; those of the corners of a cell; both of sum 1.
struct GameSolution {
  std::vector<double> weights;
  std::array<double, 4> corner_weights;
  double value;
};

/// max over mixtures w of the points of min over the corners c of w.c: a matrix game.
[[nodiscard]] GameSolution best_mixture(const Points& points, const CornersOfCell& corners);

/// The weights of the mixture nearest to the origin, of at most four points.
[[nodiscard]] std::vector<double> nearest_mixture(const Points& points);

[[nodiscard]] Vec3<double> mixed(const Points& points, const std::vector<double>& weights);

}  // namespace plumb::reference::cores
