// The search that suits a pair: over a meridian where axes of revolution are parallel, else, or where that ends open, over
// all directions.
#pragma once

#include "solver/method/direction_search.hpp"
#include "solver/method/meridian_search.hpp"

namespace plumb {

/// The lowest common normal from `first` on, by a `Form` as lowest.hpp asks for. `size`: what the rounding of o is relative to.
template <class S, class Form, class Answer>
[[nodiscard]] Answer lowest_of_search(const PlacedPair<S>& pair, const Form& form, const S& size, const Answer& first) {
  Answer start = first;
  if (const std::optional<BandPair<S>> bands = BandPair<S>::of(pair)) {
    MeridianSearch<S, Form, Answer> search(form, size, *bands, first);
    const Answer found = search.lowest();
    if (found.status == Status::converged || bands->is_coaxial()) return found;
    start = search.best();
  }
  return DirectionSearch<S, Form, Answer>(form, size, start, TurnSlope<S>::of(pair)).lowest();
}

}  // namespace plumb
