// The list of methods: name -> function, and what else is known of each.
//
// Adding one: published/NAME_impl.hpp and .cpp, and a row in method_rows.inc. The laws, the corpus, the fuzzers, the campaign and the
// reports read the row.
#pragma once

#include <span>
#include <string_view>

#include "solver/contact.hpp"

namespace plumb {

/// Solves a pair. `last`, when given, is an earlier answer for a pair nearby: its points replace the documented start.
/// Never throws, never allocates; an illegal pair gives Status::invalid_input.
template <class S>
using SolveFunction = Contact<S> (*)(const Pair& pair, const Want& want, const Contact<S>* last);

/// How a method is drawn, the same in every plot: "#rrggbb" on a light page and on a dark one, and a symbol's name of Plotly's.
struct MethodLook {
  std::string_view light, dark, symbol;
};

/// A row of the list: a name of `plumb methods`, what it runs in a scalar, and what a report says of it.
template <class S>
struct MethodIn {
  std::string_view name;
  Problem problem;
  std::string_view summary;
  SolveFunction<S> solve;
  SolveFunction<S>
      iterate;  ///< legal pairs only, in the caller's rounding; its fields are the last iterate's, whatever the status
  std::string_view published_by;  ///< authors and year; empty: plumb's own, and a finding of it is a failure of plumb
  MethodLook look;

  /// Whether it is a baseline: its findings are its result.
  [[nodiscard]] constexpr bool is_published() const { return !published_by.empty(); }
};
/// In double, the scalar of most.
using Method = MethodIn<double>;

/// All of them, `auto` among them.
[[nodiscard]] std::span<const Method> methods();

/// nullptr when there is no such method.
[[nodiscard]] const Method* find_method(std::string_view name);

/// The same in another scalar; float and long double are in the library plumb::scalars.
template <class S>
[[nodiscard]] const MethodIn<S>* find_method_in(std::string_view name);

}  // namespace plumb
