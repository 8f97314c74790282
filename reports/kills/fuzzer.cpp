#include <fmt/format.h>

#include <cstdlib>

#include "corpus/command/in_parallel.hpp"
#include "corpus/solvers/host/shell_words.hpp"
#include "fuzz/main_job/engine_run.hpp"
#include "reports/kills/engines.hpp"

namespace plumb::reports {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> environment_of(const Fuzzer& fuzzer, const std::string& bug) {
  std::vector<std::string> out{"PLUMB_FUZZ_METHOD=" + fs::absolute(fuzzer.library).string(), "PLUMB_SEEDED_BUG=" + bug};
  if (fuzzer.sees_code_alone) out.emplace_back("PLUMB_FUZZ_COUNTERS=off");
  return out;
}

/// Whether the program stops at that input without a bug as well.
bool stops_control(const Fuzzer& fuzzer, const fs::path& input) {
  std::string command = "env";
  for (const std::string& setting : environment_of(fuzzer, "none")) command += " " + shell_word(setting);
  command += fmt::format(" {} {} >{} 2>&1", shell_word(fuzzer.program.string()), shell_word(input.string()),
                         shell_word((input.parent_path() / "control.txt").string()));
  return std::system(command.c_str()) != 0;
}

/// What the engine kept of the input that stopped it.
fs::path stopping_input(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder))
    for (const char* kind : {"crash-", "timeout-", "oom-"})
      if (entry.path().filename().string().starts_with(kind)) return entry.path();
  return {};
}

}  // namespace

Hunt hunt_with(const Fuzzer& fuzzer, const Quarry& quarry) {
  Hunt hunt{fuzzer.inputs, std::vector<Kill>(quarry.bugs.size()), 0};
  std::atomic<std::uint64_t> of_control{0};
  in_parallel(quarry.bugs.size(), quarry.threads, [&](std::size_t i) {
    const std::string& bug = quarry.seeded.bugs[quarry.bugs[i] - 1].name;
    const fs::path out = fuzzer.out / fmt::format("{}-{}", bug, fuzzer.seed);
    const EngineRun run =
        run_engine({fuzzer.program, fuzzer.seeds, out, out, fuzzer.inputs, fuzzer.seed, environment_of(fuzzer, bug)});
    if (run.found.empty()) return;
    const fs::path input = stopping_input(out);
    if (input.empty() || stops_control(fuzzer, input))
      ++of_control;
    else
      hunt.kills[i] = {run.inputs, run.found.substr(0, run.found.find(" by ")), true};
  });
  hunt.control_findings = of_control;
  return hunt;
}

}  // namespace plumb::reports
