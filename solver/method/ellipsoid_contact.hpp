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

  [[nodiscard]] int least_level() const { return 1; }
  [[nodiscard]] Vector3<S> farthest(const Vector3<S>& v) const { return sum(touch(pair, v).p) - pair.c; }
  [[nodiscard]] EllipsoidContact<S> solve(const Vector3<S>& start) const {
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

inline constexpr int few_iterations = 14;

template <class S>
[[nodiscard]] inline EllipsoidContact<S> ellipsoid_contact(const EllipsoidPair<S>& pair, const Want& want,
                                                           const Vector3<S>& start) {
  EllipsoidContact<S> out;
  EllipsoidNewton<S>(pair, want).solve(out, start);
  if (is_surely_lowest<S>(pair, out)) return out;
  if (out.status != Status::converged && want.iteration_limit < few_iterations) return out;  // asked to stop
  const EllipsoidForm<S> form{pair, want};
  return DirectionSearch<S, EllipsoidForm<S>, EllipsoidContact<S>>(form, pair.size, out).lowest();
}

}  // namespace plumb
