// A folder of its own for each test, and the programs run in it: what they print, and their exit code.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "corpus/case/case.hpp"
#include "properties/tests/corpus/sample.hpp"

namespace plumb {

namespace fs = std::filesystem;

struct Ran {
  int code;
  std::string out;
};

inline Ran run(const std::string& command) {
  Ran ran{-1, ""};
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return ran;
  std::array<char, 4096> part{};
  for (std::size_t n = 0; (n = fread(part.data(), 1, part.size(), pipe)) > 0;) ran.out.append(part.data(), n);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) ran.code = WEXITSTATUS(status);
  return ran;
}

inline const std::string plumb_program = std::string(PLUMB_BINARY_DIR) + "/bin/plumb ";

class Commands : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(path_); }
  void TearDown() override { fs::remove_all(path_); }

  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    write_file(path_ / name, text);
    return (path_ / name).string();
  }
  /// What a program left in the folder.
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream in(path_ / name);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
  }
  [[nodiscard]] Json json(const std::string& name) const { return Json::parse(read(name)); }
  /// In the folder, so that messages carry bare names.
  [[nodiscard]] Ran plumb(const std::string& arguments) const {
    return run("cd " + path_.string() + " && " + plumb_program + arguments);
  }
  void expect_refusal(const std::string& arguments, const std::string& line) const {
    const Ran ran = plumb(arguments + " 2>&1 >/dev/null");
    EXPECT_EQ(ran.code, 2) << arguments;
    EXPECT_EQ(ran.out, line + "\n") << arguments;
  }

  fs::path path_ = fs::temp_directory_path() / ("plumb-commands-" + std::to_string(::getpid()));
};

inline std::vector<Json> lines_of(const std::string& text) {
  std::vector<Json> out;
  for (std::size_t begin = 0, end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    out.push_back(Json::parse(text.substr(begin, end - begin)));
  return out;
}

}  // namespace plumb
