#include <cmath>

#include "corpus/command/interrupt.hpp"
#include "corpus/command/text_table.hpp"
#include "reports/scenes/tables.hpp"
#include "reports/scenes/timing.hpp"
#include "solver/scene/named.hpp"

namespace plumb::reports {
namespace {

using scene::Simulation;

/// Part of the duration after which half of what will touch does; to its end 20 000 bodies would take an hour.
constexpr double falling = 0.25;
constexpr std::int64_t growth_steps = 50;

struct Grown {
  double seconds = 0;                    ///< a step
  std::map<std::string, double> shares;  ///< of those seconds, by owner
  std::size_t touching = 0, pairs = 0;
  scene::Totals totals;
};

Grown grow(const scene::NamedScene& named, int bodies) {
  scene::Scene scene = named.make(bodies);
  scene.run.outputs = {};
  Simulation run(scene, scene::make_plan(scene));
  run_until(run, falling);
  const auto before = run.seconds();
  Grown out;
  out.seconds = time_steps(run, growth_steps) / static_cast<double>(growth_steps);
  double sum = 0;
  for (const auto& [owner, seconds] : run.seconds()) sum += out.shares[owner] = seconds - before.at(owner);
  for (auto& [owner, seconds] : out.shares) seconds /= sum;
  out.touching = run.world().contacts.touching.size();
  out.pairs = run.world().contacts.pairs.size();
  out.totals = run.totals();
  return out;
}

}  // namespace

ReportTable scene_growth(const SceneOptions& options) {
  ReportTable table;
  const TextTable columns({{"bodies", ">8"},
                           {"contacts", ">10"},
                           {"pairs", ">10"},
                           {"step / n", ">14.2f"},
                           {"/ (n log n)", ">14.2f"},
                           {"solver", ">10.1f", " %"},
                           {"failed", ">9"}});
  table.lines.push_back(columns.head());
  const scene::NamedScene& pile = *scene::find_named_scene("pile");
  double linear = 0, with_log = 0;
  for (const int bodies : {200, 600, 2000, 6000, 20000}) {
    if (bodies > options.most_bodies || interrupted()) break;
    const Grown grown = grow(pile, bodies);
    const double each = grown.seconds / bodies, each_log = each / std::log(bodies);
    if (linear == 0) linear = each, with_log = each_log;
    table.lines.push_back(columns.row(bodies, grown.touching, grown.pairs, each / linear, each_log / with_log,
                                      100 * solver_share(grown.shares), grown.totals.failed));
    table.rows.push_back({{"kind", "growth"},
                          {"bodies", bodies},
                          {"contacts", grown.touching},
                          {"pairs", grown.pairs},
                          {"time_per_body_ratio", each / linear},
                          {"time_per_n_log_n_ratio", each_log / with_log},
                          {"solver_share_of_contact_time", solver_share(grown.shares)},
                          {"shares", grown.shares},
                          {"failed", grown.totals.failed}});
  }
  return table;
}

ReportTable scene_rest(const SceneOptions& /*options*/) {
  const scene::Scene scene = scene::find_named_scene("pile")->make(200);
  Simulation run(scene, scene::make_plan(scene));
  double greatest = 0;
  while (!run.is_done() && !interrupted()) {
    run.step();
    greatest = std::max(greatest, run.energy().at("kinetic"));
  }
  const double left = run.energy().at("kinetic") / greatest, share = solver_share(run.seconds());
  const scene::Totals totals = run.totals();
  ReportTable table;
  const TextTable columns({{"steps", ">8"},
                           {"solves", ">12"},
                           {"evaluations", ">14"},
                           {"failed", ">9"},
                           {"kinetic / greatest", ">24.1e"},
                           {"solver", ">10.1f", " %"}});
  table.lines = {columns.head(),
                 columns.row(run.steps(), totals.solves, totals.evaluations, totals.failed, left, 100 * share)};
  table.rows = {{{"kind", "rest"},
                 {"steps", run.steps()},
                 {"solves", totals.solves},
                 {"evaluations", totals.evaluations},
                 {"failed", totals.failed},
                 {"kinetic_left", left},
                 {"solver_share_of_contact_time", share},
                 {"seconds", run.seconds()}}};
  return table;
}

}  // namespace plumb::reports
