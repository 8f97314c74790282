#include "solver/method/first_touch.hpp"

#include "solver/method/first_touch_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_FIRST_TOUCH(double)

}  // namespace plumb
