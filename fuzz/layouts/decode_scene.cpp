#include "fuzz/layouts/decode_scene.hpp"

#include <algorithm>
#include <cmath>

#include "fuzz/layouts/decode.hpp"
#include "fuzz/layouts/layout_fields.hpp"
#include "solver/pose.hpp"
#include "solver/scene/plan.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::scene {
namespace {

using layout::Bytes;
using layout::pick;
using layout::read;
using Vec = Vec3<long double>;

constexpr std::size_t kEffects = 12, kMaterials = 112, kPeriodicBox = 118, kFirstBody = 120, kSceneBodySize = 48,
                      kFirstWall = 408, kWallSize = 16;

constexpr std::array<double, 16> kParameters{0,   1,    10,   100,  1e3,   1e4, 1e5, 0.5,
                                             0.1, 1e-2, 1e-3, 1e-6, 1e-12, 2,   0.3, 1e6};
constexpr std::array<double, 16> kFractions{0.5, 1,    0,    0.9,  0.1,       0.3,         1e-3, 0.99,
                                            0.8, 1e-2, 1e-6, 1e-9, 1 - 1e-12, 1 - 0x1p-53, 0.7,  0.2};
constexpr std::array<double, 16> kSpeeds{0, 1, 0.1, 10, 1e-2, 1e-3, 0.5, 2, 5, 20, 50, 100, 1e-6, 1e-9, 1e-12, 3};
constexpr std::array<double, 16> kDensities{1, 2, 0.5, 10, 0.1, 100, 1e-2, 1e3, 1e-3, 3, 5, 7, 0.3, 0.2, 20, 50};
constexpr std::array<double, 16> kDurations{1, 0.1, 10, 1e-2, 1e-3, 100, 1e-4, 0.5, 2, 5, 0.2, 0.3, 20, 50, 3, 0.7};

constexpr std::array<double, 4> kTiltRatios{1, 1.4, 8.0 / 3, 0};
constexpr std::array<double, 4> kRates{0, 1, 100, 0.1}, kPulls{1, 0, 0.5, 0.9}, kStiffnesses{0, 1, 1e3, 0.1},
    kShares{0, 1, 0.5, 3};

/// What effects have had since the layout was fixed: drawn from bytes that were unused.
struct LaterField {
  std::string_view effect, name;
};
constexpr std::array<LaterField, 6> kLaterFields{{{"foundation", "tilt_ratio"},
                                                  {"damping", "mass_velocity"},
                                                  {"damping", "viscoelastic"},
                                                  {"damping", "pull"},
                                                  {"friction", "stiffness"},
                                                  {"friction", "normal_share"}}};

/// Numbers one after the other.
class Cursor {
 public:
  Cursor(Bytes bytes, std::size_t at) : bytes_(bytes), at_(at) {}
  std::uint32_t next() {
    const std::uint32_t v = read(bytes_, at_, 2);
    at_ += 2;
    return v;
  }

 private:
  Bytes bytes_;
  std::size_t at_;
};

double in_range(std::uint32_t v, Range range) {
  switch (range) {
    case Range::any:
    case Range::not_negative: return pick(v, kParameters, 1e-6, 1e6);
    case Range::positive: return std::max(pick(v, kParameters, 1e-6, 1e6), 1e-12);
    case Range::fraction: return pick(v, kFractions, 1e-6, 1);
    case Range::restitution: return std::max(pick(v, kFractions, 1e-6, 1), 1e-12);
    case Range::poissons_ratio: return pick(v, kFractions, 1e-6, 1) / 2;
    case Range::one_to_two: return 1 + pick(v, kFractions, 1e-6, 1);
  }
  return 0;
}

/// Fills the fields of an effect, but for later ones.
struct FillField {
  std::string_view effect;
  Cursor& numbers;
  std::size_t walls;

