// The contact of two ellipsoids: start, Newton, guard.
#pragma once

#include "solver/method/direction_search.hpp"
#include "solver/method/ellipsoid_guard.hpp"
#include "solver/method/ellipsoid_newton.hpp"

namespace plumb {

template <class S>
struct EllipsoidForm {
  const EllipsoidPair<S>& pair;
  const Want& want;

  [[nodiscard]] int least_level() const { return 3; }
  [[nodiscard]] Vector3<S> centre() const { return pair.c; }
  [[nodiscard]] Vector3<S> farthest(const Vector3<S>& v) const { return sum(touch(pair, v).p) - pair.c; }
  [[nodiscard]] EllipsoidContact<S> solve(const Vector3<S>& start, bool /*insists*/ = true) const {
    EllipsoidContact<S> out;
    EllipsoidNewton<S>(pair, want).solve(out, start);
    return out;
  }
};

template <class S>
[[nodiscard]] inline bool is_surely_lowest(const EllipsoidPair<S>& pair, const EllipsoidContact<S>& contact) {
  if (contact.status != Status::converged) return false;
  return contact.overlap <= S(0) || rolls<S>(pair, contact.overlap) ||
         is_inner_lowest<S>(pair, contact.at.touch, contact.normal, contact.overlap);
}

/// The common normal that the start leads to.
template <class S>
[[nodiscard]] inline EllipsoidContact<S> local_contact(const EllipsoidPair<S>& pair, const Want& want,
                                                       const Vector3<S>& start) {
  return EllipsoidForm<S>{pair, want}.solve(start);
}

inline constexpr int few_iterations = 14;

/// `found` where it is surely the lowest, else the lowest of a search.
template <class S>
[[nodiscard]] inline EllipsoidContact<S> lowest_contact(const EllipsoidPair<S>& pair, const Want& want,
                                                        const EllipsoidContact<S>& found) {
  if (is_surely_lowest<S>(pair, found)) return found;
  if (found.status != Status::converged && want.iteration_limit < few_iterations) return found;  // asked to stop
  const EllipsoidForm<S> form{pair, want};
  return DirectionSearch<S, EllipsoidForm<S>, EllipsoidContact<S>>(form, pair.size, found).lowest();
}

}  // namespace plumb
