#include "solver/scene/plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/scene/body/mass.hpp"
#include "solver/scene/check_scene.hpp"
#include "solver/scene/facts.hpp"

namespace plumb::scene {
namespace {

const char* const not_asked = "not asked for";
const char* const asked_for = "asked for";

/// Lists of at most so many pairs are kept for good: boxes around the bodies would cost more than they spare.
constexpr std::size_t few_pairs = 16;
/// Steps at least of the fastest thing that happens; fewer and a leapfrog loses its hold.
constexpr double least_steps = 8;
/// Steps where nothing happens that has a time of its own.
constexpr double quiet_steps = 100;
/// That of a patch, whose volume is an energy.
constexpr double patch_share = 1e-1;
/// By its error what lies still is shaken: this leaves dice at rest 1e-11 of their weight times their height.
constexpr double most_patch_error = 1e-4;
/// The solver's tolerance is this part of the accuracy: overlaps are about a hundredth of a body, their error far below.
constexpr double contact_share = 1e-6;

Analysis analysis_of(const Scene& scene) {
  if (scene.run.duration > 0 && can_move(scene)) return Analysis::motion;
  const Outputs& outputs = scene.run.outputs;
  return outputs.contacts || outputs.vtk || outputs.playback || outputs.bulk ? Analysis::contacts : Analysis::touching;
}

void add_needs(Needs& all, const Needs& one) {
  all.contacts |= one.contacts;
  all.points |= one.points;
  all.curvature |= one.curvature;
  all.curvature_each_step |= one.curvature_each_step;
  all.patch |= one.patch;
  all.spin |= one.spin;
  all.normal_force |= one.normal_force;
  all.normal_mass |= one.normal_mass;
  all.radius |= one.radius;
  all.contact_force |= one.contact_force;
  all.range = std::max(all.range, one.range);
  all.fastest = std::min(all.fastest, one.fastest);
}

/// Why it is off; empty where it is on.
std::string why_off(const Role& role, const Plan& plan, bool bodies_can_touch) {
  if (plan.analysis != Analysis::motion && !role.is_of_space) return "nothing moves";
  if (!role.off.empty()) return role.off;
  if (role.needs.contacts && !bodies_can_touch) return "no two bodies can meet: the balls that they can reach do not";
  return {};
}

/// A role, and between which materials it is one: empty where between all.
struct RoleOfPairs {
  Role role;
  std::string between;
};

Role role_between(const Effect& effect, const Scene& scene, std::size_t first, std::size_t second) {
  try {
    return effect.role(scene.effects, scene);
  } catch (const SceneError& error) {
    throw SceneError("materials", "between " + names_of_pair(scene, first, second) + ": " + std::string(effect.name) +
                                      " " + error.what());
  }
}

/// Of all pairs of materials together. `scene` takes on the effects of each.
RoleOfPairs role_of_pairs(const Effect& effect, const PairEffects& pairs, Scene& scene) {
  RoleOfPairs out;
  Needs of_off;  // what it needs where it is forced on
  bool is_between_all = true;
  for (std::size_t a = 0; a < pairs.materials; ++a)
    for (std::size_t b = a; b < pairs.materials; ++b) {
      const std::size_t pair = pairs.at(a, b);
      if (pairs.meets[pair] == 0) continue;
      scene.effects = pairs.of[pair];
      const bool is_asked = effect.is_asked(scene.effects);
      const Role one = is_asked ? role_between(effect, scene, a, b) : Role{{}, not_asked};
      is_between_all = is_between_all && one.off.empty();
      if (!one.off.empty() && out.between.empty() && is_asked) out.role.off = one.off;
      add_needs(one.off.empty() ? out.role.needs : of_off, one.needs);
      if (!one.off.empty()) continue;
      out.between += (out.between.empty() ? "" : ", ") + names_of_pair(scene, a, b);
    }
  if (out.between.empty())
    out.role.needs = of_off;
  else
    out.role.off.clear();
  if (is_between_all) out.between.clear();
  return out;
}

/// `scene` has the effects of all, before and after.
RoleOfPairs role_of(const Effect& effect, const Plan& plan, Scene& scene) {
  if (!effect.is_of_pairs || !plan.pair_effects.has_any()) return {effect.role(plan.asked, scene), {}};
  RoleOfPairs out = role_of_pairs(effect, plan.pair_effects, scene);
  scene.effects = plan.asked;
  return out;
}

PlannedEffect planned(const Effect& effect, Scene& scene, const Plan& plan, const PlanOptions& options,
                      bool bodies_can_touch) {
  PlannedEffect out{&effect, false, not_asked, {}};
  if (!effect.is_asked(plan.asked)) return out;
  const auto [role, between] = role_of(effect, plan, scene);
  const bool is_forced = options.forced.contains(effect.name);
  out.why = why_off(role, plan, bodies_can_touch);
  out.is_on = out.why.empty() || (is_forced && plan.analysis == Analysis::motion);
  if (out.is_on) out.needs = role.needs;
  if (is_forced && out.is_on) out.why = "forced on" + (out.why.empty() ? "" : ": " + out.why);
  if (out.why.empty()) out.why = std::string(asked_for) + (between.empty() ? "" : " between " + between);
  return out;
}

/// Names of the effects that need something, one after the other.
template <class Needs_>
std::string names_of(const Plan& plan, const Needs_& needs) {
  std::string out;
  for (const PlannedEffect& planned : plan.effects)
    if (planned.is_on && needs(planned.needs)) out += (out.empty() ? "" : ", ") + std::string(planned.effect->name);
  return out;
}

void plan_contacts(Plan& plan, const Scene& scene) {
  const std::string who = names_of(plan, [](const Needs& needs) { return needs.contacts; });
  const Outputs& outputs = scene.run.outputs;
  const bool is_written = outputs.contacts || outputs.touching || outputs.lives || outputs.bulk;
  if (!who.empty())
    plan.contacts_why = "needed by " + who;
  else if (plan.analysis != Analysis::motion || is_written)
    plan.contacts_why = "what is asked for";
  else
    plan.contacts_why = "no effect needs them and no output asks for them";
  plan.needs.contacts = plan.needs.contacts || plan.analysis != Analysis::motion || is_written;
  const bool is_shown =
      plan.needs.contacts && (outputs.contacts || outputs.vtk || outputs.playback || outputs.lives || outputs.bulk);
  plan.needs.points = plan.needs.points || plan.analysis == Analysis::contacts || is_shown;
  plan.needs.lives = outputs.lives && plan.analysis == Analysis::motion;
  plan.needs.contact_force = (plan.needs.contact_force || outputs.contacts || outputs.bulk) && plan.needs.normal_force;
}

void plan_turning(Plan& plan, const Scene& scene) {
  const std::string who = names_of(plan, [](const Needs& needs) { return needs.spin; });
  bool any_shape = false, any_spin = false, any_arm = false;
  for (const SceneBody& b : scene.bodies) {
    const bool has_arm = plan.needs.normal_force && !is_sphere(b.body.shape);
    const bool spins = !b.angular_velocity.isZero(0);  // its energy and momentum are results of every run
    const bool is_free = plan.analysis == Analysis::motion && !b.is_fixed;
    plan.turns.push_back(is_free && (plan.needs.spin || has_arm || spins));
    any_shape |= is_free && has_arm;
    any_arm |= has_arm;
    any_spin |= is_free && spins;
  }
  if (!plan.has_turning())
    plan.turning_why = "no effect, no contact and no output reads an orientation that changes";
  else if (plan.needs.spin)
    plan.turning_why = "every body, for " + who;
  else if (any_shape)
    plan.turning_why = "bodies that are no spheres, for their contacts";
  else if (any_spin)
    plan.turning_why = "bodies that spin";
  // A body that does not turn has its torque too, where bodies have any.
  plan.needs.points |=
      (plan.has_turning() && any_arm) || (plan.needs.normal_force && plan.needs.spin) || plan.needs.patch;
}

void plan_solver(Plan& plan, const Scene& scene) {
  const bool is_yes_or_no =
      plan.analysis == Analysis::touching ||
      (plan.analysis == Analysis::motion && !plan.needs.normal_force && !plan.needs.curvature && !plan.needs.points);
  plan.want.overlap = !is_yes_or_no;
  plan.want.normal = plan.needs.normal_force || plan.needs.points;
  plan.want.points = plan.needs.points;
  plan.want.curvature = plan.needs.curvature;
  plan.want.patch_tolerance = std::min(most_patch_error, patch_share * scene.run.accuracy);
  plan.want.tolerance = contact_share * scene.run.accuracy;
}

void plan_broad_phase(Plan& plan, const Scene& scene) {
  const std::size_t bodies = scene.bodies.size(), pairs = bodies * (bodies - 1) / 2 + bodies * scene.walls.size();
  const std::string count = std::to_string(pairs) + (pairs == 1 ? " pair" : " pairs");
  if (!plan.needs.contacts)
    plan.broad_phase_why = "no contacts";
  else if (pairs <= few_pairs)
    plan.broad_phase_why = count + ": one list for good";
  else if (plan.analysis != Analysis::motion && !can_move(scene))
    plan.broad_phase_why = count + ", asked once";
  else
    plan.broad_phase_why = count;
  if (plan.needs.contacts && pairs > few_pairs) plan.broad_phase = BroadPhase::tree;
}

double spin_time(const Scene& scene, const Plan& plan) {
  double fastest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (plan.turns[i] && !is_sphere(scene.bodies[i].body.shape))
      fastest = std::min(fastest, 2 * std::numbers::pi / scene.bodies[i].angular_velocity.norm());
  return fastest;
}

/// From the fastest thing that happens: a leapfrog's error goes as the square of the step.
void choose_time_step(Plan& plan, const Scene& scene) {
  const double fastest = std::min(plan.needs.fastest, spin_time(scene, plan));
  const std::string who = names_of(plan, [&](const Needs& needs) { return needs.fastest == fastest; });
  const double steps = std::max(least_steps, 1 / std::sqrt(scene.run.accuracy));
  plan.time_step = std::isfinite(fastest) ? fastest / steps : scene.run.duration / quiet_steps;
  if (!std::isfinite(fastest))
    plan.time_step_why = "nothing has a time of its own";
  else
    plan.time_step_why = std::to_string(static_cast<std::int64_t>(std::min(steps, 1e15))) +
                         " steps of the fastest: " + (who.empty() ? "spin" : who);
}

void check_masses(const Scene& scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& b = scene.bodies[i];
    const MassProperties one = mass_properties(b.body.shape);
    const double least = std::min(one.volume, one.inertia.minCoeff()) * b.density;
    const double greatest = std::max(one.volume, one.inertia.maxCoeff()) * b.density;
    if (least >= std::numeric_limits<double>::min() && greatest <= std::numeric_limits<double>::max()) continue;
    throw SceneError("bodies[" + std::to_string(i) + "]",
                     "its mass or moment of inertia is beyond the range of a double");
  }
}

/// Whole steps, rounded up. More than a machine could ever make are refused.
std::int64_t count_steps(double steps, const Scene& scene) {
  constexpr double most = 1e15;
  if (steps <= most) return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(steps)));
  throw SceneError(
      scene.run.time_step ? "run.time_step" : "run.duration",
      "takes more than 1e15 steps: shorten the run, or let the accuracy or the effects allow a longer step");
}

