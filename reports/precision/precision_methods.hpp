// The methods in every scalar, without the door of methods.hpp: for 50 digits, which the library that others link does not
// have, and for the last iterate of a solve that did not converge, which the door keeps back.
#pragma once

#include <string_view>

#include "solver/method/methods.hpp"
#include "solver/reference/real.hpp"

namespace plumb::reports {

template <class S>
inline constexpr std::string_view name_of_scalar = {};
template <>
inline constexpr std::string_view name_of_scalar<float> = "float";
template <>
inline constexpr std::string_view name_of_scalar<double> = "double";
template <>
inline constexpr std::string_view name_of_scalar<long double> = "long double";
template <>
inline constexpr std::string_view name_of_scalar<Real50> = "50 digits";

/// Takes legal pairs only; the fields are the last iterate's, whatever the status. nullptr where there is none: peers.
template <class S>
[[nodiscard]] SolveFunction<S> find_iteration(std::string_view method) {
  const MethodIn<S>* found = find_method_in<S>(method);
  return found == nullptr ? nullptr : found->iterate;
}

}  // namespace plumb::reports
