// The contact of two ellipsoids: start, Newton, guard.
#pragma once

#include "solver/method/auto/cover/branch_and_bound.hpp"
#include "solver/method/auto/cover/heights.hpp"
#include "solver/method/auto/ellipsoid/ellipsoid_guard.hpp"
#include "solver/method/auto/ellipsoid/ellipsoid_newton.hpp"

namespace plumb {

template <class S>
struct EllipsoidForm {
  const EllipsoidPair<S>& pair;
  const Want& want;
  Vector3<S> axis{S(0), S(0), S(0)};  ///< as for EllipsoidNewton

  [[nodiscard]] S inner_rolling_radius() const { return plumb::inner_rolling_radius(pair); }
  [[nodiscard]] Vector3<S> centre() const { return pair.c; }
  [[nodiscard]] Vector3<S> farthest(const Vector3<S>& v) const { return sum(touch(pair, v).p) - pair.c; }
  [[nodiscard]] std::array<SupportShape<S>, 2> support_shapes() const {
    return {SupportShape<S>{first(pair.map), S(2), S(2)}, SupportShape<S>{second(pair.map), S(2), S(2)}};
  }
  [[nodiscard]] EllipsoidForm without_rotation(const Vector3<S>& about) const { return {pair, want, about}; }
  [[nodiscard]] EllipsoidContact<S> solve(const Vector3<S>& start, Tries /*tries*/ = Tries::all) const {
    EllipsoidContact<S> out;
    EllipsoidNewton<S>(pair, want, axis).solve(out, start);
    return out;
  }
};

template <class S>
[[nodiscard]] inline bool is_surely_lowest(const EllipsoidPair<S>& pair, const EllipsoidContact<S>& contact) {
  if (contact.status != Status::converged) return false;
  return contact.overlap <= S(0) || is_within_rolling_radius<S>(pair, contact.overlap) ||
         is_inner_lowest<S>(pair, contact.at.touch, contact.normal, contact.overlap);
}

/// The common normal that the start leads to.
template <class S>
[[nodiscard]] inline EllipsoidContact<S> local_contact(const EllipsoidPair<S>& pair, const Want& want,
                                                       const Vector3<S>& start) {
  return EllipsoidForm<S>{pair, want}.solve(start);
}

template <class S>
[[nodiscard]] inline EllipsoidContact<S> cold_contact(const EllipsoidPair<S>& pair, const Want& want) {
  EllipsoidContact<S> out = local_contact(pair, want, cold_start(pair, ellipsoid_start(pair)));
  out.evaluations += start_corrections;
  return out;
}

/// The lower of a warm start's contact and of the cold start's: a body that has left a ring of lowest normals leaves the warm
/// start on a saddle, a place from which a search takes long.
template <class S>
[[nodiscard]] inline EllipsoidContact<S> or_cold_contact(const EllipsoidPair<S>& pair, const Want& want,
                                                         const EllipsoidContact<S>& warm) {
  EllipsoidContact<S> out = cold_contact(pair, want);
  const int evaluations = warm.evaluations + out.evaluations;
  const bool is_found = warm.status == Status::converged;
  if (out.status != Status::converged || (is_found && warm.overlap <= out.overlap)) out = warm;
  out.evaluations = evaluations;
  return out;
}

inline constexpr int few_iterations = 14;

/// The lowest common normal, by searches from `found` on.
template <class S>
[[nodiscard, gnu::noinline]] inline EllipsoidContact<S>
searched_contact(const Pair& bodies, const EllipsoidPair<S>& pair, const Want& want, const EllipsoidContact<S>& found) {
  const PlacedPair<S> placed = place<S>(bodies);
  const std::optional<Vector3<S>> axis = common_axis(placed);
  const EllipsoidForm<S> form{pair, want, axis.value_or(Vector3<S>{S(0), S(0), S(0)})};
  const auto by_heights = [&](const auto& of, const EllipsoidContact<S>& best) {
    using Form = std::decay_t<decltype(of)>;
    if constexpr (std::is_floating_point_v<S>)
      return search_by<HeightCover<S, Form, EllipsoidContact<S>>>(of, best, last_limit, pair).lowest;
    else  // of 50 digits cells would be divided too often, and Eigen has no eigenvectors
      return Incumbent<S, Form, EllipsoidContact<S>>(of, pair.size, best, 0).answer(false);
  };
  if (const std::optional<ParallelAxesBound<S>> bands = ParallelAxesBound<S>::of(placed))
    return lowest_by_latitude(*bands, form, pair.size, found, by_heights);
  constexpr int limit = std::is_floating_point_v<S> ? first_limit : last_limit;
  using ByDirection = DirectionCover<S, EllipsoidForm<S>, EllipsoidContact<S>, limit>;
  const auto [lowest, best] = search_by<ByDirection>(form, pair.size, found, RotationDerivative<S>::of(placed));
  return lowest.status == Status::converged ? lowest : by_heights(form, best);
}

/// `found` where it is surely the lowest, else the cold start's, should it be from a warm one, else the lowest of a search.
template <class S>
[[nodiscard]] inline EllipsoidContact<S> lowest_contact(const Pair& bodies, const EllipsoidPair<S>& pair,
                                                        const Want& want, EllipsoidContact<S> found, bool is_warm) {
  if (is_surely_lowest<S>(pair, found)) return found;
  if (found.status != Status::converged && want.iteration_limit < few_iterations) return found;  // asked to stop
  if (is_warm) found = or_cold_contact(pair, want, found);
  if (is_warm && is_surely_lowest<S>(pair, found)) return found;
  return searched_contact(bodies, pair, want, found);
}

}  // namespace plumb
