// The searches for the lowest common normal, and what each may cost.
//
// Over latitudes         axes of revolution parallel, or all but that: latitudes.hpp
// Over all directions    else: directions.hpp
// Over two heights       ellipsoids, where the first of these has not come to an end: heights.hpp
#pragma once

#include "solver/method/auto/cover/directions.hpp"
#include "solver/method/auto/cover/latitudes.hpp"

namespace plumb {

/// A form whose solves do not turn about a line about which o is all but the same; where that fails they are free to.
template <class S, class Form, class Answer>
struct HeldForm {
  const Form& free;
  Form held;

  [[nodiscard]] S inner_rolling_radius() const { return free.inner_rolling_radius(); }
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

template <class Answer>
struct Searched {
  Answer lowest;  ///< as the search vouches for it
  Answer best;    ///< what another search goes on from
};

/// What a search finds. Not inlined: its cells are on the stack where there is a search, and gone before the next one.
template <class Search, class... Arguments>
[[nodiscard, gnu::noinline]] auto search_by(const Arguments&... arguments) {
  Search search(arguments...);
  const auto lowest = search.lowest();
  return Searched<std::decay_t<decltype(lowest)>>{lowest, search.best()};
}

/// The lowest common normal from `first` on, over latitudes; where they do not tell, what `last(form, best)` says.
/// `Form`: incumbent.hpp. `size`: what the rounding of o is relative to.
template <class S, class Form, class Answer, class Last>
[[nodiscard]] Answer lowest_by_latitude(const ParallelAxesBound<S>& bands, const Form& form, const S& size,
                                        const Answer& first, const Last& last) {
  const auto search = [&](const auto& of) {
    using ByLatitude = LatitudeCover<S, std::decay_t<decltype(of)>, Answer>;
    const auto [lowest, best] =
        search_by<ByLatitude>(of, size, first, bands.is_coaxial() ? last_limit : first_limit, bands);
    return lowest.status == Status::converged || bands.is_coaxial() ? lowest : last(of, best);
  };
  const std::optional<Vector3<S>> ring = bands.circle_axis();
  return ring ? search(HeldForm<S, Form, Answer>{form, form.without_rotation(*ring)}) : search(form);
}

}  // namespace plumb
