// Bytes -> pair -> answer -> laws.
//
// Environment
//   PLUMB_FUZZ_METHOD   the method that answers; default auto
//   PLUMB_FUZZ_ABORT    the findings that stop the engine (known.hpp). By default a silent wrong answer does (converged, and
//                       a law is broken), and so do a crash, a number that is not finite, an answer that differs from run to
//                       run or with the bodies exchanged. An answer that says of itself that it is none does not: `nonconverged`
//                       with its own status is legal, the campaign counts it.
//   PLUMB_FUZZ_OUT      a folder: the case of a finding that stops is written there, ready for plumb replay
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "fuzz/decode.hpp"
#include "fuzz/judging.hpp"
#include "fuzz/kept.hpp"
#include "fuzz/known.hpp"
#include "fuzz/target.hpp"

namespace plumb {
namespace {

std::string environment(const char* variable, const char* otherwise) {
  const char* value = std::getenv(variable);
  return value == nullptr ? otherwise : value;
}

struct Settings {
  Solver solver = find_solvers(environment("PLUMB_FUZZ_METHOD", "auto")).front();
  AbortRule rule{environment("PLUMB_FUZZ_ABORT", "default")};
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
  const std::string method = answering_method(settings().solver, judged.answer);
  const bool stop = settings().rule.stops(method, finding);
  if (stop) keep(c, method, finding, judge.reference());
  if (finding.kind == FindingKind::none) return {false, fmt::format("none by {}", method)};
  return {stop, fmt::format("{} by {}, severity {:.3g}, law '{}': {}", name(finding.kind), method, finding.severity,
                            finding.law, finding.detail)};
}

}  // namespace plumb
