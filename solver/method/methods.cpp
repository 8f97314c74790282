#include "solver/method/methods.hpp"

#include "solver/method/method_table.hpp"

namespace plumb {

std::span<const Method> methods() {
  return method_table<double>;
}

const Method* find_method(std::string_view name) {
  return find_method_in<double>(name);
}

template const MethodIn<double>* find_method_in<double>(std::string_view name);

}  // namespace plumb
