// What rounding does to an answer where a condition number, which is a first derivative, does not say: the exact answers to inputs
// nearby.
//
// Each number of the input alone is changed by k epsilon either way, in the norm of sensitivity.hpp, and the common normal is
// followed there in 50 digits; for each number the larger of the two changes counts, and these are summed up: all numbers at once
// and in the worst way, as a condition number has it, but over the whole step. In a corner of exponent 8 a normal's 1e-15 moves a
// point as t^7 goes back to t, whose derivative at the answer says nothing of the answer next to it.
#pragma once

#include "solver/reference/reference.hpp"

namespace plumb::reference {

/// No overlap's condition number exceeds 2 sqrt(3) (1 + 2 + 1 + 2 log 2): both bodies shifted, turned, stretched, with other
/// exponents, of reaches up to sqrt(3) semi-axes.
inline constexpr double largest_overlap_condition = 19;

/// How far the exact answers to inputs nearby are.
struct NearbyAnswers {
  double normal = 0;  ///< rad
  double points = 0;  ///< the larger of both points', a length
};

/// `found`: solved. A neighbour whose own answer is not found, or is another common normal, counts as none.
[[nodiscard]] NearbyAnswers nearby_answers(const Pair& pair, const Solution& found, double k);

/// A hundred times that, from neighbours in long double, whose steps are a thousand of its epsilons; infinite where one of their
/// answers is not found, and where exponents are so large, or so near to 1, that long double does not
/// tell them apart. For who asks only whether an error is far more.
[[nodiscard]] NearbyAnswers more_than_nearby(const Pair& pair, const Solution& found, double k);

}  // namespace plumb::reference
