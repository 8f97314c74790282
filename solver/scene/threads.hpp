// Loops whose turns are independent of each other, over a scene's threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace plumb::scene {

/// work(part, first, end) for the parts [first, end) of [0, count), each of `size` but the last, in any order. A single one is the calling
/// thread's: waking others would take longer than they spare.
template <class Work>
void for_each_part(std::size_t count, std::size_t size, int threads, const Work& work) {
  const auto parts = static_cast<std::int64_t>((count + size - 1) / size);
  const auto run = [&](std::int64_t k) {
    const std::size_t part = static_cast<std::size_t>(k), first = part * size;
    work(part, first, std::min(first + size, count));
  };
  if (threads <= 1 || parts <= 1) {  // not by a clause: a loop that could be shared takes longer, also for one thread
    for (std::int64_t k = 0; k < parts; ++k) run(k);
    return;
  }
#pragma omp parallel for num_threads(threads) schedule(dynamic)
  for (std::int64_t k = 0; k < parts; ++k) run(k);
}

}  // namespace plumb::scene
