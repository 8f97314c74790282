// What every command's main() shares: one line and exit 2 for unusable input, 130 after Ctrl-C, output that was written.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "corpus/case/case.hpp"
#include "corpus/command/command_line.hpp"
#include "corpus/solvers/solver.hpp"

namespace plumb {

/// --solver and --solver-command, any number of either, --solver-limit and --solver-memory.
struct ForeignOption {
  std::vector<std::string> libraries, commands;
  SolverLimits limits;

  [[nodiscard]] bool empty() const { return libraries.empty() && commands.empty(); }
};
/// `excluded`: what cannot stand beside one of them, or null.
void declare_solver(CommandLine& app, ForeignOption& option, const std::string& help,
                    const CommandOption* excluded = nullptr);
/// All that were named. Throws InputFailure: also where two of them have one name.
[[nodiscard]] std::vector<Solver> load_solvers(const ForeignOption& foreign);
/// The one solver that takes the place of a case's own: the library, else the method of that name; none where neither was named.
/// `command` is for the refusal of several. Throws InputFailure.
[[nodiscard]] std::optional<Solver> solver_instead(const ForeignOption& foreign, const std::string& method,
                                                   const std::string& command);

/// The solver that a case names, `auto` where it names none. Throws InputFailure where it is not of this build: also for a library,
/// which a case must not make us load.
[[nodiscard]] Solver solver_of_case(const Case& c, const std::string& file, int line);

enum ExitCode { exit_done = 0, exit_finding = 1, exit_unusable = 2, exit_interrupted = 130 };

/// Parses the arguments, runs the body (which returns 0 or 1) and turns whatever it throws into one line on stderr and 2.
/// Ctrl-C only sets interrupted() of corpus/command/interrupt.hpp: the body stops when it sees it, and what it printed is kept.
[[nodiscard]] int run_command(CommandLine& app, int argc, char** argv, const std::function<int()>& body);

/// A check for CLI11, which takes nan for a number in any range and prints the bounds of a type as hundreds of digits: what is
/// wrong with the text of a whole number above 0, empty when nothing is.
[[nodiscard]] std::string refuse_count(const std::string& text);

/// The same of a whole number of 64 bits, 0 among them: a seed, an index. CLI11 takes -1 for the greatest.
[[nodiscard]] std::string refuse_seed(const std::string& text);
/// The option --seed.
void declare_seed(CommandLine& app, std::uint64_t& seed, const std::string& help = "same seed, same cases");

/// The same of a time: a number above 0.
[[nodiscard]] std::string refuse_seconds(const std::string& text);

/// Hands each case of a file to `work` until Ctrl-C. Throws InputFailure, also where the file holds none and for a FieldError of `work`.
void each_case(const std::string& file, const std::function<void(const Case&, int line)>& work,
               CaseShapes shapes = CaseShapes::superellipsoids);

/// Text and a line feed on standard output; throws when it cannot be written.
void print_line(const std::string& text);

/// Hands out what was printed: where a stream is fed line by line, its reader waits for each answer. Throws as well.
void flush_output();

}  // namespace plumb
