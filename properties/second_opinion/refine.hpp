// A candidate of the search brought to a minimum in 128 bits.
#pragma once

#include <vector>

#include "search.hpp"

namespace second_opinion {

struct Minimum {
  Vec<Quad> normal;
  Quad value;
  Vec<Quad> point1, point2;  ///< from body 1's centre
  double loose;              ///< by how much points of as good a direction differ from these, over the size
};

/// From a direction no further off than `radius` rad.
[[nodiscard]] Minimum refine(const Pair<Quad>& pair, Question question, const Vec<Quad>& start, double radius);

/// The lowest of each valley that the search found, the lowest first; at most `most` of them.
[[nodiscard]] std::vector<Minimum> minima(const Pair<Quad>& pair, Question question, const Directions& found,
                                          std::size_t most);

}  // namespace second_opinion
