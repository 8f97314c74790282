// plumb: finds plumb-NAME beside itself and becomes it, as git does.
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/command/help/command_rows.hpp"
#include "corpus/command/program_folder.hpp"
#include "corpus/json/nearest_word.hpp"

namespace {

namespace fs = std::filesystem;

fs::path program(std::string_view name) {
  return plumb::program_folder() / ("plumb-" + std::string(name));
}

int refuse(const std::string& reason) {
  (void)std::fprintf(stderr, "plumb: %s\n", reason.c_str());
  return 2;
}

int print(const std::string& text) {
  const bool written = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  return written ? 0 : refuse(std::string("standard output: ") + std::strerror(errno));
}

/// Those that this build has.
std::vector<plumb::CommandRow> commands() {
  std::vector<plumb::CommandRow> out;
  for (const plumb::CommandRow& row : plumb::command_rows)
    if (fs::exists(program(row.name))) out.push_back(row);
  return out;
}

int list_commands() {
  std::string text = "plumb shows whether a contact normal stands true.\n\n  plumb COMMAND ...    plumb help COMMAND\n";
  std::string_view group;
  for (const plumb::CommandRow& row : commands()) {
    if (row.group != group) text += fmt::format("\n{}\n", group = row.group);
    text += fmt::format("  {:<16}{}\n", row.name, row.summary);
  }
  return print(text);
}

/// For completion.
int list_names() {
  std::string text;
  for (const plumb::CommandRow& row : commands()) text += fmt::format("{}\t{}\n", row.name, row.summary);
  return print(text);
}

bool is_name(std::string_view text) {
  return !text.empty() && text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_") == std::string_view::npos;
}

bool is_help_word(std::string_view text) {
  return text == "--help" || text == "-h" || text == "help";
}

int refuse_name(const std::string& name) {
  if (!is_name(name)) return refuse("no command '?' (plumb --help lists them)");
  std::vector<std::string> known;
  for (const plumb::CommandRow& row : commands()) known.emplace_back(row.name);
  const std::string meant = plumb::did_you_mean(name, known);
  return refuse(fmt::format("no command '{}'{}", name, meant.empty() ? " (plumb --help lists them)" : meant));
}

/// A scene's threads meet many times a step. Those that wait awake, as they do by default, are slower than one thread where another program
/// has a core. Heard where a program starts, and so set by who starts it; what the caller has set stays.
void let_threads_sleep() {
  (void)::setenv("OMP_WAIT_POLICY", "passive", 0);
}

int become(char** argv) {
  const std::string name = argv[0];
  const fs::path path = program(name);
  if (!is_name(name) || name.front() == '-' || !fs::exists(path)) return refuse_name(name);
  let_threads_sleep();
  ::execv(path.c_str(), argv);
  return refuse(path.string() + ": " + std::strerror(errno));
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string_view first = argc > 1 ? argv[1] : "--help";
  const bool is_help = is_help_word(first);
  if (is_help && argc > 2 && !is_help_word(argv[2])) {
    std::string help = "--help";
    std::array<char*, 3> arguments{argv[2], help.data(), nullptr};
    return become(arguments.data());
  }
  if (is_help) return list_commands();
  if (first == "--version" || first == "-V") return print("plumb " PLUMB_VERSION "\n");
  if (first == "--commands") return list_names();
  return become(argv + 1);
} catch (const std::exception& error) {
  return refuse(error.what());
}
