// What the one part of a batch that is compiled for each instruction set gets and gives back.
#pragma once

#include <bit>
#include <cstdint>

#include "solver/batch/batch.hpp"

namespace plumb {

/// Up to `capacity` pairs from `first` on.
struct Chunk {
  static constexpr std::size_t capacity = 64;
  const PairArrays& pairs;
  const Want& want;  ///< with what the spans of `contacts` ask for
  const ContactArrays& contacts;
  std::size_t first, count;
};

/// Bit i: pair first + i is not settled; what stands in its place in the arrays is not an answer.
using Unsettled = std::uint64_t;
using SolveChunk = Unsettled (*)(const Chunk& chunk);

/// work(k) for each.
template <class Work>
void each_unsettled(Unsettled pairs, const Work& work) {
  for (; pairs != 0; pairs &= pairs - 1) work(static_cast<std::size_t>(std::countr_zero(pairs)));
}

/// What a batch does side by side, for who has charts of a chunk at a time; `want` with what the arrays ask for. No check of lengths.
[[nodiscard]] Unsettled solve_together(const Chunk& chunk, InstructionSet set);

[[nodiscard]] Unsettled solve_chunk_baseline(const Chunk& chunk);
[[nodiscard]] Unsettled solve_chunk_avx2(const Chunk& chunk);
[[nodiscard]] Unsettled solve_chunk_avx512(const Chunk& chunk);

}  // namespace plumb
