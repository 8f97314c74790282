#include "fuzz/main_job/engine_run.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>
#include <vector>

#include "corpus/case/case.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/command/progress.hpp"
#include "corpus/file/text_input.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// The seeds have the length of their layout.
std::uintmax_t longest(const fs::path& seeds) {
  std::uintmax_t out = 0;
  for (const auto& seed : fs::directory_iterator(seeds)) out = std::max(out, fs::file_size(seed));
  return out;
}

std::vector<std::string> command_line(const EngineOptions& options, const fs::path& folder) {
  return {options.program.string(),
          fmt::format("-runs={}", options.inputs),
          fmt::format("-max_total_time={:.0f}", std::ceil(options.seconds)),
          fmt::format("-seed={}", options.seed),
          fmt::format("-max_len={}", longest(options.seeds)),
          "-len_control=0",
          "-timeout=60",
          "-print_final_stats=1",
          fmt::format("-artifact_prefix={}/", folder.string()),
          (folder / "corpus").string(),
          options.seeds.string()};
}

/// An engine that starts from what an earlier run left finds something else: the folder starts empty.
fs::path fresh_folder(const fs::path& asked) {
  const fs::path folder = fs::absolute(asked);
  fs::remove_all(folder);
  fs::create_directories(folder / "corpus");
  return folder;
}

std::vector<std::string> environment_with(const fs::path& failures, std::vector<std::string> all) {
  all.push_back("PLUMB_FUZZ_OUT=" + failures.string());
  for (char** entry = environ; *entry != nullptr; ++entry)
    if (std::strncmp(*entry, "PLUMB_FUZZ_", 11) != 0) all.emplace_back(*entry);
  return all;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> out;
  for (std::string& text : texts) out.push_back(text.data());
  out.push_back(nullptr);
  return out;
}

pid_t start(std::vector<std::string> arguments, std::vector<std::string> environment, const fs::path& log) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = 0;
  const auto argv = pointers(arguments), envp = pointers(environment);
  const int error = posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), envp.data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw InputFailure(arguments[0], 0, "--fuzzer", std::strerror(error));
  return child;
}

/// The last count that libFuzzer printed: "#1234<tab>NEW ..", then "stat::number_of_executed_units: 1234".
std::uint64_t inputs_so_far(const fs::path& log) {
  std::ifstream in(log);
  std::uint64_t count = 0;
  constexpr std::string_view final_count = "stat::number_of_executed_units:";
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) count = std::strtoull(line.c_str() + 1, nullptr, 10);
    if (line.starts_with(final_count)) count = std::strtoull(line.c_str() + final_count.size(), nullptr, 10);
  }
  return count;
}

int wait_for(pid_t child, const fs::path& log, Progress& progress) {
  int status = 0;
  for (int turn = 0; waitpid(child, &status, WNOHANG) == 0; ++turn) {
    // The terminal sends Ctrl-C to the child as well; a lone `kill -INT` does not.
    if (interrupted()) kill(child, SIGINT);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    if (turn % 5 == 0) progress.show(inputs_so_far(log));
  }
  return status;
}

/// The line of the target or of the sanitizer that names the fault.
std::string fault_in(const fs::path& log) {
  std::ifstream in(log);
  std::string found = "ended without success; see " + log.string();
  for (std::string line; std::getline(in, line);)
    for (const char* sign : {", severity ", "runtime error:", "ERROR: AddressSanitizer", "ERROR: libFuzzer: timeout"})
      if (line.find(sign) != std::string::npos) return line;
  return found;
}

}  // namespace

void require_seeds(const fs::path& folder) {
  const bool some = fs::is_directory(folder) && fs::directory_iterator(folder) != fs::directory_iterator();
  if (!some) throw InputFailure(folder.string(), 0, "--seeds", "holds no seed");
}

EngineRun run_engine(const EngineOptions& options) {
  const fs::path folder = fresh_folder(options.folder), log = folder / "log.txt";
  const std::string program = options.program.filename().string();
  Progress progress(program, options.inputs);
  const pid_t child =
      start(command_line(options, folder), environment_with(fs::absolute(options.failures), options.environment), log);
  const int status = wait_for(child, log, progress);
  EngineRun run{program, inputs_so_far(log), progress.seconds(), ""};
  progress.finish(run.inputs);
  const bool success = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (!success && !interrupted()) run.found = fault_in(log);
  return run;
}

void add_to_summary(const std::vector<EngineRun>& runs, const fs::path& out) {
  const fs::path path = out / "summary.json";
  Json summary = read_json(read_text(path));
  double seconds = 0;
  for (const EngineRun& run : runs) {
    summary["x_fuzzers"][run.target] = {{"inputs", run.inputs}, {"found", run.found}};
    seconds += run.seconds;
  }
  summary["timing"]["fuzzer_seconds"] = seconds;
  if (interrupted()) summary["incomplete"] = true;
  write_file(path, summary.dump(2) + "\n");
}

}  // namespace plumb
