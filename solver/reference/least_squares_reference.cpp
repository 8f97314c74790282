#include "solver/least_squares_impl.hpp"
#include "solver/reference/real.hpp"

namespace plumb {

PLUMB_INSTANTIATE_LEAST_SQUARES(long double)
PLUMB_INSTANTIATE_LEAST_SQUARES(Real50)
PLUMB_INSTANTIATE_NULL_SPACES(double)
PLUMB_INSTANTIATE_NULL_SPACES(long double)
PLUMB_INSTANTIATE_NULL_SPACES(Real50)

}  // namespace plumb
