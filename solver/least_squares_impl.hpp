// Bodies of the templates of least_squares.hpp; included only where they are instantiated.
#pragma once

#include <Eigen/LU>
#include <Eigen/QR>

#include "solver/least_squares.hpp"

namespace plumb {

/// As qr.solve(b) does it, to the bit; that one also compiles the products of blocks of 48 reflections, which no system here has, for
/// twice the time.
template <class S>
LeastSquares<S> least_squares(const DenseMatrix<S>& a, const DenseRightSides<S>& b) {
  using Column = Eigen::Block<const DenseMatrix<S>, Eigen::Dynamic, 1>;
  const Eigen::ColPivHouseholderQR<DenseMatrix<S>> qr(a);
  const Eigen::Index rows = a.rows(), columns = a.cols(), pivots = qr.nonzeroPivots();
  const DenseMatrix<S>& reflections = qr.matrixQR();
  DenseRightSides<S> c = b;
  Eigen::Matrix<S, 1, Eigen::Dynamic, Eigen::RowMajor, 1, most_right_sides> workspace(c.cols());
  for (Eigen::Index k = 0; k < pivots; ++k)
    c.bottomRows(rows - k).applyHouseholderOnTheLeft(Column(reflections, k + 1, k, rows - k - 1, 1),
                                                     qr.hCoeffs().coeff(k), workspace.data());
  reflections.topLeftCorner(pivots, pivots).template triangularView<Eigen::Upper>().solveInPlace(c.topRows(pivots));
  LeastSquares<S> out{.x = {}, .rank = qr.rank()};
  out.x.resize(columns, c.cols());
  for (Eigen::Index k = 0; k < pivots; ++k) out.x.row(qr.colsPermutation().indices().coeff(k)) = c.row(k);
  for (Eigen::Index k = pivots; k < columns; ++k) out.x.row(qr.colsPermutation().indices().coeff(k)).setZero();
  return out;
}

template <class S>
LeastSquares<S> shortest_least_squares(const DenseMatrix<S>& a, const DenseRightSides<S>& b) {
  const Eigen::CompleteOrthogonalDecomposition<DenseMatrix<S>> cod(a);
  return {cod.solve(b), cod.rank()};
}

template <class S>
DenseMatrix<S> null_space(const DenseMatrix<S>& a) {
  return Eigen::FullPivLU<DenseMatrix<S>>(a).kernel();
}

#define PLUMB_INSTANTIATE_LEAST_SQUARES(S) \
  template LeastSquares<S> least_squares(const DenseMatrix<S>&, const DenseRightSides<S>&);
/// What conditions take besides (reference/condition.hpp).
#define PLUMB_INSTANTIATE_NULL_SPACES(S)                                                             \
  template LeastSquares<S> shortest_least_squares(const DenseMatrix<S>&, const DenseRightSides<S>&); \
  template DenseMatrix<S> null_space(const DenseMatrix<S>&);

}  // namespace plumb
