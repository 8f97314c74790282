// How far a long run is: a bar on a terminal, a plain line every ten seconds (or nothing) anywhere else. On stderr.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace plumb {

class Progress {
 public:
  enum class Elsewhere { lines, nothing };  ///< where there is no terminal
  Progress(std::string what, std::uint64_t total, Elsewhere elsewhere = Elsewhere::lines);
  /// Whether show() would print: for who has something to work out for it.
  [[nodiscard]] bool is_due() const;
  /// Called as often as wanted; prints when it is time. `note` stands at the end of the line.
  void show(std::uint64_t done, const std::string& note = "");
  /// The last line, which stays on the screen.
  void finish(std::uint64_t done, const std::string& note = "");
  [[nodiscard]] double seconds() const;

 private:
  [[nodiscard]] std::string line(std::uint64_t done, const std::string& note) const;
  void print(std::uint64_t done, const std::string& note);

  using Clock = std::chrono::steady_clock;
  std::string what_;
  std::uint64_t total_;
  bool terminal_, silent_;
  Clock::time_point start_, printed_;
};

/// 1234567 -> "1 234 567".
[[nodiscard]] std::string grouped(std::uint64_t n);

}  // namespace plumb
