#include "solver/method/published/first_touch.hpp"

#include "solver/method/published/first_touch_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_FIRST_TOUCH(double)

}  // namespace plumb
