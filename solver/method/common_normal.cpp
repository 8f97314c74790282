#include "solver/method/common_normal.hpp"

#include "solver/method/common_normal_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_COMMON_NORMAL(float)
PLUMB_INSTANTIATE_COMMON_NORMAL(double)
PLUMB_INSTANTIATE_COMMON_NORMAL(long double)

}  // namespace plumb
