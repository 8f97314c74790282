// Campaigns that are killed half-way, and what is left of them.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "corpus/json/json_text.hpp"
#include "properties/tests/interrupting.hpp"

namespace plumb {

namespace fs = std::filesystem;

inline std::string text_in(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// All of a campaign's folder that must not depend on how the work was divided: file -> text.
inline std::map<std::string, std::string> found_in(const fs::path& folder) {
  std::map<std::string, std::string> found;
  for (const auto& entry : fs::directory_iterator(folder / "failures"))
    found[entry.path().filename().string()] = text_in(entry.path());
  Json summary = Json::parse(text_in(folder / "summary.json"), nullptr, false);
  if (summary.is_discarded()) return found;
  summary.erase("timing");
  summary.erase("host");
  found["summary.json"] = summary.dump(2);
  return found;
}

/// Chunks that are done in DIR.
inline std::ptrdiff_t chunks_done(const fs::path& folder) {
  std::error_code error;
  std::ptrdiff_t done = 0;
  for (const auto& entry : fs::directory_iterator(folder / "chunks", error))
    done += entry.path().extension() == ".part";
  return done;
}

/// Waits until ready() or the child's end, then calls `act`; false when the child ended before.
template <class Ready, class Act>
bool once(pid_t child, const Ready& ready, const Act& act) {
  while (waitpid(child, nullptr, WNOHANG) == 0) {
    if (ready()) {
      act();
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return false;
}

/// The process that runs `program` in `folder` and has `word` among its arguments or in its environment; 0 where there is none.
inline pid_t process_in(const fs::path& folder, const std::string& program, const std::string& word) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    if (fs::read_symlink(entry.path() / "exe", error).filename() != program) continue;
    if (fs::read_symlink(entry.path() / "cwd", error) != folder) continue;
    const std::string words = '\0' + text_in(entry.path() / "cmdline") + text_in(entry.path() / "environ");
    if (words.find('\0' + word + '\0') != std::string::npos) return std::stoi(entry.path().filename().string());
  }
  return 0;
}

/// Kills it. A number of 0 would be the test and all that it started.
inline void kill_in(const fs::path& folder, const std::string& program, const std::string& word) {
  const pid_t process = process_in(folder, program, word);
  ASSERT_GT(process, 0) << "no " << program << " with " << word << " runs in " << folder;
  kill(process, SIGKILL);
}

/// A folder for each test, and commands in it with the programs in the path.
class Cluster : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / ("plumb_cluster_" + std::to_string(getpid()) + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    folder_ = fs::canonical(folder_);  // as the kernel calls it
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string in_folder(const std::string& command) const {
    return "cd '" + folder_.string() + "' && export PATH=" PLUMB_BINARY_DIR "/bin:$PATH && exec " + command +
           " >>stdout 2>stderr";
  }
  /// The exit code.
  [[nodiscard]] int run(const std::string& command) const {
    int status = 0;
    waitpid(start_command(in_folder(command)), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  [[nodiscard]] std::string stderr_text() const { return text_in(folder_ / "stderr"); }
  /// Exit 2 and this line.
  void expect_refused(const std::string& command, const std::string& line) const {
    EXPECT_EQ(run(command), 2) << command;
    EXPECT_EQ(stderr_text(), line + "\n") << command;
  }

  fs::path folder_;
};

}  // namespace plumb
