// What a core's support points are, as core.hpp has them.
#pragma once

#include "solver/contact.hpp"

namespace plumb::detail {

/// A support point, and the piece that it is of.
struct CorePoint {
  Vec3<double> point;
  int piece;
};

/// x on a piece, and its derivative by u: Hess h, symmetric, for a unit u.
struct PieceSupport {
  Vec3<double> point;
  Mat3<double> hessian;
};

}  // namespace plumb::detail
