#include "solver/method/published/common_normal.hpp"

#include "solver/method/published/common_normal_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_COMMON_NORMAL(double)

}  // namespace plumb
