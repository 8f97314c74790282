#include "solver/pose.hpp"

#include "solver/pose_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_POSE(float)
PLUMB_INSTANTIATE_POSE(double)
PLUMB_INSTANTIATE_POSE(long double)

}  // namespace plumb
