// plumb families: what the campaign can draw from.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "corpus/command/command.hpp"
#include "properties/generators/families.hpp"

namespace plumb {
namespace {

int list_families() {
  for (const Family& family : families()) fmt::print("{:<14}{}\n", family.name, family.summary);
  fmt::print("\ngenerators of hard, and the ladder of each:\n");
  for (const std::string_view generator : hard_generators()) {
    const std::string knob = ladder_case(generator, 0, 1, 0).provenance["knob"]["name"];
    fmt::print("  {:<27}{:<16}{:g}\n", generator, knob, fmt::join(ladder_steps(generator), " "));
  }
  return 0;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::CommandLine app("The families of random cases", "plumb families");
  return plumb::run_command(app, argc, argv, plumb::list_families);
}
