// Where on the sphere of directions a quotient of support functions can be least: spherical triangles, halved and bounded in doubles.
#pragma once

#include <vector>

#include "quotient.hpp"

namespace second_opinion {

struct Candidate {
  Vec<double> normal;
  double value;
  double radius;  ///< rad: every direction of its triangle is that near
};

struct Directions {
  std::vector<Candidate>
      low;  ///< triangles that hold a direction as low as the lowest found, within `slack`; the lowest first
  double slack = 0;
  double proven = 0;     ///< no direction is lower than this
  bool complete = true;  ///< false: given up, and `low` may lack some
};

/// `slack` relative to the size of the pair or, where it is larger, to the value.
[[nodiscard]] Directions search(const Pair<double>& pair, Question question, double slack);

}  // namespace second_opinion
