// Small dense linear least squares. The dimensions are told at run time and Eigen's decompositions are instantiated in one
// file a scalar: for each fixed size they cost the compiler half a minute. Nothing is allocated.
#pragma once

#include <Eigen/Core>

namespace plumb {

inline constexpr int most_equations = 12;
inline constexpr int most_unknowns = 8;
inline constexpr int most_right_sides = 19;

template <class S>
using DenseMatrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most_equations, most_unknowns>;
template <class S>
using DenseRightSides =
    Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most_equations, most_right_sides>;

template <class S>
struct LeastSquares {
  Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, most_unknowns, most_right_sides>
      x;  ///< a column each
  Eigen::Index rank = 0;
};

/// Minimises |a x - b| for each column of b by column-pivoted Householder QR. Where a has lost rank, the unknowns that
/// pivoting left over are zero.
template <class S>
[[nodiscard]] LeastSquares<S> least_squares(const DenseMatrix<S>& a, const DenseRightSides<S>& b);

/// The same, and of all minimisers the shortest (complete orthogonal decomposition).
template <class S>
[[nodiscard]] LeastSquares<S> shortest_least_squares(const DenseMatrix<S>& a, const DenseRightSides<S>& b);

/// A basis of the null space of `a`, a column each; one zero column where there is none (LU with full pivoting).
template <class S>
[[nodiscard]] DenseMatrix<S> null_space(const DenseMatrix<S>& a);

}  // namespace plumb
