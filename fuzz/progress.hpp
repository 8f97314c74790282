// How far a long run is: a bar on a terminal, a plain line every ten seconds anywhere else. On stderr.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace plumb {

class Progress {
 public:
  Progress(std::string what, std::uint64_t total);
  /// Called as often as wanted; prints when it is time.
  void show(std::uint64_t done);
  /// The last line, which stays on the screen.
  void finish(std::uint64_t done);
  [[nodiscard]] double seconds() const;

 private:
  [[nodiscard]] std::string line(std::uint64_t done) const;
  void print(std::uint64_t done);

  using Clock = std::chrono::steady_clock;
  std::string what_;
  std::uint64_t total_;
  bool terminal_;
  Clock::time_point start_, printed_;
};

/// 1234567 -> "1 234 567".
[[nodiscard]] std::string grouped(std::uint64_t n);

}  // namespace plumb
