#include "solver/method/published/minimum_distance.hpp"

#include "solver/method/published/minimum_distance_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_MINIMUM_DISTANCE(double)

}  // namespace plumb
