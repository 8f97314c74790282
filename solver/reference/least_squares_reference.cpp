#include "solver/least_squares_impl.hpp"
#include "solver/reference/real.hpp"

namespace plumb {

PLUMB_INSTANTIATE_LEAST_SQUARES(Real50)

}  // namespace plumb
