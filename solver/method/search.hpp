// The search that suits a pair: over a meridian where the lowest common normals are a ring, else over all directions.
#pragma once

#include "solver/method/common_axis.hpp"
#include "solver/method/direction_search.hpp"
#include "solver/method/meridian_search.hpp"

namespace plumb {

/// The lowest common normal from `first` on, by a `Form` as lowest.hpp asks for. `axis`: common_axis of the pair; `size`: what
/// the rounding of o is relative to.
template <class S, class Form, class Answer>
[[nodiscard]] Answer lowest_of_search(const PlacedPair<S>& pair, const std::optional<Vector3<S>>& axis,
                                      const Form& form, const S& size, const Answer& first) {
  if (axis) return MeridianSearch<S, Form, Answer>(form, size, *axis, first).lowest();
  return DirectionSearch<S, Form, Answer>(form, size, first, TurnSlope<S>::of(pair)).lowest();
}

}  // namespace plumb
