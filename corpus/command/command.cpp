#include "corpus/command/command.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <optional>

#include "corpus/command/interrupt.hpp"
#include "corpus/json/number_text.hpp"

namespace plumb {
namespace {

int refuse(std::string reason) {
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  (void)std::fprintf(stderr, "%s\n", reason.c_str());
  return exit_unusable;
}

/// The exit code where parsing is the end of it.
std::optional<int> parse(CommandLine& app, int argc, char** argv) {
  const CommandLine::Parsed parsed = app.parse(argc, argv);
  if (parsed.go_on) return std::nullopt;
  if (!parsed.error.empty()) return refuse(app.name() + ": " + parsed.error + " (--help tells more)");
  if (std::fputs(parsed.help.c_str(), stdout) < 0) fail_with("standard output", errno);
  flush_output();
  return exit_done;
}

int run_body(const std::function<int()>& body) {
  const int code = body();
  flush_output();
  return interrupted() ? static_cast<int>(exit_interrupted) : code;
}

}  // namespace

int run_command(CommandLine& app, int argc, char** argv, const std::function<int()>& body) {
  try {
    if (const auto code = parse(app, argc, argv)) return *code;
    catch_interrupt();
    return run_body(body);
  } catch (const InputFailure& error) {
    (void)std::fflush(stdout);
    // What broke the input may have been the interrupt.
    return interrupted() ? static_cast<int>(exit_interrupted) : refuse(error.what());
  } catch (const std::exception& error) {
    (void)std::fflush(stdout);
    return refuse(app.name() + ": " + error.what());
  }
}

void declare_solver(CommandLine& app, ForeignOption& option, const std::string& help, const CommandOption* excluded) {
  auto* solver = app.add_option("--solver", option.libraries, help)->one_each();
  auto* command = app.add_option("--solver-command", option.commands,
                                 "the same, 'PROGRAM ARGS': JSON lines over its standard input and output")
                      ->one_each();
  if (excluded != nullptr) solver->excludes(excluded), command->excludes(excluded);
  app.add_option("--solver-limit", option.limits.seconds,
                 "seconds of processor time for an answer of a foreign solver; sleeping, six times that")
      ->check(refuse_seconds)
      ->capture_default_str();
  app.add_option("--solver-memory", option.limits.gibibytes, "GiB of memory that its process may take")
      ->check(refuse_seconds)
      ->capture_default_str();
}

namespace {

/// Results are kept by name.
void add_solver(std::vector<Solver>& to, Solver solver) {
  for (const Solver& other : to)
    if (other.name == solver.name)
      throw InputFailure("plumb", 0, solver.option.substr(1), "is called " + solver.name + ", as another is");
  to.push_back(std::move(solver));
}

}  // namespace

std::vector<Solver> load_solvers(const ForeignOption& foreign) {
  std::vector<Solver> out;
  for (const std::string& library : foreign.libraries) add_solver(out, load_solver(library, foreign.limits));
  for (const std::string& command : foreign.commands) add_solver(out, load_solver_command(command, foreign.limits));
  return out;
}

std::optional<Solver> solver_instead(const ForeignOption& foreign, const std::string& method,
                                     const std::string& command) {
  if (foreign.empty() && method.empty()) return std::nullopt;
  const std::vector<Solver> solvers = foreign.empty() ? find_solvers(method) : load_solvers(foreign);
  if (solvers.size() == 1) return solvers.front();
  if (!foreign.empty()) throw InputFailure("--solver", 0, solvers[1].name, command + " takes one solver");
  throw InputFailure("--method", 0, method, command + " takes one method");
}

Solver solver_of_case(const Case& c, const std::string& file, int line) {
  const std::string name = c.expect.method.value_or("auto");
  if (name.starts_with("solver:"))
    throw InputFailure(file, line, "expect.method", "'" + name + "' needs the library: --solver FILE");
  if (std::optional<Solver> found = find_solver(name)) return *std::move(found);
  throw InputFailure(file, line, "expect.method", "no method '" + name + "' here");
}

void flush_output() {
  if (std::fflush(stdout) != 0) fail_with("standard output", errno);
}

void print_line(const std::string& text) {
  if (std::fputs(text.c_str(), stdout) < 0 || std::fputc('\n', stdout) == EOF) fail_with("standard output", errno);
}

std::string refuse_count(const std::string& text) {
  const auto count = number_from<std::int64_t>(text);
  return count && *count > 0 ? "" : "'" + text + "' is not a whole number above 0";
}

std::string refuse_seed(const std::string& text) {
  if (number_from<std::uint64_t>(text)) return "";
  return "'" + text + "' is not a whole number from 0 to 18446744073709551615";
}

void declare_seed(CommandLine& app, std::uint64_t& seed, const std::string& help) {
  app.add_option("--seed", seed, help)->capture_default_str()->check(refuse_seed);
}

std::string refuse_seconds(const std::string& text) {
  const auto seconds = number_from<double>(text);
  return seconds && *seconds > 0 && *seconds <= 1e6 ? "" : "'" + text + "' is not a number above 0, at most 1e6";
}

void each_case(const std::string& file, const std::function<void(const Case&, int line)>& work, CaseShapes shapes) {
  CaseReader reader(file, shapes);
  bool any = false;
  while (!interrupted()) {
    const std::optional<Case> c = reader.next();
    if (!c) break;
    any = true;
    try {
      work(*c, reader.line());
    } catch (const FieldError& error) {
      throw InputFailure(reader.file(), reader.line(), error.field, error.what());
    }
  }
  if (!any && !interrupted()) throw InputFailure(reader.file(), 0, "", "holds no case");
}

}  // namespace plumb
