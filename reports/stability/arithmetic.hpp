// The arithmetics that a method is solved in: scalars, rounding modes, stochastic rounding, other compilers and options.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

}  // namespace plumb::reports
