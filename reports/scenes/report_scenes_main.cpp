// plumb report-scenes: what accuracy costs in each named scene, what each effect costs, and how cost grows with the scene.
#include <fmt/format.h>

#include "corpus/case/case.hpp"
#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "reports/scenes/tables.hpp"

namespace plumb::reports {
namespace {

struct ScenesCommand {
  SceneOptions tables;
  ReportLines lines;
};

int report_scenes(ScenesCommand& command) {
  struct Part {
    const char* title;
    ReportTable (*make)(const SceneOptions& options);
  };
  constexpr Part parts[] = {
      {"Accuracy: largest error at the end against a finer run (positions in longest semi-axes), drift of energy over "
       "the "
       "largest\nkinetic energy, time over that of accuracy 1e-2",
       scene_precision},
      {"Effects: the time of a step of a dense pile with all effects over that without one, and what it keeps",
       effect_costs},
      {"Growth: piles of the same depth; time of a step for each body, and for each n log n, over those of 200; the "
       "solver's "
       "share of\nthe time of contacts",
       scene_growth},
      {"The pile of 200, from its fall to rest, on one thread; the solver's share of the time of contacts",
       scene_rest}};
  for (const Part& part : parts)
    if (!interrupted()) command.lines.add(part.title, part.make(command.tables));
  command.lines.write();
  return exit_done;
}

}  // namespace
}  // namespace plumb::reports

int main(int argc, char** argv) {
  plumb::reports::ScenesCommand command;
  plumb::CommandLine app("What accuracy, effects and size cost in scenes.", "plumb report-scenes");
  app.add_option("--scene", command.tables.scenes, "of the table of accuracy; default: all")->delimiter(',');
  app.add_option("--bodies", command.tables.most_bodies, "of the largest pile")->capture_default_str()->is_positive();
  app.add_option("--repeat", command.tables.repeat, "of each time; the least counts")
      ->capture_default_str()
      ->is_positive();
  command.lines.declare(app);
  return plumb::run_command(app, argc, argv, [&] { return plumb::reports::report_scenes(command); });
}
