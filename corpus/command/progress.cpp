#include "corpus/command/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace plumb {

std::string grouped(std::uint64_t n) {
  std::string text = fmt::format("{}", n);
  for (std::ptrdiff_t at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3)
    text.insert(static_cast<std::size_t>(at), 1, ' ');
  return text;
}

Progress::Progress(std::string what, std::uint64_t total, Elsewhere elsewhere)
    : what_(std::move(what)), total_(total), terminal_(isatty(STDERR_FILENO) != 0),
      silent_(!terminal_ && elsewhere == Elsewhere::nothing), start_(Clock::now()), printed_(start_) {}

double Progress::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

bool Progress::is_due() const {
  if (silent_) return false;
  const auto pause = terminal_ ? std::chrono::milliseconds(200) : std::chrono::milliseconds(10000);
  return Clock::now() - printed_ >= pause;
}

void Progress::show(std::uint64_t done, const std::string& note) {
  if (is_due()) print(done, note);
}

void Progress::finish(std::uint64_t done, const std::string& note) {
  if (silent_) return;
  print(done, note);
  if (terminal_) std::fputc('\n', stderr);
}

std::string Progress::line(std::uint64_t done, const std::string& note) const {
  const double part = total_ == 0 ? 1 : static_cast<double>(done) / static_cast<double>(total_);
  const double elapsed = seconds();
  const double rate = elapsed > 0 ? static_cast<double>(done) / elapsed : 0;
  std::string left = "-";
  if (rate > 0) {
    const auto rest = static_cast<std::uint64_t>(static_cast<double>(total_ - std::min(done, total_)) / rate);
    left = fmt::format("{}:{:02}", rest / 60, rest % 60);
  }
  return fmt::format("{} {:3.0f} %  {} of {}  {:.0f}/s  {} left{}", what_, 100 * part, grouped(done), grouped(total_),
                     rate, left, note);
}

void Progress::print(std::uint64_t done, const std::string& note) {
  printed_ = Clock::now();
  if (!terminal_) {
    fmt::print(stderr, "{}\n", line(done, note));
    return;
  }
  constexpr std::uint64_t width = 24;
  const std::uint64_t full = total_ == 0 ? width : std::min(width, width * done / total_);
  fmt::print(stderr, "\r[{:#>{}}{:.>{}}] {}\x1b[K", "", full, "", width - full, line(done, note));
  std::fflush(stderr);
}

}  // namespace plumb
