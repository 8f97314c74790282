#include "reports/precision_methods_table.hpp"
#include "solver/method/automatic.hpp"

namespace plumb::reports {
namespace {

template <class S>
SolveFunction<S> find(std::string_view method) {
  return method == "auto" ? automatic<S> : find_published<S>(method);
}

}  // namespace

template <>
SolveFunction<float> find_iteration<float>(std::string_view method) {
  return find<float>(method);
}

template <>
SolveFunction<double> find_iteration<double>(std::string_view method) {
  return find<double>(method);
}

template <>
SolveFunction<long double> find_iteration<long double>(std::string_view method) {
  return find<long double>(method);
}

}  // namespace plumb::reports
