// The memory that a process holds, as the kernel counts it.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <fstream>
#include <string>

namespace plumb {

/// `process`: its number, or "self"; 0 where there is none.
[[nodiscard]] inline std::uint64_t resident_bytes_of(const std::string& process) {
  std::uint64_t all = 0, resident = 0;
  std::ifstream("/proc/" + process + "/statm") >> all >> resident;
  return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace plumb
