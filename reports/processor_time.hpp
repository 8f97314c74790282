// Processor time of this process: the machine may be shared.
#pragma once

#include <time.h>

namespace plumb::reports {

/// Seconds.
[[nodiscard]] inline double processor_time() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace plumb::reports
