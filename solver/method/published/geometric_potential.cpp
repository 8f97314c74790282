#include "solver/method/published/geometric_potential.hpp"

#include "solver/method/published/geometric_potential_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_GEOMETRIC_POTENTIAL(double)

}  // namespace plumb
