#include "reports/stability/stochastic_methods.hpp"

#include "solver/least_squares_impl.hpp"
#include "solver/method/instantiate.hpp"
#include "solver/pose_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_POSE(Stochastic)
PLUMB_INSTANTIATE_LEAST_SQUARES(Stochastic)
PLUMB_INSTANTIATE_METHODS(Stochastic)

}  // namespace plumb
