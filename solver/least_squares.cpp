#include "solver/least_squares.hpp"

#include "solver/least_squares_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_LEAST_SQUARES(float)
PLUMB_INSTANTIATE_LEAST_SQUARES(double)
PLUMB_INSTANTIATE_LEAST_SQUARES(long double)

}  // namespace plumb
