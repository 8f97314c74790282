// A thread whose stack is painted beforehand, so that what was used of it can be seen afterwards.
#pragma once

#include <pthread.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>

namespace plumb {

/// Bytes of a thread's stack.
struct StackUse {
  std::size_t by_work = 0;  ///< below the call of the work
  std::size_t in_all = 0;   ///< with what the C library keeps there: thread-local variables, its own frames
};

class PaintedThread {
 public:
  /// Of that many bytes in all, a multiple of a page; below them is a page that may not be touched.
  explicit PaintedThread(std::size_t size)
      : size_(size), area_(static_cast<std::byte*>(mmap(nullptr, page + size, PROT_READ | PROT_WRITE,
                                                        MAP_PRIVATE | MAP_ANONYMOUS | MAP_STACK, -1, 0))) {
    if (area_ == MAP_FAILED || mprotect(area_, page, PROT_NONE) != 0) throw std::runtime_error("no memory for a stack");
  }
  ~PaintedThread() { munmap(area_, page + size_); }
  PaintedThread(const PaintedThread&) = delete;
  PaintedThread& operator=(const PaintedThread&) = delete;

  /// What `work` takes of it, which runs there.
  [[nodiscard]] StackUse run(std::function<void()> work) {
    std::fill(lowest(), lowest() + size_, paint);
    Task task{std::move(work), nullptr};
    pthread_attr_t attributes;
    pthread_t thread{};
    pthread_attr_init(&attributes);
    const bool runs = pthread_attr_setstack(&attributes, lowest(), size_) == 0 &&
                      pthread_create(&thread, &attributes, start, &task) == 0;
    pthread_attr_destroy(&attributes);
    if (!runs) throw std::runtime_error("no thread on a stack as small");
    pthread_join(thread, nullptr);
    const std::byte* const used = std::find_if(lowest(), lowest() + size_, [](std::byte b) { return b != paint; });
    return {static_cast<std::size_t>(task.frame - used), static_cast<std::size_t>(lowest() + size_ - used)};
  }

 private:
  static constexpr std::size_t page = 4096;
  static constexpr std::byte paint{0xA5};

  struct Task {
    std::function<void()> work;
    std::byte* frame;  ///< of the function that calls the work
  };

  [[nodiscard]] std::byte* lowest() const { return area_ + page; }

  static void* start(void* given) {
    Task& task = *static_cast<Task*>(given);
    task.frame = static_cast<std::byte*>(__builtin_frame_address(0));
    task.work();
    return nullptr;
  }

  std::size_t size_;
  std::byte* area_;
};

}  // namespace plumb
