// From a pair to its reference with its proof, in intervals I and with local solutions in S.
#pragma once

#include "solver/reference/reference.hpp"

namespace plumb::reference {

/// I, S: DoubleInterval, double; Interval18, long double; Interval80, Real50. `cheaper`: by fewer digits, with its cover; may be null.
template <class I, class S>
[[nodiscard]] Reference certify(const Pair& pair, const Reference* cheaper);

}  // namespace plumb::reference
