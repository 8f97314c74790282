// Two threads that wait for each other in turn wake each other in 3 us on one processor, and in 20 us across two: so long
// takes the other one to come out of its idleness, above all in a virtual machine.
#pragma once

#include <sched.h>

namespace plumb {

/// Keeps this thread, but none that it starts elsewhere, on one processor until its end; does nothing where that is refused.
class OneProcessor {
 public:
  explicit OneProcessor(int processor) {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(static_cast<std::size_t>(processor), &one);
    is_set_ = sched_getaffinity(0, sizeof before_, &before_) == 0 && sched_setaffinity(0, sizeof one, &one) == 0;
  }
  ~OneProcessor() {
    if (is_set_) (void)sched_setaffinity(0, sizeof before_, &before_);
  }
  OneProcessor(const OneProcessor&) = delete;
  OneProcessor& operator=(const OneProcessor&) = delete;

 private:
  cpu_set_t before_{};
  bool is_set_ = false;
};

}  // namespace plumb
