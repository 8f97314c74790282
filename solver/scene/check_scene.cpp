#include "solver/scene/check_scene.hpp"

#include <algorithm>
#include <cmath>

#include "solver/scene/material/mixing.hpp"

namespace plumb::scene {
namespace {

void require(bool holds, const std::string& field, const char* reason) {
  if (!holds) throw SceneError(field, reason);
}

const char* const no_material = "there is no such material";

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

void check_effects(const Effects& effects, const std::string& at) {
  each_effect(effects, [&](const auto& effect) {
    if (!effect) return;
    using Parameters = typename std::remove_cvref_t<decltype(effect)>::value_type;
    Parameters::each_field(*effect, FieldCheck{at + "." + std::string(Parameters::name)});
  });
}

void check_material(const Material& material) {
  const std::string at = "materials." + material.name;
  check_effects(material.effects, at);
  const auto& density = material.density;
  require(!density || (std::isfinite(*density) && *density > 0), at + ".density", "must be a positive number");
  const char* const no_law = "is rigid, and has no elastic law of its own";
  require(!material.is_rigid || !material.effects.linear, at + ".linear", no_law);
  require(!material.is_rigid || !material.effects.hertz, at + ".hertz", no_law);
}

void check_materials(const Scene& scene) {
  for (const Material& material : scene.materials) check_material(material);
  for (std::size_t k = 0; k < scene.material_pairs.size(); ++k) {
    const MaterialPair& pair = scene.material_pairs[k];
    const std::string at = "materials.pairs[" + std::to_string(k) + "]";
    const auto [first, second] = pair.between;
    require(first < scene.materials.size() && second < scene.materials.size(), at + ".between", no_material);
    require(given_pair(scene, first, second) == &pair, at + ".between", "stands twice");
    check_effects(pair.effects, at);
  }
}

void check_region(const Region& region, bool has_bulk) {
  const char* const at = "run.outputs.region";
  require(has_bulk, at, "is of the output bulk, which is not asked for");
  require(region.low.allFinite() && region.high.allFinite(), at, "must be finite numbers");
  require((region.low.array() < region.high.array()).all(), at, "low must be below high along each axis");
}

constexpr const char* a_length = "must be a positive number";

bool is_length(double x) {
  return std::isfinite(x) && x > 0;
}

/// What a wall of each kind is made of.
struct ShapeCheck {
  std::string at;

  void operator()(const PlaneWall& /*plane*/) const {}
  void operator()(const MeshWall& wall) const {
    require(wall.mesh != nullptr, at + ".mesh", "has no triangles");
    require(wall.smooth_deg >= 0 && wall.smooth_deg < 90, at + ".mesh.smooth_deg",
            "must be a number from 0 to below 90");
  }
  void operator()(const CylinderWall& wall) const {
    require(is_length(wall.radius), at + ".cylinder.radius", a_length);
    require(is_length(wall.half_length), at + ".cylinder.half_length", a_length);
  }
  void operator()(const ConeWall& wall) const {
    for (const std::size_t k : {0, 1})
      require(std::isfinite(wall.radii[k]) && wall.radii[k] >= 0, at + ".cone.radii[" + std::to_string(k) + "]",
              "must be a number, 0 or more");
    require(wall.radii[0] + wall.radii[1] > 0, at + ".cone.radii", "are both 0");
    require(is_length(wall.height), at + ".cone.height", a_length);
  }
  void operator()(const BoxWall& wall) const {
    for (int k = 0; k < 3; ++k)
      require(is_length(wall.half_extents[k]), at + ".box.half_extents[" + std::to_string(k) + "]", a_length);
  }
};

void check_wall(const Wall& wall, const std::string& at) {
  std::visit(ShapeCheck{at}, wall.shape);
  const auto is_zero = [](double x) { return x == 0; };
  const bool is_finite = std::ranges::all_of(wall.quaternion, [](double x) { return std::isfinite(x); });
  require(is_finite && !std::ranges::all_of(wall.quaternion, is_zero), at + ".orientation",
          "must be finite numbers, not all 0");
  const bool is_normal = wall.normal.allFinite() && wall.normal.norm() > 0;
  require(!wall.is_plane() || is_normal, at + ".normal", "must be finite numbers, not all 0");
}

void check_run(const Run& run) {
  require(std::isfinite(run.duration) && run.duration >= 0, "run.duration", "must be a number, 0 or more");
  require(run.accuracy > 0 && run.accuracy < 1, "run.accuracy", "must be a number between 0 and 1");
  require(!run.time_step || (std::isfinite(*run.time_step) && *run.time_step > 0), "run.time_step",
          "must be a positive number or auto");
  require(std::isfinite(run.outputs.every) && run.outputs.every >= 0, "run.outputs.every",
          "must be a number, 0 or more");
  if (run.outputs.region) check_region(*run.outputs.region, run.outputs.bulk);
}

}  // namespace

void check_scene(const Scene& scene) {
  check_materials(scene);
  require(!scene.bodies.empty(), "bodies", "there is none");
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    check_body(scene.bodies[i], "bodies[" + std::to_string(i) + "]");
  const std::size_t materials = std::max<std::size_t>(1, scene.materials.size());
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    require(scene.bodies[i].material < materials, "bodies[" + std::to_string(i) + "].material", no_material);
  for (std::size_t i = 0; i < scene.walls.size(); ++i) {
    const std::string at = "walls[" + std::to_string(i) + "]";
    require(scene.walls[i].point.allFinite(), at + ".point", "must be finite numbers");
    require(scene.walls[i].material < materials, at + ".material", no_material);
    check_wall(scene.walls[i], at);
  }
  check_effects(scene.effects, "effects");
  check_run(scene.run);
}

}  // namespace plumb::scene
