// Every method in one scalar: what the sources that instantiate them for one other than double hold.
#pragma once

#include "solver/method/auto/automatic_impl.hpp"
#include "solver/method/method_table.hpp"
#include "solver/method/published/common_normal_impl.hpp"
#include "solver/method/published/first_touch_impl.hpp"
#include "solver/method/published/geometric_potential_impl.hpp"
#include "solver/method/published/minimum_distance_impl.hpp"

#define PLUMB_INSTANTIATE_METHODS(S)       \
  PLUMB_INSTANTIATE_AUTOMATIC(S)           \
  PLUMB_INSTANTIATE_COMMON_NORMAL(S)       \
  PLUMB_INSTANTIATE_FIRST_TOUCH(S)         \
  PLUMB_INSTANTIATE_GEOMETRIC_POTENTIAL(S) \
  PLUMB_INSTANTIATE_MINIMUM_DISTANCE(S)    \
  template const MethodIn<S>* find_method_in<S>(std::string_view name);
