// What the one part of a batch that is compiled for each instruction set gets and gives back.
#pragma once

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

[[nodiscard]] Unsettled solve_chunk_baseline(const Chunk& chunk);
[[nodiscard]] Unsettled solve_chunk_avx2(const Chunk& chunk);
[[nodiscard]] Unsettled solve_chunk_avx512(const Chunk& chunk);

}  // namespace plumb
