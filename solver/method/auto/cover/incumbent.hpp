// What a search for the lowest common normal has found, and what it saw on the way.
//
// `Form` offers   Vector3<S> farthest(v): p1 - p2 of the points farthest along v and -v, for any v but zero
//                 Answer solve(v, tries): a local solve; Answer has status, overlap,
//                 normal, iterations, evaluations
//                 Vector3<S> centre(): from body 1's centre to body 2's
//                 S inner_rolling_radius(): radius of a ball that rolls inside the bodies' Minkowski sum K, or less
//                 std::array<SupportShape<S>, 2> support_shapes()
//
// Witness         K = K' + (ball of radius r), so that o - r is the overlap with K'. f'(v) = (o - r)|v| >= g'.v for any g' of K',
//                 wherever it was found, and g'.v - (level - r)|v| is concave: where it is not negative at some
//                 directions nothing between them is lower. It is not concave where the level is below r; but then any
//                 common normal of that o is the lowest, whatever was excluded
// Slack           16 epsilon twice: cells are excluded to that below the lowest o seen, and an answer is one to that above it
#pragma once

#include <algorithm>
#include <limits>

#include "solver/method/auto/cover/curvature_bound.hpp"

namespace plumb {

/// Evaluations, all that came before among them, of a search that another follows, and of the last, its last solve apart: the
/// laws call 2000 slow.
inline constexpr int first_limit = 850, last_limit = 1650;

/// How much a local solve is worth.
enum class Tries { one, several, all };

template <class S, class Form, class Answer>
class Incumbent {
 public:
  /// `first`: an answer or not, with the evaluations so far; `limit`: of these and the search's own, last_limit at most.
  Incumbent(const Form& form, const S& size, const Answer& first, int limit)
      : form_(form), size_(size), ball_(form.inner_rolling_radius() * (S(1) - S(8) * epsilon<S>())), best_(first),
        limit_(std::min(limit, last_limit)) {}

  [[nodiscard]] const Answer& best() const { return best_; }
  [[nodiscard]] bool is_found() const { return best_.status == Status::converged; }
  [[nodiscard]] bool may_go_on() const { return best_.evaluations < limit_; }

  /// The lowest o that was seen, of a common normal or not: that of the lowest common normal is not above it.
  [[nodiscard]] S upper_bound() const { return std::min(found_overlap(), lowest_seen_); }

  /// There is one common normal of o <= r: nothing is lower.
  [[nodiscard]] bool is_settled() const { return !(found_overlap() > ball_); }

  [[nodiscard]] Vector3<S> farthest(const Vector3<S>& v) {
    count();
    return form_.farthest(v);
  }

  /// An evaluation of o.
  void count() { ++best_.evaluations; }

  /// g' at v, from g = farthest(v).
  [[nodiscard]] Vector3<S> witness(const Vector3<S>& v, const Vector3<S>& g) const {
    return g - v * (ball_ / length(v));
  }

  /// g' of a common normal, to its residual.
  [[nodiscard]] Vector3<S> witness(const Answer& found) const { return found.normal * (found.overlap - ball_); }

  /// A witness as high as this along a unit vector shows that o there is not below the level, to rounding.
  [[nodiscard]] S excluded_height() const { return excluded_overlap() - ball_; }
  [[nodiscard]] S excluded_overlap() const { return upper_bound() - rounding(); }
  [[nodiscard]] const S& ball() const { return ball_; }

  /// Whether o along v is below that of every common normal found; g = farthest(v).
  [[nodiscard]] bool sees_lower(const Vector3<S>& v, const Vector3<S>& g) {
    const S here = dot(g, v) / length(v);
    if (here < lowest_seen_) lowest_seen_ = here, seen_along_ = v;
    return here < found_overlap() - rounding();
  }

  [[nodiscard]] Answer solve(const Vector3<S>& v, Tries tries) {
    const Answer found = form_.solve(v, tries);
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

  void solve_from(const Vector3<S>& v, Tries tries) {
    const Answer found = solve(v, tries);
    if (found.status == Status::converged) take(found);
  }

  /// Solves once more where o was seen below every common normal found.
  void solve_lower() {
    if (has_seen_lower() && may_go_on()) solve_from(seen_along_, Tries::all);
  }

  /// The lowest; not converged where it is not known to be that, or o was seen below it.
  [[nodiscard]] Answer answer(bool is_complete) const {
    Answer out = best_;
    if (is_found() && (!is_complete || has_seen_lower())) out.status = Status::stalled;
    return out;
  }

  /// Of o.
  [[nodiscard]] S rounding() const { return S(noise) * epsilon<S>() * size_; }

 private:
  static constexpr double noise = 16;  // epsilon times this and the size: as much as a residual may be

  [[nodiscard]] bool has_seen_lower() const { return lowest_seen_ < found_overlap() - rounding(); }

  /// o of the lowest common normal found.
  [[nodiscard]] S found_overlap() const { return is_found() ? best_.overlap : std::numeric_limits<S>::infinity(); }

  const Form& form_;
  S size_, ball_;
  Answer best_;
  int limit_;  ///< of evaluations
  S lowest_seen_ = std::numeric_limits<S>::infinity();
  Vector3<S> seen_along_{};  ///< of any length
};

}  // namespace plumb
