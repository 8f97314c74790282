// A library of its own: in one compilation with what calls the other scalars it would instantiate those anew, at -O2.
#include "reports/precision_methods_table.hpp"
#include "solver/method/common_normal_impl.hpp"
#include "solver/method/geometric_potential_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_COMMON_NORMAL(Real50)
PLUMB_INSTANTIATE_GEOMETRIC_POTENTIAL(Real50)

namespace reports {

template <>
SolveFunction<Real50> find_iteration<Real50>(std::string_view method) {
  return find_published<Real50>(method);
}

}  // namespace reports
}  // namespace plumb
