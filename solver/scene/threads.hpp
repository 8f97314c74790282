// Loops whose turns are independent of each other, over a scene's threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace plumb::scene {

/// Of [0, count), each of `size` but the last.
[[nodiscard]] inline std::size_t parts_of(std::size_t count, std::size_t size) {
  return (count + size - 1) / size;
}

/// Whether threads share them.
[[nodiscard]] inline bool are_shared(std::size_t count, std::size_t size, int threads) {
  return threads > 1 && parts_of(count, size) > 1;
}

/// work(part, first, end) for the parts [first, end) of [0, count), each of `size` but the last, in any order. A single one is the calling
/// thread's: waking others would take longer than they spare.
template <class Work>
void for_each_part(std::size_t count, std::size_t size, int threads, const Work& work) {
  const auto parts = static_cast<std::int64_t>(parts_of(count, size));
  const auto run = [&](std::int64_t k) {
    const std::size_t part = static_cast<std::size_t>(k), first = part * size;
    work(part, first, std::min(first + size, count));
  };
  // Not by a clause: a loop that could be shared takes longer, also for one thread.
  if (!are_shared(count, size, threads)) {
    for (std::int64_t k = 0; k < parts; ++k) run(k);
    return;
  }
#pragma omp parallel for num_threads(threads) schedule(dynamic)
  for (std::int64_t k = 0; k < parts; ++k) run(k);
}

}  // namespace plumb::scene
