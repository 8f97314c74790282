// With the instructions that every machine of this build's target has: SSE2 on x86-64.
#include "solver/batch/chunk_impl.hpp"

namespace plumb {

Unsettled solve_chunk_baseline(const Chunk& chunk) {
  return detail::ChunkSolver<2>(chunk).solve();
}

}  // namespace plumb
