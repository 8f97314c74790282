// Anything that answers a pair: plumb's own methods by name, or a shared library behind solver/plumb_solver.h.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "solver/contact.hpp"

namespace plumb {

struct Solver {
  std::string name;
  Problem problem = Problem::common_normal;
  std::string summary;
  bool published =
      false;  ///< a baseline from the literature or a peer: its findings are results, not failures of plumb
  bool unit_keeps_bits = false;  ///< plumb's own: a change of unit by a power of two changes no bit of the answer
  std::function<Contact<double>(const Pair&, const Want&, const Contact<double>* last)> solve;
};

/// Every solver that this build has, in the order of `plumb methods`.
[[nodiscard]] std::vector<Solver> all_solvers();

/// Comma-separated names or "all"; throws InputFailure (corpus/case.hpp) for an unknown one.
[[nodiscard]] std::vector<Solver> find_solvers(const std::string& names);

/// The solver in a shared library (solver/plumb_solver.h); throws InputFailure when it cannot be loaded.
[[nodiscard]] Solver load_solver(const std::string& path);

/// The peers that this build has, other people's solvers (fuzz/peers/): those whose library is in peers/ beside the program.
[[nodiscard]] std::vector<std::string> peer_names();

/// One of them; throws InputFailure when it cannot be loaded.
[[nodiscard]] Solver load_peer(const std::string& name);

}  // namespace plumb
