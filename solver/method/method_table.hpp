// The rows of method_rows.inc in any scalar; included where a scalar's functions are instantiated.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <tuple>

#include "solver/method/methods.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb {

#define PLUMB_METHOD(function, ...) \
  template <class S>                \
  [[nodiscard]] Contact<S> function(const Pair& pair, const Want& want, const Contact<S>* last);
#include "solver/method/method_rows.inc"
#undef PLUMB_METHOD

namespace detail {

/// Takes away what the method found: where it did not converge, that is no answer.
template <class S>
void withhold(Contact<S>& answer) {
  const auto kept = std::tuple(answer.method, answer.status, answer.iterations, answer.evaluations);
  std::construct_at(&answer);  // assigned, g++ 12 takes its empty optionals for read
  std::tie(answer.method, answer.status, answer.iterations, answer.evaluations) = kept;
}

template <class S>
Contact<S> refusal() {
  Contact<S> out;
  out.status = Status::invalid_input;
  return out;
}

/// What every method does alike: refuse illegal input, and hand out nothing that its status does not vouch for.
template <class S, SolveFunction<S> method>
Contact<S> guarded(const Pair& pair, const Want& want, const Contact<S>* last) {
  const StandardArithmetic mode;
  Contact<S> out = is_valid_in_callers_mode(pair) ? method(pair, want, last)
                                                  : refusal<S>();  // in place: a contact is no small thing
  if (out.status != Status::converged) withhold<S>(out);
  return out;
}

}  // namespace detail

template <class S>
[[nodiscard]] constexpr auto method_rows() {
// NOLINTBEGIN(bugprone-macro-parentheses): the name of a template takes none
#define PLUMB_METHOD(function, name, problem, published_by, light, dark, symbol, summary)                \
  MethodIn<S>{name,         Problem::problem,     summary, detail::guarded<S, function<S>>, function<S>, \
              published_by, {light, dark, symbol}},
  // NOLINTEND(bugprone-macro-parentheses)
  return std::to_array({
#include "solver/method/method_rows.inc"
  });
#undef PLUMB_METHOD
}
template <class S>
inline constexpr auto method_table = method_rows<S>();

template <class S>
const MethodIn<S>* find_method_in(std::string_view name) {
  const auto has_name = [&](const MethodIn<S>& row) { return row.name == name; };
  const auto found = std::find_if(method_table<S>.begin(), method_table<S>.end(), has_name);
  return found == method_table<S>.end() ? nullptr : &*found;
}

}  // namespace plumb
