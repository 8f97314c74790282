// What a small change of every input number does to a common normal: written once for numbers and for intervals.
//
// The chart equations F(w; input) = 0 (chart_solve.hpp) hold before and after: J dw = -b, b the change of F at a fixed w.
// Any parametrisation of the surface may be held fixed, its own tangent is in J. For a change of shape it is the shares
// |v_rho|^n1, |v_z|^n1 and |v_x / v_rho|^n2, |v_y / v_rho|^n2 of the gauge coordinates v = p / (a, b, c): then
//   d p = -lambda o p,  d n = P (lambda o n)      (o: by components, P: across n)
//   by log a: lambda = (-1, 0, 0), ..;  by log n1: (log v_rho, log v_rho, log v_z);  by log n2: (log(v_x/v_rho), .., 0)
// with v log v = 0 at v = 0: finite on flats, at edges and for exponents near 1, where the growth is J's alone.
//
// Norm of a change of relative size e: each position moves by e times the pair's size L, each quaternion by e of its
// length (a turn of up to 2 e), each axis and each exponent by e of itself, all at once and in the worst way. The
// magnitudes below add up the groups' Frobenius norms: never below the worst case, above it by at most pi/2 for the
// normal (a plane's worth of response) and 2 for a point.
#pragma once

#include "solver/reference/interval/vector_interval.hpp"
#include "solver/reference/search/chart_solve.hpp"

namespace plumb::reference {

inline constexpr int shape_numbers = 5;                             ///< log a, log b, log c, log n1, log n2
inline constexpr int disturbances = 3 + 3 + 3 + 2 * shape_numbers;  ///< body 2 moved, body 1 and 2 turned, the shapes

template <class T>
using ByShape = Eigen::Matrix<T, 3, shape_numbers>;
/// A column a disturbance. Their number is told at run time: Eigen unrolls fixed ones, and 50 digits then compile for minutes.
template <class T, int Rows>
using ByDisturbance =
    Eigen::Matrix<T, Rows, Eigen::Dynamic, Rows == 1 ? Eigen::RowMajor : Eigen::ColMajor, Rows, disturbances>;

/// A surface point and its normal with their derivatives by the chart's coordinates and by the shape. Lengths, radians.
template <class T>
struct SurfaceJet {
  Vec3<T> point, normal;
  Tangent<T> dpoint, dnormal;
  ByShape<T> point_by_shape, normal_by_shape;

  [[nodiscard]] SurfaceJet turned(const Mat3<T>& r) const {
    return {r * point, r * normal, r * dpoint, r * dnormal, r * point_by_shape, r * normal_by_shape};
  }
};

/// A change of both contact points, relative to the pair's frame, and of body 2's centre.
template <class T>
struct Motion {
  Vec3<T> normal1 = zero(), point1 = zero(), normal2 = zero(), point2 = zero(), centre2 = zero();

