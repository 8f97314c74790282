// The methods in stochastic rounding.
#pragma once

#include "reports/precision_methods.hpp"
#include "reports/stability/stochastic.hpp"

namespace plumb::reports {

template <>
inline constexpr std::string_view name_of_scalar<Stochastic> = "stochastic";

/// As the others; what comes out is the seed's (seed_rounding).
template <>
[[nodiscard]] SolveFunction<Stochastic> find_iteration<Stochastic>(std::string_view method);

}  // namespace plumb::reports
