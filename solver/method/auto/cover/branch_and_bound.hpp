// The branch and bound for the lowest common normal. Its covers, each a way to divide the directions into cells:
//
// Sectors      all pairs first: a few cells about the common normal that is known (sectors.hpp)
// Latitudes    axes of revolution parallel, or parallel to rounding (latitudes.hpp)
// Quadrangles  axes of revolution nearly parallel, not of ellipsoids (quadrangles.hpp)
// Directions   all other pairs (directions.hpp)
// Heights      ellipsoids, where neither latitudes nor directions come to an end (heights.hpp)
//
// Its proofs are made in the scalar's own rounding; proofs by intervals are reference/'s. The number of evaluations is
// limited. An answer is not called converged where cells are left, or where a lower overlap was seen on the way.
#pragma once

#include "solver/method/auto/budgets.hpp"
#include "solver/method/auto/cover/directions.hpp"
#include "solver/method/auto/cover/heights.hpp"
#include "solver/method/auto/cover/latitudes.hpp"
#include "solver/method/auto/cover/quadrangles.hpp"
#include "solver/method/auto/cover/sectors.hpp"

namespace plumb {

template <class C>
concept Cover = requires(C& cover, const C& seen) {
  cover.start();         ///< with the widest cells
  cover.look_at_next();  ///< excludes a cell, or divides it
  { seen.is_empty() } -> std::same_as<bool>;
  { seen.has_left_out() } -> std::same_as<bool>;  ///< a cell that is too small to be divided
};

template <class Answer>
struct Searched {
  Answer lowest;  ///< as the search vouches for it
  Answer best;    ///< what another search goes on from
};

//! [branch_and_bound]
/// The lowest common normal from `first` on. Not inlined: the cells are on the stack, and gone before the next search.
template <Cover Cells, class Solver, class... Geometry>
[[nodiscard, gnu::noinline]] Searched<typename Solver::Answer>
branch_and_bound(const Solver& solver, const typename Solver::Answer& first, int budget, const Geometry&... geometry) {
  typename Cells::Incumbent incumbent(solver, first, budget);
  Cells cells(incumbent, geometry...);
  cells.start();
  while (!cells.is_empty() && !incumbent.is_settled() && incumbent.may_go_on()) cells.look_at_next();
  incumbent.solve_lower();
  const bool is_complete = (cells.is_empty() || incumbent.is_settled()) && !cells.has_left_out();
  return {incumbent.answer(is_complete), incumbent.best()};
}
//! [branch_and_bound]

/// A solver whose solves do not turn about a line where o is nearly the same all around it. Where that fails they may.
template <class S, class Solver>
struct WithoutRotation {
  using Answer = typename Solver::Answer;

  const Solver& free;
  std::optional<Solver> held;

  WithoutRotation(const Solver& solver, const std::optional<Vector3<S>>& axis) : free(solver) {
    if (axis) held.emplace(solver.without_rotation(*axis));
  }

