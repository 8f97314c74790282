// The pairs that plumb-bench times: fixed sets of overlapping pairs as DEM codes meet them, drawn from the families.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/case/case.hpp"

namespace plumb::reports {

/// Pairs with exponents of 2 or more, the greatest of the four in (above, upto], and an overlap ratio of 1e-3..5e-2: deep enough for
/// EPA's tolerance, shallow enough for a contact. Drawn from a family, in the order of its index, or by the set's own function.
struct PairSet {
  std::string_view name, of, family;
  double above, upto;
  bool takes_all = false;  ///< every pair of the family instead: any exponents, overlapping or apart
  Case (*draw)(std::uint64_t seed, std::uint64_t index) = nullptr;  ///< instead of the family
};
[[nodiscard]] std::span<const PairSet> pair_sets();

/// The same, and the whole family `hard`.
[[nodiscard]] std::span<const PairSet> sets_with_hard();

/// Those of the names, all of them where there is none; throws InputFailure for an unknown one.
[[nodiscard]] std::vector<PairSet> find_sets(std::span<const PairSet> sets, const std::vector<std::string>& names);

/// The first `count` pairs of a set under a seed; fewer after Ctrl-C.
[[nodiscard]] std::vector<Case> draw(const PairSet& set, std::size_t count, std::uint64_t seed);

/// A pair moved as between two steps of a simulation: body 2 turned by 1e-3 rad about a random axis and shifted by 1e-3 of the
/// larger body's size in a random direction. Same seed and index, same move.
[[nodiscard]] Pair moved(const Pair& pair, std::uint64_t seed, std::uint64_t index);

/// A pair at each of 60 steps of a slow motion and where it began: at each step body 2 turns by `step` (rad) about a random axis and
/// slides by `step` of the larger body's size across the line of centres, in a random direction.
[[nodiscard]] std::vector<Pair> motion(const Pair& pair, double step, std::uint64_t seed, std::uint64_t index);

}  // namespace plumb::reports