/// A step that is asked for is taken, and compared with the longest that the effects allow.
void ask_for_time_step(Plan& plan, double asked) {
  const double longest = plan.needs.fastest / least_steps;
  plan.time_step = asked;
  plan.time_step_why = asked_for;
  if (asked > longest) {
    const std::string times = std::to_string(static_cast<int>(std::min(asked / longest, 1e9)));
    plan.time_step_why += ", though " + times + " times as long as what the effects allow: expect it to diverge";
  }
}

void plan_time(Plan& plan, const Scene& scene) {
  if (plan.analysis != Analysis::motion) {
    plan.time_step_why = can_move(scene) ? "the duration is 0" : "every body is fixed";
    return;
  }
  const Run& run = scene.run;
  choose_time_step(plan, scene);
  if (run.time_step) ask_for_time_step(plan, *run.time_step);
  plan.time_step = std::min(plan.time_step, run.duration);
  const bool has_frames = !run.outputs.every_step && run.outputs.every > 0 && run.outputs.every < run.duration;
  const double period = has_frames ? run.outputs.every : run.duration;
  const std::int64_t steps_a_period = count_steps(period / plan.time_step * (1 - 1e-12), scene);
  if (has_frames) plan.steps_per_output = steps_a_period;
  if (!run.time_step) plan.time_step = period / static_cast<double>(steps_a_period);
  // None beyond the duration: what can_touch proves ends there.
  if (run.outputs.every_step) plan.steps_per_output = 1;
  plan.steps = count_steps(std::floor(run.duration / plan.time_step * (1 + 1e-12)), scene);
}

}  // namespace

