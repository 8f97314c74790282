// Bytes -> pair -> answer -> laws.
//
// Environment
//   PLUMB_FUZZ_METHOD   the method that answers; default auto
//   PLUMB_FUZZ_ABORT    the findings that stop the engine (abort_rule.hpp); by default every one does
//   PLUMB_FUZZ_OUT      a folder: the case of a finding that stops is written there, ready for plumb replay
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "fuzz/abort_rule.hpp"
#include "fuzz/decode.hpp"
#include "fuzz/judging.hpp"
#include "fuzz/kept.hpp"
#include "fuzz/target.hpp"

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

struct Settings {
  Solver solver = solver_asked();
  AbortRule rule{environment("PLUMB_FUZZ_ABORT", "")};
  std::filesystem::path out = environment("PLUMB_FUZZ_OUT", "");
};

/// Read once: the engine calls examine() some thousand times a second.
const Settings& settings() {
  static const Settings read;
  return read;
}

void keep(const Case& c, const std::string& method, const Finding& finding, const Reference& reference) {
  if (settings().out.empty()) return;
  const std::string file = bucket(name(finding.kind), method, c.pair, reference) + "--fuzzed.json";
  write_file(settings().out / file, format_case(failing_case(c, method, finding, "fuzz-pair")) + "\n");
}

}  // namespace

Outcome examine(std::span<const std::uint8_t> bytes) {
  const Case c = decode(bytes);
  Judge judge(c.pair);
  const JudgedAnswer judged = solve_and_judge(judge, c.pair, settings().solver);
  const Finding& finding = judged.judgement.finding;
  const std::string& method = settings().solver.name;
  const bool stop = settings().rule.stops(finding);
  if (stop) keep(c, method, finding, judge.reference());
  if (finding.kind == FindingKind::none) return {false, fmt::format("none by {}", method)};
  return {stop, fmt::format("{} by {}, severity {:.3g}, law '{}': {}", name(finding.kind), method, finding.severity,
                            finding.law, finding.detail)};
}

}  // namespace plumb