  [[nodiscard]] S inner_rolling_radius() const { return free.inner_rolling_radius(); }
  [[nodiscard]] Vector3<S> centre() const { return free.centre(); }
  [[nodiscard]] S size() const { return free.size(); }
  [[nodiscard]] Vector3<S> farthest(const Vector3<S>& v) const { return free.farthest(v); }
  [[nodiscard]] Answer solve(const Vector3<S>& v, Attempts attempts) const {
    if (!held) return free.solve(v, attempts);
    const Answer first = held->solve(v, Attempts::one);
    if (first.status == Status::converged) return first;
    Answer out = free.solve(v, attempts);
    out.evaluations += first.evaluations;
    return out;
  }
};

/// For axes that TiltedAxesBound is for. Not inlined: the bound is on the stack, and not there in other searches.
template <class S, class Solver>
[[nodiscard, gnu::noinline]] typename Solver::Answer
lowest_by_quadrangles(const Solver& solver, const PlacedPair<S>& placed, const typename Solver::Answer& first) {
  using Quadrangles = QuadrangleCover<S, Solver>;
  return branch_and_bound<Quadrangles>(solver, first, budget::quadrangles, TiltedAxesBound<S>(placed)).lowest;
}

/// By the covers that suit the axes of revolution, and where these do not come to an end by the one that suits the solver.
template <class S, class Solver>
[[nodiscard, gnu::noinline]] typename Solver::Answer lowest_by_axes(const Solver& solver, const PlacedPair<S>& placed,
                                                                    const typename Solver::Answer& first) {
  using Answer = typename Solver::Answer;
  using Held = WithoutRotation<S, Solver>;
  constexpr bool ends_by_heights = Solver::last_cover == LastCover::heights;
  constexpr int by_directions = ends_by_heights ? budget::first_search : budget::last_search;
  const auto search_directions = [&](const Answer& from) {
    using Directions = DirectionCover<S, Solver, by_directions>;
    return branch_and_bound<Directions>(solver, from, by_directions, RotationDerivative<S>::of(placed));
  };
  const std::optional<ParallelAxesBound<S>> parallel = ParallelAxesBound<S>::of(placed);
  const Held held(solver, parallel ? parallel->circle_axis() : std::nullopt);
  if constexpr (!ends_by_heights)
    if (TiltedAxesBound<S>::is_for(placed)) return lowest_by_quadrangles<S>(held, placed, first);
  const bool is_coaxial = parallel && parallel->is_coaxial();
  const int by_latitudes = is_coaxial ? budget::last_search : budget::first_search;
  const Searched<Answer> found = parallel
                                     ? branch_and_bound<LatitudeCover<S, Held>>(held, first, by_latitudes, *parallel)
                                     : search_directions(first);
  if (found.lowest.status == Status::converged || is_coaxial) return found.lowest;
  if constexpr (ends_by_heights)
    return branch_and_bound<HeightCover<S, Held>>(held, found.best, budget::last_search, solver.pair).lowest;
  if (Solver::last_cover == LastCover::directions && parallel) return search_directions(found.best).lowest;
  return found.lowest;
}

/// `found`, or the same stalled where sectors do not show that it is the lowest. Solves nothing: the covers that come after
/// start better. 15 evaluations at most, whatever was spent, fewer by the witnesses to begin with; then `witnesses` are those of the proof,
/// or none where there is none.
template <class S, class Solver>
[[nodiscard, gnu::noinline]] typename Solver::Answer
proved_by_sectors(const Solver& solver, const typename Solver::Answer& found, std::optional<Witnesses<S>>& witnesses) {
  using Sectors = SectorCover<S, Solver>;
  static_assert(Cover<Sectors>);
  Incumbent<S, Solver> incumbent(solver, found, budget::first_search);
  Sectors sectors(incumbent, witnesses ? &*witnesses : nullptr);
  sectors.start();
  while (!sectors.is_empty() && !incumbent.is_settled()) sectors.look_at_next();
  const bool is_proved = incumbent.is_settled() || !sectors.has_left_out();
  if (!is_proved) witnesses.reset();
  if (is_proved && sectors.has_seen_more()) witnesses = sectors.witnesses();
  return incumbent.answer(is_proved);
}

/// The lowest common normal from `first` on, an answer or not. Where sectors prove it, `witnesses` are those of the proof.
template <class S, class Solver>
[[nodiscard, gnu::noinline]] typename Solver::Answer lowest_by_search(const Solver& solver, const Pair& bodies,
                                                                      const typename Solver::Answer& first,
                                                                      std::optional<Witnesses<S>>& witnesses) {
  using Answer = typename Solver::Answer;
  int spent = 0;  // not out of the budget: few pairs need the last of it
  {
    const Answer proved = proved_by_sectors<S>(solver, first, witnesses);
    if (proved.status == Status::converged) return proved;
    spent = proved.evaluations - first.evaluations;
  }
  const PlacedPair<S> placed = place<S>(bodies);
  const Vector3<S> none{S(0), S(0), S(0)};
  Answer out = lowest_by_axes<S>(solver.without_rotation(common_axis(placed).value_or(none)), placed, first);
  out.evaluations += spent;
  return out;
}

}  // namespace plumb
