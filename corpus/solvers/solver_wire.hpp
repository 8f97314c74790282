// What plumb and the program that answers for a foreign solver (solver_host.cpp) say to each other: one message each way a
// call, over a socket that keeps messages whole. Both are of one build, so that a struct's bytes are the format.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "solver/plumb_solver.h"

namespace plumb::wire {

template <std::size_t N>
struct Text {
  std::array<char, N> bytes{};

  /// As much of it as there is room for.
  void set(std::string_view text) {
    bytes.fill(0);
    std::copy_n(text.begin(), std::min(text.size(), N - 1), bytes.begin());
  }
  [[nodiscard]] std::string text() const { return {bytes.data(), strnlen(bytes.data(), N)}; }
};

/// The first message, from the host: whether the library could be loaded.
struct Hello {
  bool loaded = false;
  std::uint64_t peak_bytes = 0;  ///< before the library was loaded: what exec handed on of plumb's own is among it
  Text<64> field;
  Text<1024> reason;
  plumb_abilities abilities{};  ///< without its strings, which are of the host's memory
  Text<128> name, version, licence;
  bool warm = false;
};

struct Request {
  enum class Kind : std::uint8_t { solve, solve_warm, measure_memory };
  Kind kind = Kind::solve;
  std::uint64_t number = 0;  ///< from 1
  int processor = 0;         ///< where plumb waits for the reply (one_processor.hpp)
  plumb_pair pair{};
  plumb_contact last{};
};

struct Reply {
  enum class Kind : std::uint8_t { answered, refused, threw, measured, broken };
  Kind kind = Kind::answered;
  std::uint64_t number = 0;  ///< of the request that it answers
  plumb_contact contact{};
  double nanoseconds = 0;        ///< of the call alone
  std::uint64_t heap_bytes = 0;  ///< in use, by glibc's allocator
  std::uint64_t resident_bytes = 0;
  std::uint64_t peak_bytes = 0;  ///< resident at most, so far
  Text<256> what;  ///< of what it threw, or what a program did in place of an answer, and can do no more (broken)
};

}  // namespace plumb::wire
