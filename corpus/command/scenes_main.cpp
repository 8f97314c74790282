// plumb scenes: the named scenes, or one of them as a file.
#include <fmt/format.h>

#include "corpus/case/case.hpp"
#include "corpus/command/command.hpp"
#include "corpus/json/nearest_word.hpp"
#include "corpus/scene/scene_file.hpp"
#include "solver/scene/named.hpp"

namespace plumb::scene {
namespace {

void list_scenes() {
  for (const NamedScene& named : named_scenes()) {
    const std::string bodies = named.bodies == 0 ? "" : std::to_string(named.bodies);
    print_line(fmt::format("{:<12} {:>6}  {}", named.name, bodies, named.summary));
  }
}

std::vector<std::string> scene_names() {
  std::vector<std::string> out;
  for (const NamedScene& named : named_scenes()) out.emplace_back(named.name);
  return out;
}

void print_scene(const std::string& name, int bodies) {
  const NamedScene* named = find_named_scene(name);
  if (named == nullptr) throw InputFailure(name, 0, "", no_such("scene", name, scene_names(), "plumb scenes"));
  if (bodies != 0 && named->bodies == 0) throw InputFailure("--bodies", 0, "", "is fixed in " + name);
  const Json provenance = {{"named_scene", name}};
  print_line(format_scene({named->make(bodies == 0 ? named->bodies : bodies), provenance, {}}));
}

}  // namespace
}  // namespace plumb::scene

int main(int argc, char** argv) {
  std::string name;
  int bodies = 0;
  plumb::CommandLine app("The named scenes; with a name, that scene as a file.", "plumb scenes");
  app.add_option("NAME", name, "which one to write");
  app.add_option("--bodies", bodies, "how many, where that may be chosen")->in_range(1, 1'000'000);
  return plumb::run_command(app, argc, argv, [&] {
    if (name.empty())
      plumb::scene::list_scenes();
    else
      plumb::scene::print_scene(name, bodies);
    return static_cast<int>(plumb::exit_done);
  });
}
