#include "reports/stability/stochastic_methods.hpp"

#include "reports/precision_methods_table.hpp"
#include "solver/least_squares_impl.hpp"
#include "solver/method/automatic_impl.hpp"
#include "solver/method/common_normal_impl.hpp"
#include "solver/method/first_touch_impl.hpp"
#include "solver/method/geometric_potential_impl.hpp"
#include "solver/method/minimum_distance_impl.hpp"
#include "solver/method/twin.hpp"
#include "solver/pose_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_POSE(Stochastic)
PLUMB_INSTANTIATE_LEAST_SQUARES(Stochastic)
PLUMB_INSTANTIATE_COMMON_NORMAL(Stochastic)
PLUMB_INSTANTIATE_GEOMETRIC_POTENTIAL(Stochastic)
PLUMB_INSTANTIATE_MINIMUM_DISTANCE(Stochastic)
PLUMB_INSTANTIATE_FIRST_TOUCH(Stochastic)
template Contact<Stochastic> automatic_in_callers_mode<Stochastic>(const Pair&, const Want&,
                                                                   const Contact<Stochastic>*);

namespace reports {

template <>
SolveFunction<Stochastic> find_iteration<Stochastic>(std::string_view method) {
  return find_in_table<Stochastic>(method);
}

}  // namespace reports
}  // namespace plumb
