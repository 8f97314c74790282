// The inputs from which others are made: one of each kind of pair, for each power of two of the error there.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "fuzz/hunt/guide.hpp"
#include "fuzz/hunt/inputs.hpp"

namespace plumb::hunting {

/// What solvers tell apart: the octant of the line of centres in body 1's axes, how deep, which semi-axes of a body are equal, exponents;
/// then what its answer looks like, and the power of two of its error.
using Cell = std::array<std::int16_t, 8>;

[[nodiscard]] Cell cell_of(const Pair& pair, double overlap, const Heat& heat);

class Cells {
 public:
  /// Kept where its cell is new, or its error the greatest there.
  void add(const Cell& cell, const Input& input, double error);
  [[nodiscard]] bool empty() const { return kept_.empty(); }
  [[nodiscard]] std::size_t size() const { return kept_.size(); }
  /// One of the hottest of all, or the hottest of a few.
  [[nodiscard]] const Input& pick(Stream& stream) const;
  /// Whether a suspect of that cell is to be judged: the first, the second, the fourth ..: where it is the guide that errs,
  /// proofs are not to take all the time.
  [[nodiscard]] bool is_worth_a_proof(const Cell& cell);

 private:
  void rank(std::size_t place);

  struct Kept {
    Input input;
    double error;
  };
  std::vector<Kept> kept_;
  std::vector<std::size_t> hottest_;  ///< of kept_, the hottest first
  std::map<Cell, std::size_t> places_;
  std::map<Cell, std::uint64_t> suspects_;
};

}  // namespace plumb::hunting
