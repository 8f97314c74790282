// Krawczyk's test on the chart equations (chart_solve.hpp).
//
// Existence and uniqueness come from four of the six equations, G = (e_k.(n1 + n2), e_k.(n1 x (p1 - p2))), k = 1, 2, with two
// fixed vectors e1, e2 across the approximate normal and e3 = e1 x e2. Where G = 0, n1 + n2 = s e3 with s = 0 or, n1 and n2
// being unit, n1.n2 = 2 (n1.e3)^2 / |e3|^2 - 1; and n1 x (p1 - p2) = g e3 with g n1.e3 = 0. So on a box where n1.n2 < 0 and
// (n1.e3)^2 > |e3|^2 / 2, G = 0 is all of a common normal. In chart coordinates nothing is infinite: where one body's flat or
// edge makes the second derivatives by direction infinite, this test still proves.
#pragma once

#include "solver/reference/interval/interval_mpfi.hpp"
#include "solver/reference/interval/surface_enclosure.hpp"

namespace plumb::reference {

/// Both bodies over the boxes of half-width `radius` about a chart pair, pair frame.
[[nodiscard]] ContactJet<Interval80> contact_jet(const EnclosedPair<Interval80>& pair, const ChartPair<Real50>& at,
                                                 const Interval80& radius);

/// What is proved about the common normals near a chart pair.
struct ChartProof {
  bool exists = false;  ///< just one common normal lies in the box of half-width `radius` about the chart pair
  double radius = 0;    ///< chart coordinates, all four
  double error = 0;     ///< its chart coordinates are within this of the pair's
};

/// The four equations and an approximate inverse of their Jacobian.
struct SquareForm {
  Eigen::Matrix<Interval80, 4, 6> choice;   ///< G = choice F
  Eigen::Matrix<Interval80, 4, 4> inverse;  ///< near that of choice J; any matrix is right
  IVec3<Interval80> across;                 ///< e3
};
[[nodiscard]] SquareForm square_form(const PlacedPair<Real50>& placed, const ChartPair<Real50>& at);

/// Krawczyk's test on the box of half-width `radius`.
[[nodiscard]] ChartProof prove_on_box(const EnclosedPair<Interval80>& pair, const SquareForm& form,
                                      const ChartPair<Real50>& at, const Interval80& radius);

/// Row sums of |1 - C J| over a box: an upper bound of its norm.
[[nodiscard]] Interval80 contraction(const SquareForm& form, const Eigen::Matrix<Interval80, 6, 4>& jacobian);

/// The proof, with what it was found with: all derivatives over the box, and |1 - C J| there.
struct ProvedBox {
  ChartProof proof;
  ContactJet<Interval80> jet;
  Interval80 contraction;
};

/// The test on the smallest box that can hold the solution: four times the first Newton step.
[[nodiscard]] ProvedBox prove_solution(const EnclosedPair<Interval80>& pair, const SquareForm& form,
                                       const ChartPair<Real50>& at);

}  // namespace plumb::reference
