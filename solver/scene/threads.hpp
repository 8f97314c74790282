// Loops whose turns are independent of each other, over a scene's threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace plumb::scene {

/// work(part, first, end) for the parts [first, end) of [0, count), each of `size` but the last, in any order. A single one is the calling
/// thread's: waking others would take longer than they spare.
template <class Work>
void for_each_part(std::size_t count, std::size_t size, [[maybe_unused]] int threads, const Work& work) {
  const std::size_t parts = (count + size - 1) / size;
#pragma omp parallel for num_threads(threads) schedule(dynamic) if (threads > 1 && parts > 1)
  for (std::int64_t k = 0; k < static_cast<std::int64_t>(parts); ++k) {
    const std::size_t part = static_cast<std::size_t>(k), first = part * size;
    work(part, first, std::min(first + size, count));
  }
}

}  // namespace plumb::scene
