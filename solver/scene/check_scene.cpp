#include "solver/scene/check_scene.hpp"

#include <cmath>

namespace plumb::scene {
namespace {

void require(bool holds, const std::string& field, const char* reason) {
  if (!holds) throw SceneError(field, reason);
}

void check_body(const SceneBody& b, const std::string& at) {
  const Pair pair{b.body, b.body};
  if (!is_valid(pair)) {
    const InputError error = find_input_error(pair);
    throw SceneError(at + "." + std::string(error.field), std::string(error.reason));
  }
  require(std::isfinite(b.density) && b.density > 0, at + ".density", "must be a positive number");
  require(b.velocity.allFinite(), at + ".velocity", "must be finite numbers");
  require(b.angular_velocity.allFinite(), at + ".angular_velocity", "must be finite numbers");
  const char* const still = "a fixed body does not move";
  require(!b.is_fixed || b.velocity.isZero(0), at + ".velocity", still);
  require(!b.is_fixed || b.angular_velocity.isZero(0), at + ".angular_velocity", still);
}

/// A number or a vector of an effect, by its range.
struct FieldCheck {
  std::string at;

  void operator()(const char* name, double value, Range range) const {
    require(std::isfinite(value) && is_within(range, value), at + "." + name, words(range));
  }
  void operator()(const char* name, int value, Range range) const { (*this)(name, static_cast<double>(value), range); }
  void operator()(const char* name, const Vec3<double>& value, Range /*any*/) const {
    require(value.allFinite(), at + "." + name, "must be finite numbers");
  }
  void operator()(const char* name, const std::vector<WallMotion>& motions, Range /*any*/) const {
    for (std::size_t k = 0; k < motions.size(); ++k)
      WallMotion::each_field(motions[k], FieldCheck{at + "." + name + "[" + std::to_string(k) + "]"});
  }
};

void check_run(const Run& run) {
  require(std::isfinite(run.duration) && run.duration >= 0, "run.duration", "must be a number, 0 or more");
  require(run.accuracy > 0 && run.accuracy < 1, "run.accuracy", "must be a number between 0 and 1");
  require(!run.time_step || (std::isfinite(*run.time_step) && *run.time_step > 0), "run.time_step",
          "must be a positive number or auto");
  require(std::isfinite(run.outputs.every) && run.outputs.every >= 0, "run.outputs.every",
          "must be a number, 0 or more");
}

}  // namespace

void check_scene(const Scene& scene) {
  require(!scene.bodies.empty(), "bodies", "there is none");
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    check_body(scene.bodies[i], "bodies[" + std::to_string(i) + "]");
  for (std::size_t i = 0; i < scene.walls.size(); ++i) {
    const std::string at = "walls[" + std::to_string(i) + "]";
    require(scene.walls[i].point.allFinite(), at + ".point", "must be finite numbers");
    const Vec3<double>& normal = scene.walls[i].normal;
    require(normal.allFinite() && normal.norm() > 0, at + ".normal", "must be finite numbers, not all 0");
  }
  each_effect(scene.effects, [](const auto& effect) {
    if (!effect) return;
    using Parameters = typename std::remove_cvref_t<decltype(effect)>::value_type;
    Parameters::each_field(*effect, FieldCheck{"effects." + std::string(Parameters::name)});
  });
  check_run(scene.run);
}

}  // namespace plumb::scene
