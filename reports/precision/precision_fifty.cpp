// A library of its own: in one compilation with what calls the other scalars it would instantiate those anew, at -O2.
#include "reports/precision/precision_methods.hpp"
#include "solver/method/instantiate.hpp"

namespace plumb {

PLUMB_INSTANTIATE_METHODS(Real50)

}  // namespace plumb
