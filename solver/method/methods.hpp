// The one list of methods: name -> function.
//
// Adding a method: one header/source pair in this folder, a row in method_table.hpp, a line in instantiate.hpp; the laws, the corpus,
// the fuzzers, the campaign and the reports pick it up from there.
#pragma once

#include <span>
#include <string_view>

#include "solver/contact.hpp"

namespace plumb {

/// Solves a pair. `last`, when given, is an earlier answer for a pair nearby: its points replace the documented start.
/// Never throws, never allocates; an illegal pair gives Status::invalid_input.
template <class S>
using SolveFunction = Contact<S> (*)(const Pair& pair, const Want& want, const Contact<S>* last);

/// A row of the list: a name of `plumb methods`, and what it runs in a scalar.
template <class S>
struct MethodIn {
  std::string_view name;
  Problem problem;
  std::string_view summary;
  SolveFunction<S> solve;
  SolveFunction<S>
      iterate;  ///< legal pairs only, in the caller's rounding; its fields are the last iterate's, whatever the status
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
