// A foreign program and its three pipes, seen from the process that answers for it (command_host.cpp).
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "corpus/solvers/host/child.hpp"

namespace plumb {

/// What a program did in place of the line that it was to send.
struct NoLine : std::runtime_error {
  explicit NoLine(const std::string& what, std::string said_ = "") : std::runtime_error(what), said(std::move(said_)) {}
  std::string said;  ///< by one that ended: its last words on standard error
};

class CommandProcess {
 public:
  /// Starts it; `plumb` becomes readable when plumb asks or ends. Throws NoLine where it cannot be started.
  CommandProcess(const std::vector<std::string>& words, int plumb);
  /// Ends it, and all that it started.
  ~CommandProcess();
  CommandProcess(const CommandProcess&) = delete;
  CommandProcess& operator=(const CommandProcess&) = delete;

  /// Listens to the program until plumb asks, or ends.
  void wait_for_plumb();
  /// Sends a line; throws NoLine where it would have to wait.
  void send(const std::string& line);
  /// The next line that it sends, or sent already; nullopt when plumb ends first. Throws NoLine.
  [[nodiscard]] std::optional<std::string> next_line();

  [[nodiscard]] pid_t number() const { return program_; }

 private:
  /// Listens for so many ms at most, for ever if negative.
  [[nodiscard]] bool plumb_calls(int patience);
  void reap_orphans() const;
  void hear_the_end();
  [[noreturn]] void throw_end(const std::string& otherwise);

  int plumb_;
  pid_t program_ = -1;
  bool has_ended_ = false;
  Descriptor input_, output_, words_;
  Descriptor ended_;   ///< readable once the program has
  std::string lines_;  ///< that came and were not asked for yet
  std::string said_;
};

/// Of a text that may be anything: the beginning of its first line.
[[nodiscard]] std::string first_words(const std::string& text);

}  // namespace plumb
