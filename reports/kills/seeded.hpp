// The solver with seeded bugs (fuzz/bugs), loaded, and what its table says of each.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "solver/shape/convex.hpp"

namespace plumb::reports {

/// A row of fuzz/bugs/*.json.
struct SeededBug {
  std::string name, kind, file;
  std::string seen;      ///< what a user would see of it
  std::string survives;  ///< why no engine kills it; empty where one should
};

/// `auto` with bug `bug`, from an earlier contact or from none. Bug 0 is none: the control.
using SeededSolve =
    std::function<Contact<double>(std::size_t bug, const Pair& pair, const Want& want, const Contact<double>* last)>;

/// The same of two bodies of any shapes.
using SeededSolveConvex = std::function<Contact<double>(std::size_t bug, const ConvexPair& pair)>;

struct SeededSolver {
  std::vector<SeededBug> bugs;  ///< bug k of `solve` is bugs[k - 1]
  SeededSolve solve;            ///< from any thread
  SeededSolveConvex solve_convex;
};

/// Throws InputFailure for a library that is none of seeded bugs. It stays loaded.
[[nodiscard]] SeededSolver load_seeded(const std::string& path);

}  // namespace plumb::reports
