// plumb: finds plumb-NAME beside itself and becomes it, as git does.
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/command/program_folder.hpp"

namespace {

namespace fs = std::filesystem;

struct Command {
  std::string_view name, summary;
};

// Every command of the contract; those that this build does not have are not listed.
constexpr std::array<Command, 22> commands{{
    {"solve", "solve the contact of each case, by one method or all of them"},
    {"methods", "the methods, and the problem that each one solves"},
    {"certify", "prove the overlap, the normal and the points of a case"},
    {"check", "judge anybody's answer to a case"},
    {"doctor", "whether a foreign solver's adapter is sane, before all else"},
    {"campaign", "random cases by the thousand, every wrong answer kept"},
    {"campaign-mpi", "the same over the processes of mpirun"},
    {"families", "the families that random cases come from"},
    {"ladder", "the hard cases, step by step; freezes them with their certificates"},
    {"merge", "put campaigns that ran apart together"},
    {"replay", "run kept cases against what they expect"},
    {"promote", "move a kept case on: open, incubating, regressions"},
    {"path", "follow a motion step by step, cold and warm, and judge how the answers change"},
    {"shrink", "the simplest case with the same defect"},
    {"fuzz", "guided fuzzing of a solver until it is wrong; the case, shrunk"},
    {"scene", "a scene of bodies: which effects run, why, what each costs"},
    {"scenes", "the named scenes, and each as a file"},
    {"import", "the pairs of a LAMMPS or LIGGGHTS dump that touch, as cases"},
    {"export", "cases or a scene as a dump for LAMMPS, LIGGGHTS and OVITO"},
    {"export-lammps", "a scene as input for plumb lammps"},
    {"lammps", "LAMMPS with pair_style plumb/cn: scenes on many processes"},
    {"report", "one page of HTML from campaigns"},
}};

fs::path program(std::string_view name) {
  return plumb::program_folder() / ("plumb-" + std::string(name));
}

int refuse(const std::string& reason) {
  (void)std::fprintf(stderr, "plumb: %s\n", reason.c_str());
  return 2;
}

int list_commands() {
  std::string text =
      "plumb shows whether a contact normal stands true.\n\n  plumb COMMAND ...    plumb COMMAND --help\n\n";
  for (const auto& [name, summary] : commands)
    if (fs::exists(program(name))) text += fmt::format("  {:<13} {}\n", name, summary);
  const bool written = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  return written ? 0 : refuse(std::string("standard output: ") + std::strerror(errno));
}

int print_version() {
  const bool written = std::puts("plumb " PLUMB_VERSION) >= 0 && std::fflush(stdout) == 0;
  return written ? 0 : refuse(std::string("standard output: ") + std::strerror(errno));
}

bool is_name(std::string_view text) {
  return !text.empty() && text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_") == std::string_view::npos;
}

int become(char** argv) {
  const std::string name = argv[0];
  const fs::path path = program(name);
  if (!is_name(name) || name.front() == '-' || !fs::exists(path))
    return refuse(fmt::format("no command '{}' (plumb --help lists them)", is_name(name) ? name : "?"));
  ::execv(path.c_str(), argv);
  return refuse(path.string() + ": " + std::strerror(errno));
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string_view first = argc > 1 ? argv[1] : "--help";
  if (first == "--help" || first == "-h" || first == "help") return list_commands();
  if (first == "--version") return print_version();
  return become(argv + 1);
} catch (const std::exception& error) {
  return refuse(error.what());
}
