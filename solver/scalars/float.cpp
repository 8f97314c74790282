#include "solver/least_squares_impl.hpp"
#include "solver/method/instantiate.hpp"

namespace plumb {

PLUMB_INSTANTIATE_LEAST_SQUARES(float)
PLUMB_INSTANTIATE_METHODS(float)

}  // namespace plumb
