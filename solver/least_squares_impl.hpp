// Bodies of the templates of least_squares.hpp; included only where they are instantiated.
#pragma once

#include <Eigen/LU>
#include <Eigen/QR>

#include "solver/least_squares.hpp"

namespace plumb {

template <class S>
LeastSquares<S> least_squares(const DenseMatrix<S>& a, const DenseRightSides<S>& b) {
  const Eigen::ColPivHouseholderQR<DenseMatrix<S>> qr(a);
  return {qr.solve(b), qr.rank()};
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
