#include "solver/method/auto/automatic_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_AUTOMATIC(double)

}  // namespace plumb
