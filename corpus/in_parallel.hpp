// One piece of work for each number, on several threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

#include "corpus/interrupt.hpp"

namespace plumb {

/// work(0) .. work(count - 1), begun in this order, until Ctrl-C. What work throws ends the program.
template <class Work>
void in_parallel(std::size_t count, unsigned threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::vector<std::jthread> workers;
  for (unsigned thread = 0; thread < threads; ++thread)
    workers.emplace_back([&] {
      for (std::size_t i = next++; i < count && !interrupted(); i = next++) work(i);
    });
}

}  // namespace plumb
