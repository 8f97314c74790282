#include "solver/scene/part.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/scene/body/rotation.hpp"
#include "solver/scene/body/world_setup.hpp"
#include "solver/scene/check_scene.hpp"
#include "solver/scene/facts.hpp"
#include "solver/scene/passes.hpp"

namespace plumb::scene {
namespace {

/// Bodies that touch each other and turn.
void add_bodies(Scene& scene, std::size_t material, std::size_t movable, std::size_t fixed) {
  for (std::size_t i = 0; i < movable + fixed; ++i) {
    SceneBody body;
    body.body.shape = {{1, 1, 2}, 2, 2};
    body.body.position = (scene.bodies.size() % 2 == 0 ? 0 : 1) * Vec3<double>::UnitX();
    body.is_fixed = i >= movable;
    if (!body.is_fixed) body.angular_velocity = Vec3<double>::UnitX();
    body.material = material;
    scene.bodies.push_back(body);
  }
}

/// As few as tell which materials meet: of each two that move, as more may come, and one that does not. Only of a rigid one, which may not meet
/// itself, no more than there are.
void add_bodies(Scene& scene, const std::vector<PartMaterial>& materials) {
  const bool has_any = std::ranges::any_of(materials, [](const PartMaterial& m) { return m.movable + m.fixed > 0; });
  for (std::size_t k = 0; k < materials.size(); ++k) {
    const PartMaterial& m = materials[k];
    const std::size_t two = 2, one = 1, movable = m.material.is_rigid ? std::min(m.movable, two) : two;
    add_bodies(scene, k, m.movable > 0 || !has_any ? movable : 0, std::min(m.fixed, one));
    scene.materials.push_back(m.material);
  }
}

/// A scene with the effects, materials and walls asked for: from it follows all that a plan says of a part.
Scene probe_of(const PartSettings& settings) {
  Scene scene;
  if (settings.materials.empty())
    add_bodies(scene, 0, 2, 0);
  else
    add_bodies(scene, settings.materials);
  scene.walls = settings.walls;
  scene.material_pairs = settings.material_pairs;
  scene.effects = settings.effects;
  scene.run.duration = settings.time_step;
  scene.run.time_step = settings.time_step;
  scene.run.accuracy = settings.accuracy;
  return scene;
}

/// The scene's, and what only some pairs of materials have.
Scene with_effects_of_all(const Scene& scene) {
  check_scene(scene);
  Scene out = scene;
  out.effects = effects_of_all(scene, pair_effects(scene));
  return out;
}

/// Whatever is asked for is on: of bodies to come nothing can be proved. But two materials have the law that is theirs.
PlanOptions all_of(const Scene& probe) {
  PlanOptions options;
  options.may_always_touch = true;
  const Effects effects = with_effects_of_all(probe).effects;
  each_effect(effects, [&](const auto& effect) {
    using Parameters = typename std::remove_cvref_t<decltype(effect)>::value_type;
    if (effect && (probe.materials.empty() || !IsElastic<Parameters>)) options.forced.emplace(Parameters::name);
  });
  return options;
}

Scene checked(Scene probe) {
  if (probe.effects.conduction)
    throw SceneError("effects.conduction", "a part of a scene keeps no temperatures: run the scene by itself");
  if (probe.effects.periodic_box)
    throw SceneError("effects.periodic_box", "a part of a scene has no box of its own: it is the engine's");
  if (elastic_laws(with_effects_of_all(probe)) == 0)
    throw SceneError("effects", std::string("an elastic law is required: ") + names_of_elastic_laws);
  return probe;
}

bool is_same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace

Part::Part(const PartSettings& settings)
    : probe_(checked(probe_of(settings))), plan_(make_plan(probe_, all_of(probe_))) {
  plan_.broad_phase = BroadPhase::none;
  add_columns(world_, plan_);
  contact_forces_ = &world_.columns.add("contact_force", "contacts", {.of = ColumnKind::pair, .width = 3});
  movers_ = std::exchange(world_.movers, {});
  contacts_ = contact_stage(world_, plan_);
  closing_ = take_closing_passes(world_);
  for (Column& column : world_.columns)
    if (column.kind().of == ColumnKind::pair && column.kind().is_kept) kept_.push_back(&column);
  for (const Column* column : kept_) width_ += column->width();
}

void Part::renew(std::span<const SceneBody> bodies, std::vector<std::array<std::uint32_t, 2>> pairs) {
  world_.bodies = {};
  world_.bodies.count = bodies.size();
  for (const SceneBody& b : bodies) add_body(world_.bodies, b, !b.is_fixed);
  for (const Wall& wall : probe_.walls) add_wall(world_.bodies, wall);
  world_.columns.renew(ColumnKind::body, world_.bodies.all());
  world_.columns.renew(ColumnKind::pair, pairs.size());
  world_.contacts.pairs = std::move(pairs);
  for (auto* list : {&world_.contacts.touching, &world_.contacts.pressing, &world_.contacts.parted}) list->clear();
  for (std::size_t i = 0; i < probe_.walls.size(); ++i) set_wall(world_, i, probe_.walls[i]);
  for (const auto& start : world_.starts) start(probe_);
}

void Part::place(std::size_t body, const Vec3<double>& position, const Vec3<double>& velocity,
                 const std::array<double, 4>& quaternion, const Vec3<double>& angular_momentum) {
  State& state = world_.state;
  state.position->vector(body) = position;
  state.velocity->vector(body) = velocity;
  std::ranges::copy(quaternion, state.orientation->entry(body).begin());
  state.angular_momentum->vector(body) = angular_momentum;
  state.angular_velocity->vector(body) =
      angular_velocity(state.orientation_of(body), angular_momentum, world_.bodies.inverse_inertia[body]);
}

void Part::press(double time, double time_step) {
  world_.time = time;
  world_.time_step = time_step;
  run_all(movers_);
  totals_ += solve_contacts(world_, plan_.want, nullptr);
  run_all(contacts_);
}

void Part::close() {
  run_all(closing_);
}

double Part::stored_energy() const {
  double sum = 0;
  for (const StoredEnergy& stored : world_.energies)
    if (stored.owner != Gravity::name) sum += stored.energy();
  return sum;
}

double Part::energy(const std::function<bool(std::size_t contact)>& counts) {
  Contacts& contacts = world_.contacts;
  const auto touching = contacts.touching, pressing = contacts.pressing;
  for (auto* list : {&contacts.touching, &contacts.pressing})
    std::erase_if(*list, [&](std::uint32_t contact) { return !counts(contact); });
  const double sum = stored_energy();
  contacts.touching = touching;
  contacts.pressing = pressing;
  return sum;
}

std::vector<double> Part::energies() {
  Contacts& contacts = world_.contacts;
  const auto touching = std::exchange(contacts.touching, {}), pressing = std::exchange(contacts.pressing, {});
  std::vector<double> out(contacts.pairs.size());
  for (const std::uint32_t contact : touching) {
    contacts.touching = {contact};
    contacts.pressing.assign(std::ranges::binary_search(pressing, contact) ? 1 : 0, contact);
    out[contact] = stored_energy();
  }
  contacts.touching = touching;
  contacts.pressing = pressing;
  return out;
}

std::string Part::history_names() const {
  std::string names;
  for (const Column* column : kept_)
    names += std::string(column->name()) + ":" + std::to_string(column->kind().width) + " ";
  return names;
}

bool Part::has_history(std::size_t contact) const {
  return std::ranges::any_of(kept_, [&](const Column* column) {
    return std::ranges::any_of(std::as_const(*column).entry(contact),
                               [&](double value) { return !is_same(value, column->kind().initial); });
  });
}

void Part::history(std::size_t contact, std::span<double> out) const {
  auto next = out.begin();
  for (const Column* column : kept_) next = std::ranges::copy(column->entry(contact), next).out;
}

void Part::set_history(std::size_t contact, std::span<const double> values) {
  auto next = values.begin();
  for (Column* column : kept_) {
    const auto end = next + static_cast<std::ptrdiff_t>(column->width());
    std::copy(next, end, column->entry(contact).begin());
    next = end;
  }
}

}  // namespace plumb::scene
