// Anything that answers a pair: plumb's own methods by name, a shared library behind solver/plumb_solver.h, or a program.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "corpus/solvers/abilities.hpp"
#include "solver/contact.hpp"
#include "solver/shape/convex.hpp"

namespace plumb {

class SolverPool;

struct Solver {
  std::string name;  ///< of a foreign one "solver:" and what it calls itself, or else its file
  Abilities abilities;
  std::string summary;
  bool published =
      false;  ///< a baseline from the literature or a peer: its findings are results, not failures of plumb
  bool is_own =
      false;  ///< plumb's: answers every legal pair, and with the same bits in any unit that is a power of two
  std::function<Contact<double>(const Pair&, const Want&, const Contact<double>* last)> solve;
  std::string option = {};  ///< of a foreign one: " --solver PATH", as one would type it to load it again
  std::shared_ptr<SolverPool> pool = nullptr;  ///< the processes of a foreign solver, whose solve() may throw NoAnswer
  /// The same of bodies of every shape; empty where it knows superellipsoids alone.
  std::function<Contact<double>(const ConvexPair&, const Want&, const Contact<double>* last)> solve_convex = nullptr;
};

/// What a foreign solver did instead of an answer; what() says it in words. Its process is gone, the next call gets another.
class NoAnswer : public std::runtime_error {
 public:
  enum class How { crashed, hung, not_asked };  ///< not_asked: it hung too often before
  NoAnswer(How how_, const std::string& what) : std::runtime_error(what), how(how_) {}
  How how;
};

struct SolverLimits {
  /// Of processor time for an answer, its children's among it, and six times that asleep. The one budget in plumb that is no count: nothing but the clock
  /// tells of a library that does not come back.
  double seconds = 10;
  double gibibytes = 4;  ///< of memory in its process
  double start = 60;     ///< seconds that it may sleep until it has started, or as long as before an answer
};

/// Every solver that this build has, in the order of `plumb methods`.
[[nodiscard]] std::vector<Solver> all_solvers();

/// Their names, in that order; no peer is started.
[[nodiscard]] std::vector<std::string> solver_names();

/// The one of that name; nothing where there is none.
[[nodiscard]] std::optional<Solver> find_solver(const std::string& name);

/// Comma-separated names or "all"; throws InputFailure (corpus/case/case.hpp) for an unknown one.
[[nodiscard]] std::vector<Solver> find_solvers(const std::string& names);

/// The solver in a shared library (solver/plumb_solver.h), in processes of its own: one for each thread that asks at the same
/// time. Throws InputFailure when it cannot be loaded.
[[nodiscard]] Solver load_solver(const std::string& path, const SolverLimits& limits = {});

/// The solver that a program is, in any language: started by the words of a command, without a shell, asked through its standard input
/// and output, one JSON object a line (corpus/solvers/host/solve_line.hpp). Throws as above.
[[nodiscard]] Solver load_solver_command(const std::string& command, const SolverLimits& limits = {});

/// A library in this process, which ends when the library ends it: for an engine that is to see its code, and for our own.
[[nodiscard]] Solver load_solver_in_process(const std::string& path);

/// A foreign library taken into this process, any other solver as it is: for a clock that is to see the solver alone.
[[nodiscard]] Solver in_process(const Solver& solver);

/// The peers that this build has, other people's solvers (fuzz/peers/): those whose library is in peers/ beside the program.
[[nodiscard]] std::vector<std::string> peer_names();

/// One of them, in processes of its own; throws InputFailure when there is no such peer.
[[nodiscard]] Solver load_peer(const std::string& name);

struct TimedContact {
  Contact<double> contact;
  double nanoseconds = 0;  ///< of the solver alone, wherever it runs; of a program what it says, or else there and back
};
[[nodiscard]] TimedContact solve_timed(const Solver& solver, const Pair& pair, const Want& want,
                                       const Contact<double>* last);
/// By its solve_convex.
[[nodiscard]] TimedContact solve_timed(const Solver& solver, const ConvexPair& pair, const Want& want,
                                       const Contact<double>* last);

/// After so many answers that did not come a foreign solver is not asked any more: each takes the whole limit.
inline constexpr std::uint64_t most_hangs = 20;
[[nodiscard]] bool is_given_up(const Solver& solver);

/// Memory that a foreign solver takes and does not give back.
struct Leak {
  double bytes_a_call = 0;
  std::uint64_t calls = 0;  ///< over which it was measured
};

/// Asks a fresh process for the same pairs again and again: a leak is what grows each time, after the first. Pairs without
/// an answer are left out. nullopt: none, or the solver is in this process, or it hung.
[[nodiscard]] std::optional<Leak> find_leak(const Solver& solver, std::span<const Pair> pairs);

}  // namespace plumb
