// Bodies, walls and runs that the tests of physics share.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>

#include "properties/generators/stream.hpp"
#include "solver/scene/body/mass.hpp"
#include "solver/scene/simulation.hpp"

namespace plumb::scene::made {

using Vec = Vec3<double>;

[[nodiscard]] inline SceneBody body(const Superellipsoid<double>& shape, const Vec& at,
                                    const Vec& velocity = Vec::Zero()) {
  SceneBody out;
  out.body.shape = shape;
  out.body.position = at;
  out.velocity = velocity;
  return out;
}

/// Of density 1.
[[nodiscard]] inline SceneBody ball(double radius, const Vec& at, const Vec& velocity = Vec::Zero()) {
  return body({Vec::Constant(radius)}, at, velocity);
}

[[nodiscard]] inline double mass(const SceneBody& b) {
  return b.density * mass_properties(b.body.shape).volume;
}

/// z = 0, bodies above.
[[nodiscard]] inline Wall floor_at(double z = 0) {
  return {Vec(0, 0, z), Vec::UnitZ(), {}};
}

[[nodiscard]] inline std::unique_ptr<Simulation> started(const Scene& scene, int threads = 1,
                                                         const PlanOptions& options = {}) {
  return std::make_unique<Simulation>(scene, make_plan(scene, options), threads);
}

[[nodiscard]] inline std::unique_ptr<Simulation> ended(const Scene& scene, int threads = 1) {
  auto run = started(scene, threads);
  while (!run->is_done()) run->step();
  return run;
}

[[nodiscard]] inline Vec position(const Simulation& run, std::size_t i) {
  return run.world().state.position->vector(i);
}

[[nodiscard]] inline Vec velocity(const Simulation& run, std::size_t i) {
  return run.world().state.velocity->vector(i);
}

[[nodiscard]] inline Vec spin(const Simulation& run, std::size_t i) {
  return run.world().state.angular_velocity->vector(i);
}

[[nodiscard]] inline double total_energy(const Simulation& run) {
  double sum = 0;
  for (const auto& [owner, energy] : run.energy()) sum += energy;
  return sum;
}

/// Of a measure; NaN where there is none.
[[nodiscard]] inline Eigen::Matrix3d matrix(const std::optional<Eigen::Matrix3d>& measure) {
  return measure.value_or(Eigen::Matrix3d::Constant(std::nan("")));
}

/// The field that the error of a scene's plan names, which gives a reason; empty where there is none.
[[nodiscard]] inline std::string refused_field(const Scene& scene) {
  try {
    (void)make_plan(scene);
  } catch (const SceneError& error) {
    return std::string(error.what()).empty() ? "no reason" : error.field;
  }
  return {};
}

/// A ball of radius 1 that rests on the floor under gravity g, pressed in as the linear force wants it.
struct Resting {
  static constexpr double g = 10, stiffness = 1e6;
  double weight = mass(ball(1, Vec::Zero())) * g;
  double overlap = weight / stiffness;
  double arm = 1 - overlap / 2;  ///< from the centre to the contact

  /// On a floor that slopes down along x.
  [[nodiscard]] Scene scene(double slope = 0) const {
    Scene out;
    out.bodies = {ball(1, {0, 0, 1 - overlap * std::cos(slope)})};
    out.walls = {floor_at()};
    out.effects.gravity = Gravity{{g * std::sin(slope), 0, -g * std::cos(slope)}};
    out.effects.linear = Linear{stiffness};
    return out;
  }
};

}  // namespace plumb::scene::made
