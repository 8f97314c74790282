#include "solver/method/minimum_distance.hpp"

#include "solver/method/minimum_distance_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_MINIMUM_DISTANCE(float)
PLUMB_INSTANTIATE_MINIMUM_DISTANCE(double)
PLUMB_INSTANTIATE_MINIMUM_DISTANCE(long double)

}  // namespace plumb
