// One process of plumb-solver-host with a foreign solver in it, seen from plumb.
#pragma once

#include <sys/types.h>
#include <unistd.h>

#include <cstdint>
#include <string>
#include <utility>

#include "corpus/solver.hpp"
#include "corpus/solver_wire.hpp"

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

class SolverProcess {
 public:
  /// Starts it and loads the library; throws InputFailure, which names the library, where that fails.
  SolverProcess(const std::string& library, const SolverLimits& limits);
  /// Kills it: it keeps nothing that anybody would miss.
  ~SolverProcess();
  SolverProcess(const SolverProcess&) = delete;
  SolverProcess& operator=(const SolverProcess&) = delete;

  /// What it said of itself.
  [[nodiscard]] const wire::Hello& hello() const { return hello_; }

  /// Throws NoAnswer; nothing more can be asked of this process then.
  [[nodiscard]] wire::Reply ask(wire::Request request);

 private:
  explicit SolverProcess(const SolverLimits& limits) : limits_(limits) {}
  void start(const std::string& library);
  template <class Message>
  [[nodiscard]] Message receive();
  void wait_for_message();
  void require_memory(std::uint64_t bytes) const;
  [[nodiscard]] double processor_seconds() const;
  [[noreturn]] void throw_death();
  [[nodiscard]] std::string said();

  SolverLimits limits_;
  wire::Hello hello_;
  std::uint64_t asked_ = 0;
  pid_t child_ = -1;
  Descriptor ended_;     ///< readable once the process has ended
  Descriptor socket_;    ///< requests and replies
  Descriptor lifeline_;  ///< the process ends when this is closed
  Descriptor output_;    ///< what the library prints
};

}  // namespace plumb
