#include "corpus/solvers/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "corpus/case/case.hpp"
#include "corpus/json/nearest_word.hpp"
#include "solver/method/convex.hpp"
#include "solver/method/methods.hpp"

namespace plumb {
namespace {

Solver solver_of(const Method& method) {
  Solver out{std::string(method.name),
             {.problem = method.problem},
             std::string(method.summary),
             method.is_published(),
             true,
             [solve = method.solve](const Pair& pair, const Want& want, const Contact<double>* last) {
               return solve(pair, want, last);
             }};
  if (method.name == "auto") out.solve_convex = solve_convex;
  return out;
}

std::string known_names() {
  return fmt::format("{}", fmt::join(solver_names(), ", "));
}

// A method that is named twice would have each of its answers counted twice.
bool contains(const std::vector<Solver>& solvers, const std::string& name) {
  return std::any_of(solvers.begin(), solvers.end(), [&](const Solver& solver) { return solver.name == name; });
}

Solver solver_named(const std::string& name) {
  if (std::optional<Solver> found = find_solver(name)) return *std::move(found);
  throw InputFailure("--method", 0, name, no_such("method", name, solver_names()));
}

}  // namespace

std::vector<std::string> solver_names() {
  std::vector<std::string> names;
  for (const Method& method : methods()) names.emplace_back(method.name);
  for (const std::string& peer : peer_names()) names.push_back(peer);
  return names;
}

std::optional<Solver> find_solver(const std::string& name) {
  if (const Method* method = find_method(name)) return solver_of(*method);
  const std::vector<std::string> peers = peer_names();
  if (std::find(peers.begin(), peers.end(), name) == peers.end()) return std::nullopt;
  return load_peer(name);
}

std::vector<Solver> all_solvers() {
  std::vector<Solver> solvers;
  for (const std::string& name : solver_names()) solvers.push_back(solver_named(name));
  return solvers;
}

std::vector<Solver> find_solvers(const std::string& names) {
  if (names == "all") return all_solvers();
  std::vector<Solver> solvers;
  std::istringstream list(names);
  for (std::string name; std::getline(list, name, ',');)
    if (!contains(solvers, name)) solvers.push_back(solver_named(name));
  if (solvers.empty()) throw InputFailure("--method", 0, "", "names no method; there are " + known_names());
  return solvers;
}

}  // namespace plumb
