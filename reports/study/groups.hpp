// The source's four groups G1..G4, and four of superquadrics: one geometry each at several overlap ratios, with phi_L = phi = 0.
//
// The source's own numbers are not available: these are found by a search, one for each way in which the original equations' answer
// fails at every ratio (solver/diagnosis.hpp).
#pragma once

#include <string>

#include "reports/study/bed.hpp"

namespace plumb::reports {

inline constexpr std::array ratios{1e-3, 5e-3, 1e-2, 2e-2, 5e-2};

struct GroupAnswer {
  double ratio;
  std::string_view method;
  bool certified;  ///< the common normal that it is held against
  Studied studied;
};

struct Group {
  std::string name;  ///< G1..G4, S1..S4
  Fails fails;
  Bed bed;
  int drawn = 0;  ///< how many geometries were tried until this one was found; 0: none was
  std::vector<GroupAnswer> answers;
};

enum class BedShape { spheroid, superquadric };

/// In the order of Fails.
[[nodiscard]] std::vector<Group> find_groups(BedShape shape, std::uint64_t seed);

}  // namespace plumb::reports