  void operator()(std::string_view name, double& value, Range range) const {
    const bool is_later = std::ranges::any_of(
        kLaterFields, [&](const LaterField& later) { return later.effect == effect && later.name == name; });
    if (!is_later) value = in_range(numbers.next(), range);
  }
  void operator()(std::string_view /*name*/, int& /*the motion's own wall*/, Range /*range*/) const {}
  void operator()(std::string_view name, Vec3<double>& value, Range range) const {
    if (name == "angular_velocity" || name == "pivot") return;
    for (double& x : value) {
      const std::uint32_t v = numbers.next();
      x = (v & 1) != 0 ? -in_range(v, range) : in_range(v, range);
    }
  }
  void operator()(std::string_view /*name*/, std::vector<WallMotion>& motions, Range /*range*/) const {
    for (std::size_t k = 0; k < walls; ++k) {
      WallMotion::each_field(motions.emplace_back(), *this);
      motions.back().wall = static_cast<int>(k);
    }
  }
};

void drop_what_needs_elastic_force(Effects& effects) {
  effects.damping.reset();
  effects.friction.reset();
  effects.rolling.reset();
  effects.twisting.reset();
  effects.cohesion.reset();
  effects.dmt.reset();
}

/// Linear before volume before foundation before hertz, and what needs one where there is one.
void keep_one_elastic_law(Effects& effects) {
  if (effects.linear) effects.volume.reset();
  if (effects.linear || effects.volume) effects.foundation.reset();
  if (effects.linear || effects.volume || effects.foundation) effects.hertz.reset();
  if (!effects.linear && !effects.volume && !effects.foundation && !effects.hertz)
    drop_what_needs_elastic_force(effects);
  const double elastic = effects.linear       ? effects.linear->stiffness
                         : effects.volume     ? effects.volume->stiffness
                         : effects.foundation ? effects.foundation->stiffness
                                              : effects.hertz.value_or(Hertz{}).youngs_modulus;
  if (elastic == 0) effects.cohesion.reset(), effects.dmt.reset();
  if (elastic == 0 || !effects.hertz) effects.jkr.reset();
}

void fill_later(Bytes bytes, Effects& effects) {
  const std::uint32_t dashpots = read(bytes, kFirstWall + 14, 1), across = read(bytes, kFirstWall + 15, 1);
  if (effects.foundation) effects.foundation->tilt_ratio = kTiltRatios[read(bytes, kPeriodicBox, 1) >> 6];
  if (effects.damping) {
    effects.damping->mass_velocity = kRates[dashpots & 3];
    effects.damping->viscoelastic = kRates[dashpots >> 2 & 3];
    effects.damping->pull = kPulls[dashpots >> 4 & 3];
  }
  if (effects.friction) {
    effects.friction->stiffness = kStiffnesses[across & 3];
    effects.friction->normal_share = kShares[across >> 2 & 3];
  }
}

Effects read_scene_effects(Bytes bytes, std::size_t walls) {
  Effects effects;
  Cursor numbers(bytes, kEffects);
  std::uint32_t asked = read(bytes, 8, 2);
  const auto fill = [&](auto& slot) {
    auto& parameters = slot.emplace();
    using Parameters = std::remove_cvref_t<decltype(parameters)>;
    Parameters::each_field(parameters, FillField{Parameters::name, numbers, walls});
    if ((asked & 1) == 0) slot.reset();
    asked >>= 1;
  };
  each_effect(effects, [&](auto& slot) {
    using Slot = std::remove_cvref_t<decltype(slot)>;
    constexpr bool is_new = std::is_same_v<Slot, std::optional<Volume>> ||
                            std::is_same_v<Slot, std::optional<Foundation>> ||
                            std::is_same_v<Slot, std::optional<Dmt>> || std::is_same_v<Slot, std::optional<Jkr>> ||
                            std::is_same_v<Slot, std::optional<PeriodicBox>>;
    if constexpr (!is_new) fill(slot);
  });
  fill(effects.volume);
  fill(effects.foundation);
  fill_later(bytes, effects);
  fill(effects.dmt);
  fill(effects.jkr);
  keep_one_elastic_law(effects);
  return effects;
}

Vec line_at(Bytes bytes, std::size_t at) {
  const auto [cz, sz] = layout::cos_sin_deg(layout::angle(bytes, at));
  const auto [ca, sa] = layout::cos_sin_deg(layout::angle(bytes, at + 4));
  return {sz * ca, sz * sa, cz};
}

long double overlap_ratio(std::uint32_t mode, std::uint32_t v) {
  switch (mode % 4) {
    case 0: return layout::log_magnitude(v);
    case 1: return -layout::log_magnitude(v);
    case 2: return 0;
    default: return 0.05L;
  }
}

/// Beside one of the bodies before it, and on the way along the line to it.
SceneBody read_scene_body(Bytes bytes, std::size_t at, std::span<const SceneBody> before) {
  SceneBody out;
  out.body.shape = layout::read_shape(bytes, at, before.empty() ? nullptr : &before.front().body.shape);
  out.body.quaternion = layout::read_quaternion(bytes, at);
  out.density = pick(read(bytes, at + 44, 2), kDensities, 1e-3, 1e3);
  out.temperature = 250 + read(bytes, at + 46, 1);
  const Vec line = line_at(bytes, at + 28);
  const std::uint32_t flags = read(bytes, at + 37, 1), axis = flags >> 4 & 3;
  if (!before.empty()) {
    const Body& neighbour = before[read(bytes, at + 36, 1) % before.size()].body;
    const long double ratio = overlap_ratio(flags >> 1, read(bytes, at + 38, 2));
    const long double distance = touching_distance({neighbour, out.body}, line) * (1 - ratio);
    out.body.position = (neighbour.position.cast<long double>() + distance * line).cast<double>();
    out.is_fixed = (flags & 1) != 0;
  }
  if (out.is_fixed) return out;
  const double speed = pick(read(bytes, at + 40, 2), kSpeeds, 1e-4, 1e2);
  out.velocity = ((flags >> 3 & 1) != 0 ? speed : -speed) * line.cast<double>();
  const Vec about = axis == 3 ? line : Vec(rotation<long double>(out.body.quaternion).col(axis));
  out.angular_velocity = pick(read(bytes, at + 42, 2), kSpeeds, 1e-4, 1e2) * about.cast<double>();
  return out;
}

Wall read_scene_wall(Bytes bytes, std::size_t at, std::span<const SceneBody> bodies) {
  const Vec normal = line_at(bytes, at);
  const Body& body = bodies[read(bytes, at + 10, 1) % bodies.size()].body;
  const std::uint32_t flags = read(bytes, at + 11, 1);
  const long double ratio = overlap_ratio(flags & 3, read(bytes, at + 8, 2));
  Wall out;
  out.normal = normal.cast<double>();
  out.point = (body.position.cast<long double>() - reach(body, -normal) * (1 - ratio) * normal).cast<double>();
  out.temperature = 250 + read(bytes, at + 12, 1);
  return out;
}

/// What differs from the scene's effects: only where these have what it needs.
Material read_material(Bytes bytes, std::size_t index, const Effects& effects) {
  const std::size_t at = kMaterials + 2 * index;
  const std::uint32_t flags = read(bytes, at, 1), number = read(bytes, at + 1, 1);
  const bool has_law = effects.linear || effects.hertz || effects.volume || effects.foundation;
  constexpr std::array<double, 4> factors{2, 10, 0.1, 1};
  const double factor = factors[flags >> 4 & 3];
  Material out{.name = {static_cast<char>('a' + index)}, .density = {}, .is_rigid = false, .effects = {}};
  if (!has_law) return out;
  if ((flags & 1) != 0) out.effects.friction = Friction{.coefficient = kFractions[number % kFractions.size()]};
  if ((flags >> 1 & 1) != 0) out.effects.damping = Damping{std::max(kFractions[number / kFractions.size()], 1e-12)};
  if ((flags >> 2 & 1) == 0) return out;
  out.effects.linear = effects.linear;
  out.effects.hertz = effects.hertz;
  if (out.effects.linear) out.effects.linear->stiffness *= factor;
  if (out.effects.hertz) out.effects.hertz->youngs_modulus *= factor;
  return out;
}

void read_materials(Scene& scene, Bytes bytes) {
  const std::size_t count = read(bytes, 11, 1) % 4;
  for (std::size_t k = 0; k < count; ++k) scene.materials.push_back(read_material(bytes, k, scene.effects));
  for (std::size_t k = 0; k < scene.bodies.size() && count > 0; ++k)
    scene.bodies[k].material = read(bytes, kFirstBody + k * kSceneBodySize + 47, 1) % count;
  for (std::size_t k = 0; k < scene.walls.size() && count > 0; ++k)
    scene.walls[k].material = read(bytes, kFirstWall + k * kWallSize + 13, 1) % count;
}

/// `duration`: no run is longer.
void read_periodic_box(Scene& scene, Bytes bytes, double duration) {
  const std::uint32_t flags = read(bytes, kPeriodicBox, 1), changes = flags >> 3 & 3;
  if ((flags & 7) == 0 || !scene.walls.empty()) return;
  const double shortest = shortest_side(scene);
  const double side = shortest * (1 + read(bytes, kPeriodicBox + 1, 1) / 64.0);
  const double rate = (changes == 1 ? -0.5 : 0.5) * (side - shortest) / duration;
  const bool has_rate = changes != 0 && std::ranges::none_of(scene.bodies, &SceneBody::is_fixed);
  PeriodicBox& box = scene.effects.periodic_box.emplace();
  for (int axis = 0; axis < 3; ++axis) {
    if ((flags >> axis & 1) == 0) continue;
    box.sides[axis] = side;
    if (has_rate) box.rate[axis] = rate;
  }
  if ((flags >> 5 & 1) != 0 && (flags & 7) == 7 && rate < 0 && has_rate) box.pressure = 1;
}

/// So many steps, none longer than the effects allow.
void set_time(Scene& scene, Bytes bytes) {
  constexpr double longest_share = 8;  // of the fastest thing that happens, as plan.cpp has it
  constexpr std::array<double, 3> parts{1, 4, 32};
  const double steps = 2 + read(bytes, 2, 1) % 31;
  scene.run.accuracy = std::pow(10.0, -1.0 - read(bytes, 10, 1) % 8);
  scene.run.duration = pick(read(bytes, 6, 2), kDurations, 1e-4, 1e2);
  read_periodic_box(scene, bytes, scene.run.duration);
  scene.run.time_step = scene.run.duration / steps;
  const double longest = make_plan(scene).needs.fastest / longest_share / parts[read(bytes, 5, 1) % 3];
  scene.run.time_step = std::min(*scene.run.time_step, longest);
  scene.run.duration = *scene.run.time_step * steps;
}

bool can_be_forced(const Scene& scene, std::string_view effect) {
  PlanOptions options;
  options.forced.emplace(effect);
  try {
    return make_plan(scene, options).is_on(effect);
  } catch (const SceneError&) {
    return false;
  }
}

std::string read_forced(const Scene& scene, Bytes bytes) {
  constexpr std::uint32_t the_box = 255;
  std::vector<std::string> off;
  const Plan plan = make_plan(scene);
  if (read(bytes, 3, 1) == the_box && !plan.is_on(PeriodicBox::name)) return std::string(PeriodicBox::name);
  for (const Effect& effect : effects())
    if (effect.name != PeriodicBox::name && !plan.is_on(effect.name) && can_be_forced(scene, effect.name))
      off.emplace_back(effect.name);
  return off.empty() ? "" : off[read(bytes, 3, 1) % off.size()];
}

bool has_patches(const Scene& scene, std::string_view forced) {
  return scene.effects.volume || scene.effects.foundation || forced == Volume::name || forced == Foundation::name;
}

/// A patch costs a hundred times its contact.
void shorten(Run& run) {
  constexpr double most_steps = 8;
  run.duration = std::min(run.duration, most_steps * run.time_step.value_or(0));
}

}  // namespace

SceneRecipe decode_scene(Bytes bytes) {
  Scene scene;
  scene.name = "decoded bytes";
  const std::size_t bodies = 2 + read(bytes, 0, 1) % 5, walls = read(bytes, 1, 1) % 4;
  for (std::size_t k = 0; k < bodies; ++k)
    scene.bodies.push_back(read_scene_body(bytes, kFirstBody + k * kSceneBodySize, scene.bodies));
  for (std::size_t k = 0; k < walls; ++k)
    scene.walls.push_back(read_scene_wall(bytes, kFirstWall + k * kWallSize, scene.bodies));
  scene.effects = read_scene_effects(bytes, walls);
  read_materials(scene, bytes);
  set_time(scene, bytes);
  std::string forced = read_forced(scene, bytes);
  if (has_patches(scene, forced)) shorten(scene.run);
  const std::int64_t steps = make_plan(scene).steps;
  return {std::move(scene), std::move(forced), static_cast<std::int64_t>(read(bytes, 4, 1)) % steps};
}

}  // namespace plumb::scene
