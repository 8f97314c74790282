// Why the original fails, by its own numbers: all solutions that the six equations have for a pair, and which of them a Newton
// start finds.
#pragma once

#include "reports/study/groups.hpp"
#include "reports/study/six_roots.hpp"

namespace plumb::reports {

struct RootStarts {
  SixRoot root;
  double off;      ///< degrees between its normal and the certified common normal; NaN where that is not proved
  int starts = 0;  ///< random starts of original_cn that end there
  bool documented = false;  ///< and its own start does
};

struct PairRoots {
  std::string pair;  ///< "G1, overlap ratio 0.01"
  SixRoots set;      ///< whose roots are `roots`'
  std::vector<RootStarts> roots;
  int starts = 0, not_converged = 0;
  int elsewhere = 0;  ///< converged to none of the roots
};

/// `starts`: a point on each body, both random.
[[nodiscard]] PairRoots find_roots(const std::string& name, const Pair& pair, int starts, std::uint64_t seed);

}  // namespace plumb::reports
