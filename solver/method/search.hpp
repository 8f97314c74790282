// The search that suits a pair: over a meridian where axes of revolution are parallel, else, or where that ends open, over
// all directions.
#pragma once

#include "solver/method/direction_search.hpp"
#include "solver/method/meridian_search.hpp"

namespace plumb {

/// A form whose solves do not turn about a line about which o is all but the same; where that fails they are free to.
template <class S, class Form, class Answer>
struct HeldForm {
  const Form& free;
  Form held;

  [[nodiscard]] S rolling_ball() const { return free.rolling_ball(); }
  [[nodiscard]] Vector3<S> centre() const { return free.centre(); }
  [[nodiscard]] Vector3<S> farthest(const Vector3<S>& v) const { return free.farthest(v); }
  [[nodiscard]] Answer solve(const Vector3<S>& v, Tries tries) const {
    const Answer first = held.solve(v, Tries::one);
    if (first.status == Status::converged) return first;
    Answer out = free.solve(v, tries);
    out.evaluations += first.evaluations;
    return out;
  }
};

/// The lowest common normal from `first` on, by a `Form` as lowest.hpp asks for. `size`: what the rounding of o is relative to.
template <class S, class Form, class Answer>
[[nodiscard]] Answer lowest_of_search(const PlacedPair<S>& pair, const Form& form, const S& size, const Answer& first) {
  const std::optional<BandPair<S>> bands = BandPair<S>::of(pair);
  if (!bands) return DirectionSearch<S, Form, Answer>(form, size, first, TurnSlope<S>::of(pair)).lowest();
  const auto by_latitude = [&](const auto& of) {
    return MeridianSearch<S, std::decay_t<decltype(of)>, Answer>(of, size, *bands, first).lowest();
  };
  const std::optional<Vector3<S>> ring = bands->ring_axis();
  const Answer found = ring ? by_latitude(HeldForm<S, Form, Answer>{form, form.held(*ring)}) : by_latitude(form);
  if (found.status == Status::converged || bands->is_coaxial()) return found;
  Answer start = first;
  start.evaluations = found.evaluations;
  return DirectionSearch<S, Form, Answer>(form, size, start, TurnSlope<S>::of(pair)).lowest();
}

}  // namespace plumb