  [[nodiscard]] static Vec3<T> zero() { return Vec3<T>::Constant(T(0)); }
};

/// Both contact points in the pair's frame: body 2's point is relative to its centre.
template <class T>
struct ContactJet {
  SurfaceJet<T> body1, body2;
  Vec3<T> centre2;
  T size;  ///< L
};

/// J, b of every disturbance, and what each does to normals and points while w is held.
template <class T>
struct Linearised {
  Eigen::Matrix<T, 6, 4> jacobian;
  ByDisturbance<T, 6> change{6, disturbances};
  ByDisturbance<T, 3> normal1{3, disturbances}, point1 = normal1, normal2 = normal1, point2 = normal1;
};

/// Factors by which a change can grow: see the head of this file.
template <class T>
struct Magnitudes {
  T overlap, normal1, normal2, point1, point2;
};

/// sqrt(sum of squares); for intervals too, where a square of x is not x times x.
template <class T, class Matrix>
[[nodiscard]] T frobenius_norm(const Matrix& m) {
  using std::abs;
  using std::sqrt;
  T sum(0);
  for (Eigen::Index j = 0; j < m.cols(); ++j)
    for (Eigen::Index i = 0; i < m.rows(); ++i) {
      const T size = abs(T(m(i, j)));
      sum += size * size;
    }
  return sqrt(sum);
}

/// The change of l x d, to first order (chart_solve.hpp).
template <class T>
[[nodiscard]] Vec3<T> collinearity_change(const ContactJet<T>& at, const Goal<T>& goal, const Motion<T>& by) {
  // First touch: a move of body 2 turns the line, which is along d. Undone motion: the line stays.
  if (goal.kind == GoalKind::first_touch || goal.kind == GoalKind::undone_motion)
    return cross_product<T>(goal.line, by.point1 - by.point2);
  if (goal.kind == GoalKind::deepest_point)
    return cross_product<T>(by.point2 - by.centre2, at.body1.point - at.centre2) +
           cross_product<T>(at.body2.point, by.point1 - by.centre2);
  return cross_product<T>(by.normal1, at.body1.point - at.body2.point - at.centre2) +
         cross_product<T>(at.body1.normal, by.point1 - by.point2);
}

/// The change of the six equations.
template <class T>
[[nodiscard]] Eigen::Matrix<T, 6, 1> equations_change(const ContactJet<T>& at, const Goal<T>& goal,
                                                      const Motion<T>& by) {
  Eigen::Matrix<T, 6, 1> out;
  out << by.normal1 + by.normal2, collinearity_change<T>(at, goal, by);
  return out;
}

/// The disturbances, in the order of `disturbances`.
template <class T>
[[nodiscard]] Motion<T> disturbance(const ContactJet<T>& at, int which) {
  Motion<T> out;
  const int k = which % 3;
  Vec3<T> axis = Motion<T>::zero();
  if (which < 9) axis[k] = T(1);
  if (which < 3) {
    out.point2 = out.centre2 = axis;
  } else if (which < 6) {
    out.normal1 = cross_product<T>(axis, at.body1.normal);
    out.point1 = cross_product<T>(axis, at.body1.point);
  } else if (which < 9) {
    out.normal2 = cross_product<T>(axis, at.body2.normal);
    out.point2 = cross_product<T>(axis, at.body2.point);
  } else if (which < 9 + shape_numbers) {
    out.normal1 = at.body1.normal_by_shape.col(which - 9);
    out.point1 = at.body1.point_by_shape.col(which - 9);
  } else {
    out.normal2 = at.body2.normal_by_shape.col(which - 9 - shape_numbers);
    out.point2 = at.body2.point_by_shape.col(which - 9 - shape_numbers);
  }
  return out;
}

/// J: body 1's two coordinates, then body 2's.
template <class T>
[[nodiscard]] Eigen::Matrix<T, 6, 4> equations_jacobian(const ContactJet<T>& at, const Goal<T>& goal) {
  Eigen::Matrix<T, 6, 4> out;
  for (int k = 0; k < 2; ++k) {
    Motion<T> along1, along2;
    along1.normal1 = at.body1.dnormal.col(k);
    along1.point1 = at.body1.dpoint.col(k);
    along2.normal2 = at.body2.dnormal.col(k);
    along2.point2 = at.body2.dpoint.col(k);
    out.col(k) = equations_change<T>(at, goal, along1);
    out.col(2 + k) = equations_change<T>(at, goal, along2);
  }
  return out;
}

template <class T>
[[nodiscard]] Linearised<T> linearised(const ContactJet<T>& at, const Goal<T>& goal) {
  Linearised<T> out;
  out.jacobian = equations_jacobian<T>(at, goal);
  for (int j = 0; j < disturbances; ++j) {
    const Motion<T> by = disturbance<T>(at, j);
    out.change.col(j) = equations_change<T>(at, goal, by);
    out.normal1.col(j) = by.normal1;
    out.point1.col(j) = by.point1;
    out.normal2.col(j) = by.normal2;
    out.point2.col(j) = by.point2;
  }
  return out;
}

/// Sum of the groups that both moved bodies share: turns count twice (a quaternion's half angle), shapes one by one.
template <class T, class Matrix>
[[nodiscard]] T turned_and_reshaped(const Matrix& response) {
  T sum = T(2) * (frobenius_norm<T>(response.middleCols(3, 3)) + frobenius_norm<T>(response.middleCols(6, 3)));
  for (int j = 9; j < disturbances; ++j) sum += frobenius_norm<T>(response.col(j));
  return sum;
}

/// `solution`: J x = b, a column a disturbance. A move of body 1 is one of both bodies together less one of body 2.
template <class T>
[[nodiscard]] Magnitudes<T> magnitudes(const ContactJet<T>& at, const Linearised<T>& by,
                                       const ByDisturbance<T, 4>& solution) {
  const T& size = at.size;
  const auto of_normal = [&](const ByDisturbance<T, 3>& held, const Tangent<T>& along, int row) -> T {
    const ByDisturbance<T, 3> response = held - along * solution.middleRows(row, 2);
    return T(2) * size * frobenius_norm<T>(response.leftCols(3)) + turned_and_reshaped<T>(response);
  };
  const auto of_point = [&](const ByDisturbance<T, 3>& held, const Tangent<T>& along, int row) -> T {
    const ByDisturbance<T, 3> response = held - along * solution.middleRows(row, 2);
    Mat3<T> other = -response.leftCols(3);
    for (int k = 0; k < 3; ++k) other(k, k) += T(1);
    return frobenius_norm<T>(response.leftCols(3)) + frobenius_norm<T>(other) + turned_and_reshaped<T>(response) / size;
  };
  // The overlap's first change is that at fixed w: o is stationary there.
  const ByDisturbance<T, 1> overlap = at.body1.normal.transpose() * (by.point1 - by.point2);
  return {T(2) * frobenius_norm<T>(overlap.leftCols(3)) + turned_and_reshaped<T>(overlap) / size,
          of_normal(by.normal1, at.body1.dnormal, 0), of_normal(by.normal2, at.body2.dnormal, 2),
          of_point(by.point1, at.body1.dpoint, 0), of_point(by.point2, at.body2.dpoint, 2)};
}

}  // namespace plumb::reference