bool Plan::is_on(std::string_view effect) const {
  return std::ranges::any_of(effects, [&](const PlannedEffect& p) { return p.is_on && p.effect->name == effect; });
}

bool Plan::has_turning() const {
  return std::ranges::find(turns, true) != turns.end();
}

Plan make_plan(const Scene& scene, const PlanOptions& options) {
  check_scene(scene);
  Plan plan;
  plan.analysis = analysis_of(scene);
  if (plan.analysis == Analysis::motion) check_masses(scene);
  plan.pair_effects = pair_effects(scene);
  plan.asked = effects_of_all(scene, plan.pair_effects);
  for (const std::string& name : options.forced) {
    const Effect* effect = find_effect(name);
    if (effect == nullptr) throw SceneError("effects." + name, "there is no such effect");
    effect->ask(plan.asked);
    for (Effects& of_pair : plan.pair_effects.of) effect->ask(of_pair);
  }
  Scene with_forced = scene;
  with_forced.effects = plan.asked;
  const bool bodies_can_touch = options.may_always_touch || can_touch(with_forced);
  for (const Effect& effect : effects()) {
    plan.effects.push_back(planned(effect, with_forced, plan, options, bodies_can_touch));
    add_needs(plan.needs, plan.effects.back().needs);
  }
  plan_contacts(plan, scene);
  plan_turning(plan, scene);
  plan_solver(plan, scene);
  plan_broad_phase(plan, scene);
  plan_time(plan, scene);
  return plan;
}

}  // namespace plumb::scene
