// One case of the study: the certificate held against everything that was found without it.
#pragma once

#include <string>
#include <vector>

#include "corpus/case/case.hpp"
#include "solver/reference/reference.hpp"

namespace plumb::reports {

/// Which start led the six point equations to the certified common normal.
enum class Comparison {
  by_method,     ///< the answers of plumb's methods in double
  by_disturbed,  ///< the certified points, disturbed
  elsewhere,     ///< only common normals above the certified bounds were found
  unsolved       ///< the six equations have no solution in 50 digits from any start
};

struct Compared {
  std::string name;  ///< family, seed and index, or the generator's in the place of the family
  int group = 0;     ///< index into groups()
  bool global = false, unique_or_tied = false, verdict = false;
  std::string reason;                           ///< why not all of the three
  double gap = 0;                               ///< of the bounds, relative to the size
  double normal_radius = 0, points_radius = 0;  ///< rad; relative to the size
  Comparison comparison = Comparison::unsolved;
  std::string stall;    ///< why the six equations were not solved
  double residual = 0;  ///< theirs
  std::vector<std::string> contradictions;
};

/// Cases by their exponents, for a proof costs what the sharpest of them asks for.
[[nodiscard]] const std::vector<std::string>& groups();

/// Certifies the case, finds its common normal again in 50 digits without the reference, and compares.
[[nodiscard]] Compared compare(const Case& c, Effort effort);

}  // namespace plumb::reports
