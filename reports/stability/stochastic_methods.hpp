// The methods in stochastic rounding; what comes out is the seed's (seed_rounding).
#pragma once

#include "reports/precision/precision_methods.hpp"
#include "reports/stability/stochastic.hpp"

namespace plumb::reports {

template <>
inline constexpr std::string_view name_of_scalar<Stochastic> = "stochastic";

}  // namespace plumb::reports
