// Steps a scene that has every effect but one: count-steps EFFECT. Built with all effects, and for each effect without its file.
#include <cstdio>

#include "properties/tests/scene/crowd.hpp"
#include "solver/scene/simulation.hpp"

namespace plumb::scene {
namespace {

constexpr int counted_steps = 60;

/// The part that callgrind counts.
[[gnu::noinline]] void count_steps(Simulation& run) {
  for (int i = 0; i < counted_steps; ++i) run.step();
}

}  // namespace
}  // namespace plumb::scene

int main(int argc, char** argv) {
  using namespace plumb::scene;
  if (argc != 2) return 2;
  const Scene scene = without(crowd(), argv[1]);
  Simulation run(scene, make_plan(scene));
  count_steps(run);
  std::printf("%016lx\n", run.hash());
}
