// Bounds of a pair's lowest overlap in intervals of doubles alone, for where there is no MPFR: WebAssembly. They hold as those of
// find_reference do; where a normal is not to be had to many digits they are further apart, for no minimum is proved.
#pragma once

#include "solver/contact.hpp"

namespace plumb::reference {

/// In the case's unit; of either sign.
struct OverlapBounds {
  double lower, upper;
};

/// Of the lowest overlap of all directions. The upper bound is the overlap along the contact's normal, whatever it is worth; its points
/// sharpen the lower. `cells`: how many the search may look at. Deterministic; takes any legal pair and a finite contact.
[[nodiscard]] OverlapBounds bound_overlap(const Pair& pair, const Contact<double>& contact, int cells);

}  // namespace plumb::reference
