#include "fuzz/targets/target_settings.hpp"

#include <cstdlib>

#include "corpus/case/case.hpp"

namespace plumb {
namespace {

std::string environment(const char* variable, const char* otherwise) {
  const char* value = std::getenv(variable);
  return value == nullptr ? otherwise : value;
}

/// The variable takes the place of --method, and is named where its value is refused.
Solver solver_asked() {
  const std::string method = environment("PLUMB_FUZZ_METHOD", "auto");
  try {
    // In this process, where the engine sees what code it takes, and its end.
    return method.find('/') == std::string::npos ? find_solvers(method).front() : load_solver_in_process(method);
  } catch (const InputFailure& e) {
    throw InputFailure("PLUMB_FUZZ_METHOD", 0, "", e.what());
  }
}

Accuracy accuracy_asked() {
  try {
    return parse_accuracy(environment("PLUMB_FUZZ_ACCURACY", "rounding"));
  } catch (const InputFailure& e) {
    throw InputFailure("PLUMB_FUZZ_ACCURACY", 0, "", e.what());
  }
}

/// In processes of its own; none where it is one of plumb's.
std::optional<Solver> foreign_asked() {
  const std::string library = environment("PLUMB_FUZZ_SOLVER", "");
  const std::string command = environment("PLUMB_FUZZ_SOLVER_COMMAND", "");
  if (!library.empty()) return load_solver(library);
  if (!command.empty()) return load_solver_command(command);
  return std::nullopt;
}

TargetSettings settings_asked() {
  const std::optional<Solver> foreign = foreign_asked();
  TargetSettings out{foreign ? *foreign : solver_asked(), accuracy_asked(), std::nullopt,
                     AbortRule(environment("PLUMB_FUZZ_ABORT", "")), environment("PLUMB_FUZZ_OUT", "")};
  if (foreign) out.guide.emplace(out.solver.abilities, out.accuracy);
  return out;
}

}  // namespace

const TargetSettings& target_settings() {
  static const TargetSettings read = settings_asked();
  return read;
}

void keep_fuzzed(const std::string& file, const std::string& text) {
  const std::filesystem::path& folder = target_settings().out;
  if (folder.empty()) return;
  std::error_code refused;  // said by write_file
  std::filesystem::create_directories(folder, refused);
  write_file(folder / file, text);
}

}  // namespace plumb
