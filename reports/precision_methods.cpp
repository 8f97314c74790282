#include "reports/precision_methods_table.hpp"

namespace plumb::reports {

template <>
SolveFunction<float> find_iteration<float>(std::string_view method) {
  return find_in_table<float>(method);
}

template <>
SolveFunction<double> find_iteration<double>(std::string_view method) {
  return find_in_table<double>(method);
}

template <>
SolveFunction<long double> find_iteration<long double>(std::string_view method) {
  return find_in_table<long double>(method);
}

}  // namespace plumb::reports
