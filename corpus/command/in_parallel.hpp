// One piece of work for each number, on several threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

#include "corpus/command/interrupt.hpp"

namespace plumb {

/// work(0) .. work(count - 1), begun in this order, until Ctrl-C or until work throws: the first exception is thrown on when all
/// that was begun has ended.
template <class Work>
void in_parallel(std::size_t count, unsigned threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> has_thrown{false};
  std::exception_ptr thrown;
  const auto work_on = [&] {
    try {
      for (std::size_t i = next++; i < count && !interrupted() && !has_thrown; i = next++) work(i);
    } catch (...) {
      if (!has_thrown.exchange(true)) thrown = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> workers;
    for (unsigned thread = 0; thread < threads; ++thread) workers.emplace_back(work_on);
  }
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace plumb
