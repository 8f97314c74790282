// The incumbent of a branch and bound: the lowest common normal found so far, and the lowest overlap seen on the way.
//
// Witness   K, the bodies' Minkowski sum, is K' + (ball of radius r), so that o - r is the overlap with K'. For any g' of K',
//           wherever it was found, (o - r)|v| >= g'.v. With the bound o*, g'.v - (o* - r)|v| is concave: where it is not
//           negative at some directions, nothing between them is lower. It is not concave where o* < r. But then any
//           common normal of that overlap is the lowest, whatever was excluded
// Slack     16 epsilon twice: cells are excluded to that below the bound, and an answer is accepted to that above it
#pragma once

#include <algorithm>
#include <concepts>
#include <limits>
#include <optional>

#include "solver/method/auto/cover/curvature_bound.hpp"
#include "solver/method/per_body.hpp"

namespace plumb {

/// How many attempts a local solve is worth.
enum class Attempts { one, several, all };

/// What a search ends with where latitudes, or directions, do not tell.
enum class LastCover { none, directions, heights };

/// What a search asks of the bodies. `Answer` has status, overlap, normal, iterations and evaluations.
template <class T, class S>
concept LocalSolver = requires(const T& solver, const Vector3<S>& v) {
  typename T::Answer;
  { solver.solve(v, Attempts::one) } -> std::same_as<typename T::Answer>;
  { solver.farthest(v) } -> std::same_as<Vector3<S>>;    ///< p1 - p2 of the points farthest along v and -v, v not zero
  { solver.centre() } -> std::same_as<Vector3<S>>;       ///< from body 1's centre to body 2's
  { solver.size() } -> std::same_as<S>;                  ///< what the rounding of o is relative to
  { solver.inner_rolling_radius() } -> std::same_as<S>;  ///< of a ball that rolls inside K, or less
};

template <class S, LocalSolver<S> Solver>
class Incumbent {
 public:
  using Answer = typename Solver::Answer;

  /// `first`: an answer or not, with the evaluations so far; `budget`: of these and the search's own.
  Incumbent(const Solver& solver, const Answer& first, int budget)
      : solver_(solver), size_(solver.size()),
        rolling_radius_(solver.inner_rolling_radius() * (S(1) - S(tolerance::touching) * epsilon<S>())), best_(first),
        budget_(budget) {}

  [[nodiscard]] const Solver& solver() const { return solver_; }
  [[nodiscard]] const Answer& best() const { return best_; }
  [[nodiscard]] bool is_found() const { return best_.status == Status::converged; }
  [[nodiscard]] bool may_go_on() const { return best_.evaluations < budget_; }

  /// The lowest overlap seen, of a common normal or not: that of the lowest common normal is not above it.
  [[nodiscard]] S bound() const { return std::min(found_overlap(), lowest_seen_); }

  /// There is one common normal of o <= r: nothing is lower.
  [[nodiscard]] bool is_settled() const { return !(found_overlap() > rolling_radius_); }

  [[nodiscard]] Vector3<S> farthest(const Vector3<S>& v) {
    count();
    return solver_.farthest(v);
  }
  /// The points themselves, each from its body's centre.
  [[nodiscard]] Vector3<PerBody<S>> farthest_points(const Vector3<S>& v) {
    count();
    return solver_.farthest_points(v);
  }

  /// From body 1's centre to body 2's, the greatest component 1; none where the centres coincide, or nearly.
  [[nodiscard]] std::optional<Vector3<S>> forwards() const {
    const Vector3<S> c = solver_.centre(), out = c * (S(1) / largest(c));
    return largest(out) <= S(2) ? std::optional(out) : std::nullopt;
  }

  /// An evaluation of o.
  void count() { ++best_.evaluations; }

  /// g' at v, from g = farthest(v).
  [[nodiscard]] Vector3<S> witness(const Vector3<S>& v, const Vector3<S>& g) const {
    return g - v * (rolling_radius_ / length(v));
  }

  /// g' of a common normal, to its residual.
  [[nodiscard]] Vector3<S> witness(const Answer& found) const {
    return found.normal * (found.overlap - rolling_radius_);
  }

  /// A witness as high as this along a unit vector shows that o there is not below the bound, to rounding.
  [[nodiscard]] S excluded_height() const { return excluded_overlap() - rolling_radius_; }
  [[nodiscard]] S excluded_overlap() const { return bound() - rounding(); }
  [[nodiscard]] const S& rolling_radius() const { return rolling_radius_; }

  /// Whether o along v is below that of every common normal found; g = farthest(v).
  [[nodiscard]] bool sees_lower(const Vector3<S>& v, const Vector3<S>& g) {
    const S here = dot(g, v) / length(v);
    if (here < lowest_seen_) lowest_seen_ = here, seen_along_ = v;
    return here < found_overlap() - rounding();
  }

  [[nodiscard]] Answer solve(const Vector3<S>& v, Attempts attempts) {
    const Answer found = solver_.solve(v, attempts);
    best_.evaluations += found.evaluations;
    return found;
  }

  /// A converged answer; whether it is the lowest so far.
  bool take(const Answer& found) {
    if (is_found() && !(found.overlap < best_.overlap)) return false;
    const int evaluations = best_.evaluations;
    best_ = found;
    best_.evaluations = evaluations;
    return true;
  }

  void solve_from(const Vector3<S>& v, Attempts attempts) {
    const Answer found = solve(v, attempts);
    if (found.status == Status::converged) take(found);
  }

  /// Solves once more where o was seen below every common normal found.
  void solve_lower() {
    if (has_seen_lower() && may_go_on()) solve_from(seen_along_, Attempts::all);
  }

  /// The lowest. Not converged where the search is not complete, or where o was seen below it.
  [[nodiscard]] Answer answer(bool is_complete) const {
    Answer out = best_;
    if (is_found() && (!is_complete || has_seen_lower())) out.status = Status::stalled;
    return out;
  }

  /// Of o.
  [[nodiscard]] S rounding() const { return S(tolerance::search_noise) * epsilon<S>() * size_; }

 private:
  [[nodiscard]] bool has_seen_lower() const { return lowest_seen_ < found_overlap() - rounding(); }

  /// Of the lowest common normal found.
  [[nodiscard]] S found_overlap() const { return is_found() ? best_.overlap : std::numeric_limits<S>::infinity(); }

  const Solver& solver_;
  S size_, rolling_radius_;
  Answer best_;
  int budget_;  ///< of evaluations
  S lowest_seen_ = std::numeric_limits<S>::infinity();
  Vector3<S> seen_along_{};  ///< of any length
};

}  // namespace plumb
