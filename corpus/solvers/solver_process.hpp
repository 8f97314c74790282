// One process with a foreign solver in it, or beside it, seen from plumb: plumb-solver-host, plumb-command-host.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

#include "corpus/solvers/host/child.hpp"
#include "corpus/solvers/solver.hpp"
#include "corpus/solvers/solver_wire.hpp"

namespace plumb {

/// Where a foreign solver comes from.
struct SolverSource {
  std::string text;                     ///< the path of a library, or a command as it was given
  std::vector<std::string> words = {};  ///< of the command; none: it is a library
  [[nodiscard]] bool is_command() const { return !words.empty(); }
};

/// How long plumb waits for a message: seconds of processor time, and seconds in which the process uses none.
struct SolverPatience {
  double processor, asleep;
};

class SolverProcess {
 public:
  /// Starts it and hears what the solver says of itself; throws InputFailure, which names the source, where that fails.
  SolverProcess(SolverSource source, const SolverLimits& limits);
  /// Kills it: it keeps nothing that anybody would miss.
  ~SolverProcess();
  SolverProcess(const SolverProcess&) = delete;
  SolverProcess& operator=(const SolverProcess&) = delete;

  /// What it said of itself.
  [[nodiscard]] const wire::Hello& hello() const { return hello_; }

  /// Throws NoAnswer; nothing more can be asked of this process then.
  [[nodiscard]] wire::Reply ask(wire::Request request);

 private:
  struct NotStarted {};
  SolverProcess(NotStarted, SolverSource source, const SolverLimits& limits)
      : source_(std::move(source)), limits_(limits) {}
  void start();
  void greet();
  template <class Message>
  [[nodiscard]] Message receive();
  /// Until there is something to receive, if only the end. Throws NoAnswer.
  void wait_for_message(const SolverPatience& limits);
  void require_memory(std::uint64_t bytes) const;
  [[noreturn]] void throw_death();
  [[nodiscard]] std::string said();
  [[nodiscard]] std::string with_last_words(const std::string& what);

  SolverSource source_;
  SolverLimits limits_;
  wire::Hello hello_;
  std::uint64_t asked_ = 0;
  pid_t child_ = -1;
  Descriptor ended_;     ///< readable once the process has ended
  Descriptor socket_;    ///< requests and replies
  Descriptor lifeline_;  ///< the process ends when this is closed
  Descriptor output_;    ///< what the solver prints
};

}  // namespace plumb
