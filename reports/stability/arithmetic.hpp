// The arithmetics that a method is solved in: scalars, rounding modes, stochastic rounding, other compilers and options.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/solvers/solver.hpp"
#include "solver/contact.hpp"
#include "solver/reference/real.hpp"

namespace plumb::reports {

struct Arithmetic {
  std::string name;
  double epsilon;
  std::uint64_t samples;  ///< more than one where the rounding is random
  /// Whether `auto` may lose an answer in it, though never give a wrong one: float has no huge or tiny lengths, and in 50 digits the
  /// search runs out of evaluations on flats and ties that it settles in double.
  bool may_lose;
  /// nullopt where it has no such method.
  std::function<std::optional<Contact<Real50>>(std::string_view method, const Pair&, std::uint64_t sample)> solve;
};

/// In the order of the tables. `samples`: of stochastic rounding.
[[nodiscard]] std::vector<Arithmetic> arithmetics(std::uint64_t samples);

/// The same arithmetic, which answers for foreign solvers as well, by their names: theirs is not ours to choose. A pair that one does
/// not claim is not asked, and no answer is a lost one.
[[nodiscard]] Arithmetic with_foreign(Arithmetic arithmetic, std::vector<Solver> foreign);

}  // namespace plumb::reports
