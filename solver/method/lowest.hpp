// What a search for the lowest common normal has found, and what it saw on the way.
//
// `Form` offers   Vector3<S> farthest(v): p1 - p2 of the points farthest along v and -v, for any v but zero
//                 Answer solve(v, insists): a local solve, by all means where it insists; Answer has status, overlap,
//                 normal, iterations, evaluations
//                 Vector3<S> centre(): from body 1's centre to body 2's
//                 S rolling_ball(): radius of a ball that rolls inside the bodies' Minkowski sum K, or less
//                 int least_level(): of a cell that six points can explain; higher where o has narrow folds
//                 int least_level(v, reach): the same within that distance of v, of any length; not less
//
// Excluded        K = K' + (ball of radius r), so that o - r is the overlap with K'. f'(v) = (o - r)|v| >= g'.v for any g' of K',
//                 wherever it was found, and g'.v - (level - r)|v| is concave: where it is not negative at some
//                 directions nothing between them is lower
#pragma once

#include <algorithm>
#include <limits>

#include "solver/method/vector3.hpp"
#include "solver/scalar.hpp"

namespace plumb {

template <class S, class Form, class Answer>
class Lowest {
 public:
  static constexpr int most_evaluations = 980;  // a Newton below the 1000 that the laws call slow

  Lowest(const Form& form, const S& size, const Answer& first)
      : form_(form), size_(size), ball_(form.rolling_ball() * (S(1) - S(8) * epsilon<S>())), best_(first) {}

  [[nodiscard]] const Answer& best() const { return best_; }
  [[nodiscard]] bool is_found() const { return best_.status == Status::converged; }
  [[nodiscard]] bool may_go_on() const { return best_.evaluations < most_evaluations; }

  /// o of the lowest.
  [[nodiscard]] S level() const { return is_found() ? best_.overlap : std::numeric_limits<S>::infinity(); }

  /// There is one common normal of o <= r: nothing is lower.
  [[nodiscard]] bool is_settled() const { return !(level() > ball_); }

  /// Of o.
  [[nodiscard]] S rounding() const { return S(noise) * epsilon<S>() * size_; }

  [[nodiscard]] Vector3<S> farthest(const Vector3<S>& v) {
    ++best_.evaluations;
    return form_.farthest(v);
  }

  /// g' at v, from g = farthest(v).
  [[nodiscard]] Vector3<S> witness(const Vector3<S>& v, const Vector3<S>& g) const {
    return g - v * (ball_ / length(v));
  }

  /// Whether the witness shows that o along v is not below the level by more than `slack`.
  [[nodiscard]] bool excludes(const Vector3<S>& witness, const Vector3<S>& v, const S& slack = S(0)) const {
    return dot(witness, v) >= (level() - ball_ - slack) * length(v);
  }

  /// Whether o along v is below the level; g = farthest(v).
  [[nodiscard]] bool sees_lower(const Vector3<S>& v, const Vector3<S>& g) {
    const S here = dot(g, v) / length(v);
    lowest_seen_ = std::min(lowest_seen_, here);
    return here < level() - rounding();
  }

  [[nodiscard]] Answer solve(const Vector3<S>& v, bool insists) {
    const Answer found = form_.solve(v, insists);
    best_.evaluations += found.evaluations;
    return found;
  }

  /// A converged answer.
  void take(const Answer& found) {
    if (is_found() && !(found.overlap < best_.overlap)) return;
    const int evaluations = best_.evaluations;
    best_ = found;
    best_.evaluations = evaluations;
  }

  /// The lowest; not converged where it is not known to be that, or o was seen below it.
  [[nodiscard]] Answer answer(bool is_complete) const {
    Answer out = best_;
    if (is_found() && (!is_complete || lowest_seen_ < level() - rounding())) out.status = Status::stalled;
    return out;
  }

 private:
  static constexpr double noise = 64;  // epsilon times this and the size: rounding of a gradient

  const Form& form_;
  S size_, ball_;
  Answer best_;
  S lowest_seen_ = std::numeric_limits<S>::infinity();
};

}  // namespace plumb
