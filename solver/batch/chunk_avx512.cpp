// Built with -mavx512f and its kin; run only where the machine has them.
#include "solver/batch/chunk_impl.hpp"

namespace plumb {

Unsettled solve_chunk_avx512(const Chunk& chunk) {
  return detail::ChunkSolver<8>(chunk).solve();
}

}  // namespace plumb
