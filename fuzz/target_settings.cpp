#include "fuzz/target_settings.hpp"

#include <cstdlib>

#include "corpus/case.hpp"

namespace plumb {
namespace {

std::string environment(const char* variable, const char* otherwise) {
  const char* value = std::getenv(variable);
  return value == nullptr ? otherwise : value;
}

/// The variable takes the place of --method, and is named where its value is refused.
Solver solver_asked() {
  try {
    return find_solvers(environment("PLUMB_FUZZ_METHOD", "auto")).front();
  } catch (const InputFailure& e) {
    throw InputFailure("PLUMB_FUZZ_METHOD", 0, "", e.what());
  }
}

}  // namespace

const TargetSettings& target_settings() {
  static const TargetSettings read{solver_asked(), AbortRule(environment("PLUMB_FUZZ_ABORT", "")),
                                   environment("PLUMB_FUZZ_OUT", "")};
  return read;
}

void keep_fuzzed(const std::string& file, const std::string& text) {
  const std::filesystem::path& folder = target_settings().out;
  if (!folder.empty()) write_file(folder / file, text);
}

}  // namespace plumb
