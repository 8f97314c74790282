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
  const Eigen::ColPivHouseholderQR<DenseMatrix<S>> qr(a);
  const Eigen::Index pivots = qr.nonzeroPivots();
  DenseRightSides<S> c = b;
  Eigen::Matrix<S, most_right_sides, 1> workspace;
  for (Eigen::Index k = 0; k < pivots; ++k)
    c.bottomRows(a.rows() - k)
        .applyHouseholderOnTheLeft(qr.matrixQR().col(k).tail(a.rows() - k - 1), qr.hCoeffs()[k], workspace.data());
  qr.matrixQR().topLeftCorner(pivots, pivots).template triangularView<Eigen::Upper>().solveInPlace(c.topRows(pivots));
  LeastSquares<S> out{{}, qr.rank()};
  out.x.setZero(a.cols(), b.cols());
  for (Eigen::Index k = 0; k < pivots; ++k) out.x.row(qr.colsPermutation().indices()[k]) = c.row(k);
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
