#include "solver/pose_impl.hpp"
#include "solver/reference/real.hpp"

namespace plumb {

PLUMB_INSTANTIATE_POSE(Real50)
PLUMB_INSTANTIATE_POSE(Real100)

}  // namespace plumb
