// plumb families: what the campaign can draw from.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "corpus/command/command.hpp"
#include "properties/generators/families.hpp"
#include "properties/generators/families_hard.hpp"
#include "properties/generators/families_shapes.hpp"

namespace plumb {
namespace {

void list_generators(const Family& family) {
  fmt::print("\ngenerators of {}, and the ladder of each:\n", family.name);
  for (const HardGenerator& generator : family.generators())
    fmt::print("  {:<27}{:<16}{:g}\n", generator.name, generator.knob, fmt::join(generator.steps, " "));
}

int list_families() {
  for (const Family& family : families()) fmt::print("{:<14}{}\n", family.name, family.summary);
  for (const Family& family : families())
    if (family.generators != nullptr) list_generators(family);
  fmt::print(
      "\nfamilies of any two shapes, and the ladder of each; `auto` alone is asked, and `all` leaves them out:\n");
  for (const ShapeFamily& family : shape_families())
    fmt::print("  {:<27}{}\n    {:<25}{:g}\n", family.name, family.summary, family.knob, fmt::join(family.steps, " "));
  return 0;
}

}  // namespace
}  // namespace plumb

int main(int argc, char** argv) {
  plumb::CommandLine app("The families of random cases", "plumb families");
  return plumb::run_command(app, argc, argv, plumb::list_families);
}
