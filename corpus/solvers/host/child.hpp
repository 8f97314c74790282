// A process that this one started: its descriptors, its end, and what it uses together with all that it started.
#pragma once

#include <sys/types.h>
#include <unistd.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace plumb {

/// Closed at its end, and by an exec.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

/// Readable once the child has ended.
[[nodiscard]] Descriptor end_of(pid_t child);

/// Whether it ends within the time that an ending process takes.
[[nodiscard]] bool ends_soon(const Descriptor& end);

/// Waits for its end and takes its status, so that nothing is left of it.
int reap(pid_t child);

/// A status in words: "ended by signal 11 (Segmentation fault)".
[[nodiscard]] std::string ending(int status);

/// What it started, what those started, and so on; none of them twice.
[[nodiscard]] std::vector<pid_t> descendants_of(pid_t process);

/// Of a process and its descendants.
struct Usage {
  double processor_seconds = 0;      ///< those of children that ended and were waited for among them
  bool is_ready = false;             ///< whether one of them runs, or would if it had a processor
  std::uint64_t resident_bytes = 0;  ///< as the kernel counts each: what several share counts for each
};
[[nodiscard]] Usage usage_of(pid_t process);

}  // namespace plumb
