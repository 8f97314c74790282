// plumb families: what the campaign can draw from.
#include <fmt/format.h>

#include "corpus/command.hpp"
#include "properties/families.hpp"

namespace plumb {
namespace {

int list_families() {
  for (const Family& family : families()) fmt::print("{:<14}{}\n", family.name, family.summary);
  fmt::print("\ngenerators of hard:\n");
  for (const std::string_view generator : hard_generators()) fmt::print("  {}\n", generator);
  return 0;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  CLI::App app("The families of random cases", "plumb families");
  return plumb::run_command(app, argc, argv, plumb::list_families);
}
