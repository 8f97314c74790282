// The processes of one foreign solver: as many as there are threads that ask at the same time, each started anew when it ended.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "corpus/solvers/solver_process.hpp"

namespace plumb {

class SolverPool {
 public:
  /// Nothing is started yet.
  SolverPool(SolverSource source, const SolverLimits& limits);

  /// Starts one process, for those after it to be asked at once, and returns what it says of itself. Throws InputFailure when there
  /// is no solver.
  wire::Hello start();
  /// What the library threw is a NoAnswer, too. Throws InputFailure when what started once does not start again.
  [[nodiscard]] wire::Reply ask(const wire::Request& request);
  [[nodiscard]] std::optional<Leak> find_leak(std::vector<plumb_pair> pairs) const;
  [[nodiscard]] std::uint64_t hangs() const { return hangs_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  /// By which its answers go: before the first is asked for.
  void call(std::string name) { name_ = std::move(name); }
  [[nodiscard]] const SolverSource& source() const { return source_; }

 private:
  using Process = std::unique_ptr<SolverProcess>;
  [[nodiscard]] Process take();
  void give_back(Process process);
  [[nodiscard]] bool answers_when_first(const wire::Request& request);

  std::string name_;
  SolverSource source_;
  SolverLimits limits_;
  std::mutex mutex_;
  std::vector<Process> idle_;
  std::atomic<std::uint64_t> hangs_{0};
};

}  // namespace plumb
