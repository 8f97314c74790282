// plumb methods: the list of methods, the problem that each solves, one line of what it is.
#include <fmt/format.h>

#include "corpus/command/command.hpp"
#include "corpus/solvers/solver.hpp"

namespace {

int list_methods() {
  for (const plumb::Solver& solver : plumb::all_solvers())
    plumb::print_line(
        fmt::format("{:<27} {:<15} {}", solver.name, plumb::name(solver.abilities.problem), solver.summary));
  return plumb::exit_done;
}

}  // namespace

int main(int argc, char** argv) {
  plumb::CommandLine app("The methods, the problem that each one solves, and what it is.", "plumb methods");
  return plumb::run_command(app, argc, argv, list_methods);
}
