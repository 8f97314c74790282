// A shared library behind solver/plumb_solver.h, loaded into this process. Needs nothing of plumb but that header: the program
// that answers for foreign solvers (solver_host.cpp) is to start in a millisecond.
#pragma once

#include <stdexcept>
#include <string>

#include "corpus/solvers/solver_wire.hpp"

namespace plumb {

struct SolverLibrary {
  decltype(&plumb_solver_solve) solve = nullptr;
  decltype(&plumb_solver_solve_warm) solve_warm = nullptr;  ///< null: the library has none
  plumb_abilities abilities{};                              ///< what it claims
};

/// what() says why; `field`: the symbol that it is about, or nothing.
class UnusableLibrary : public std::runtime_error {
 public:
  UnusableLibrary(std::string field_, const std::string& reason)
      : std::runtime_error(reason), field(std::move(field_)) {}
  std::string field;
};

/// The library stays loaded until the process ends: what it registered with the system may outlive any owner of ours.
/// Throws UnusableLibrary.
[[nodiscard]] SolverLibrary open_solver_library(const std::string& path);

/// What it says of itself, loaded.
void introduce(wire::Hello& hello, const SolverLibrary& library);

/// What a library gets to fill: NaN and `stalled`, so that nothing is vouched for that it does not say.
[[nodiscard]] plumb_contact silent_contact();

/// Its answer, from the last one where there is one and the library takes it; what plumb_solver_solve returned.
[[nodiscard]] int ask(const SolverLibrary& library, const plumb_pair& pair, const plumb_contact* last,
                      plumb_contact& answer);

}  // namespace plumb
