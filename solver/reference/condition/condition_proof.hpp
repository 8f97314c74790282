// Proof that reported condition numbers are right to a factor of two.
#pragma once

#include "solver/reference/condition/solution_set.hpp"
#include "solver/reference/interval/chart_interval.hpp"
#include "solver/reference/reference.hpp"

namespace plumb::reference {

/// What is proved of one condition number.
enum class ConditionClaim {
  open,       ///< neither proved nor refuted
  certified,  ///< the true number is within a factor of two of the reported one
  refuted,    ///< it is not
  infinite    ///< reported as infinite, and not refuted: a SolutionSet takes its place
};
/// "open", "certified", "refuted", "infinite".
[[nodiscard]] std::string_view name(ConditionClaim claim);

/// The true condition numbers (condition.hpp's, at the true common normal) lie between the two.
struct ConditionProof {
  ChartProof solution;
  Condition lower{0, 0, 0}, upper{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::infinity()};
  ConditionClaim overlap = ConditionClaim::open, normal = ConditionClaim::open, points = ConditionClaim::open;
};

/// `at`: the common normal's chart pair in 50 digits. Encloses the Jacobian and the changes of the equations over the box
/// that is proved to hold the true one, and solves with a verified approximate inverse.
[[nodiscard]] ConditionProof certify_condition(const Pair& pair, const ChartPair<Real50>& at,
                                               const Condition& reported);

/// The same for a solution that find_reference gave in 50 digits.
[[nodiscard]] ConditionProof certify_condition(const Pair& pair, const Solution& found);

/// The overlap's condition where the chart equations prove nothing (flat on flat): it depends on the direction and the points
/// alone, and little, so that a set which holds the true ones (for any k) will do.
[[nodiscard]] ConditionClaim certify_overlap_condition(const Pair& pair, const SolutionSet& set, double reported);

/// The claim about one number.
[[nodiscard]] ConditionClaim judge(double reported, double lower, double upper);

}  // namespace plumb::reference
