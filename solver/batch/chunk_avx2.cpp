// Built with -mavx2; run only where the machine has it.
#include "solver/batch/chunk_impl.hpp"

namespace plumb {

Unsettled solve_chunk_avx2(const Chunk& chunk) {
  return detail::ChunkSolver<4>(chunk).solve();
}

}  // namespace plumb
