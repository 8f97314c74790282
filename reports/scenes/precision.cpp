#include <Eigen/Geometry>
#include <array>
#include <fmt/format.h>

#include "corpus/command/interrupt.hpp"
#include "corpus/command/text_table.hpp"
#include "reports/scenes/tables.hpp"
#include "reports/scenes/timing.hpp"
#include "solver/scene/named.hpp"

namespace plumb::reports {
namespace {

using scene::Plan;
using scene::Scene;
using scene::Simulation;

constexpr std::array accuracies{1e-2, 1e-3, 1e-4, 1e-5};
/// The reference run: its step is a third of the finest one's, its error a ninth.
constexpr double reference_accuracy = 1e-6;
/// Steps of the coarsest run after the first contact; what comes later is chaos in scenes of many bodies.
constexpr double horizon_steps = 300;
/// Bodies of a scene whose number may be chosen.
constexpr int bodies = 27;

/// What a run ends in.
struct Outcome {
  Plan plan;
  double seconds = 0, drift = 0;  ///< of the total energy, over the largest kinetic energy
  scene::Totals totals;
  std::vector<Vec3<double>> position;
  std::vector<Eigen::Quaterniond> orientation;
};

double sum_of(const std::map<std::string, double>& energy) {
  double sum = 0;
  for (const auto& [owner, value] : energy) sum += value;
  return sum;
}

/// Energies are looked at this often.
constexpr std::int64_t looks = 50;

Outcome run_scene(const Scene& scene, int repeat) {
  Outcome out{scene::make_plan(scene), std::numeric_limits<double>::infinity(), 0, {}, {}, {}};
  for (int k = 0; k < repeat; ++k) {
    Simulation run(scene, out.plan);
    const double start = sum_of(run.energy());
    double seconds = 0, kinetic = 0, change = 0;
    while (!run.is_done()) {
      seconds += time_steps(run, std::max<std::int64_t>(1, out.plan.steps / looks));
      const auto energy = run.energy();
      kinetic = std::max(kinetic, energy.at("kinetic"));
      change = std::max(change, std::abs(sum_of(energy) - start));
    }
    out.seconds = std::min(out.seconds, seconds);
    out.drift = change / kinetic;
    out.totals = run.totals();
    out.position.clear();
    out.orientation.clear();
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const auto q = run.world().state.orientation->entry(i);
      out.position.emplace_back(run.world().state.position->vector(i));
      out.orientation.emplace_back(q[0], q[1], q[2], q[3]);
    }
  }
  return out;
}

/// When bodies first touch in a coarse run; 0 where they never do.
double first_contact(const Scene& scene) {
  Simulation run(scene, scene::make_plan(scene));
  while (!run.is_done() && run.world().contacts.touching.empty()) run.step();
  return run.is_done() ? 0 : run.time();
}

/// The scene up to its horizon, at an accuracy; all of them end at the same time.
Scene cut_short(const scene::NamedScene& named, double accuracy) {
  Scene scene = named.make(named.bodies == 0 ? 0 : bodies);
  scene.run.outputs = {};
  scene.run.time_step.reset();
  scene.run.accuracy = accuracies.front();
  const double coarse = scene::make_plan(scene).time_step;
  scene.run.duration = std::min(scene.run.duration, first_contact(scene) + horizon_steps * coarse);
  scene.run.outputs.every = scene.run.duration;
  scene.run.accuracy = accuracy;
  return scene;
}

/// The largest error of a centre, in longest semi-axes, and of an orientation, rad.
std::array<double, 2> errors(const Scene& scene, const Outcome& of, const Outcome& reference) {
  std::array<double, 2> out{0, 0};
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const double size = scene.bodies[i].body.shape.semi_axes.maxCoeff();
    out[0] = std::max(out[0], (of.position[i] - reference.position[i]).norm() / size);
    out[1] = std::max(out[1], of.orientation[i].angularDistance(reference.orientation[i]));
  }
  return out;
}

bool dissipates(const Plan& plan) {
  for (const std::string_view name :
       {"damping", "friction", "rolling", "twisting", "drag", "moving_walls", "periodic_box"})
    if (plan.is_on(name)) return true;
  return false;
}

const TextTable columns({{"scene", "<11"},
                         {"accuracy", ">9.0e"},
                         {"steps", ">9"},
                         {"evaluations", ">12"},
                         {"position", ">12.1e"},
                         {"turn, rad", ">12.1e"},
                         {"energy", ">12"},
                         {"time", ">9.2f"}});

void add_row(ReportTable& table, const std::string& name, double accuracy, const Scene& scene, const Outcome& outcome,
             const Outcome& reference, double coarsest) {
  const auto [shift, turn] = errors(scene, outcome, reference);
  Json row{{"kind", "precision"},
           {"scene", name},
           {"accuracy", accuracy},
           {"time_step", outcome.plan.time_step},
           {"steps", outcome.plan.steps},
           {"evaluations", outcome.totals.evaluations},
           {"position_error", shift},
           {"turn_error", turn},
           {"time_ratio", outcome.seconds / coarsest},
           {"failed", outcome.totals.failed}};
  if (!dissipates(outcome.plan)) row["energy_drift"] = outcome.drift;
  const std::string drift = dissipates(outcome.plan) ? "dissipates" : fmt::format("{:.1e}", outcome.drift);
  table.lines.push_back(columns.row(name, accuracy, outcome.plan.steps, outcome.totals.evaluations, shift, turn, drift,
                                    outcome.seconds / coarsest));
  table.rows.push_back(std::move(row));
}

}  // namespace

ReportTable scene_precision(const SceneOptions& options) {
  ReportTable table;
  table.lines.push_back(columns.head());
  for (const scene::NamedScene& named : scene::named_scenes()) {
    const bool is_asked =
        options.scenes.empty() || std::ranges::find(options.scenes, named.name) != options.scenes.end();
    if (!is_asked || interrupted()) continue;
    const Outcome reference = run_scene(cut_short(named, reference_accuracy), 1);
    double coarsest = 0;
    for (const double accuracy : accuracies) {
      const Scene scene = cut_short(named, accuracy);
      const Outcome outcome = run_scene(scene, options.repeat);
      if (coarsest == 0) coarsest = outcome.seconds;
      add_row(table, std::string(named.name), accuracy, scene, outcome, reference, coarsest);
    }
  }
  return table;
}

}  // namespace plumb::reports
