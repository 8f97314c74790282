#include "solver/least_squares_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_LEAST_SQUARES(double)

}  // namespace plumb
