// A library of its own: in one compilation with what calls the other scalars it would instantiate those anew, at -O2.
#include "reports/precision_methods_table.hpp"
#include "solver/method/automatic_impl.hpp"
#include "solver/method/common_normal_impl.hpp"
#include "solver/method/first_touch_impl.hpp"
#include "solver/method/geometric_potential_impl.hpp"
#include "solver/method/minimum_distance_impl.hpp"
#include "solver/method/twin.hpp"

namespace plumb {

PLUMB_INSTANTIATE_COMMON_NORMAL(Real50)
PLUMB_INSTANTIATE_GEOMETRIC_POTENTIAL(Real50)
PLUMB_INSTANTIATE_MINIMUM_DISTANCE(Real50)
PLUMB_INSTANTIATE_FIRST_TOUCH(Real50)
template Contact<Real50> automatic_in_callers_mode<Real50>(const Pair&, const Want&, const Contact<Real50>*);

namespace reports {

template <>
SolveFunction<Real50> find_iteration<Real50>(std::string_view method) {
  return find_in_table<Real50>(method);
}

}  // namespace reports
}  // namespace plumb
