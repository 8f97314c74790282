#include "solver/least_squares_impl.hpp"
#include "solver/method/instantiate.hpp"

namespace plumb {

PLUMB_INSTANTIATE_LEAST_SQUARES(long double)
PLUMB_INSTANTIATE_METHODS(long double)

}  // namespace plumb
