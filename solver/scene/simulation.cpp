#include "solver/scene/simulation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "solver/scene/body/rotation.hpp"
#include "solver/scene/body/world_setup.hpp"
#include "solver/scene/contact/narrow_phase.hpp"
#include "solver/scene/contact/neighbours.hpp"
#include "solver/scene/passes.hpp"
#include "solver/scene/threads.hpp"

namespace plumb::scene {
namespace {

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

void shift(World& world) {
  for (const std::uint32_t i : world.bodies.movable)
    world.state.position->vector(i) += world.time_step * world.state.velocity->vector(i);
}

void rotate_body(World& world, std::uint32_t i) {
  State& state = world.state;
  const Vec3<double> momentum = state.angular_momentum->vector(i);
  const Vec3<double>& inverse_inertia = world.bodies.inverse_inertia[i];
  const Eigen::Quaterniond q = rotated(state.orientation_of(i), momentum, inverse_inertia, world.time_step);
  std::ranges::copy(std::array{q.w(), q.x(), q.y(), q.z()}, state.orientation->entry(i).begin());
  state.angular_velocity->vector(i) = angular_velocity(q, momentum, inverse_inertia);
}

void rotate(World& world) {
  constexpr std::size_t worth_waking = 512;  // a tenth of a millisecond
  const std::vector<std::uint32_t>& turning = world.bodies.turning;
  for_each_part(turning.size(), worth_waking, world.threads, [&](std::size_t, std::size_t first, std::size_t end) {
    for (std::size_t k = first; k < end; ++k) rotate_body(world, turning[k]);
  });
}

void kick_half(World& world) {
  for (const std::uint32_t i : world.bodies.movable)
    world.state.velocity->vector(i) +=
        world.time_step / 2 * world.bodies.inverse_mass[i] * world.state.force->vector(i);
  for (const std::uint32_t i : world.bodies.turning)
    world.state.angular_momentum->vector(i) += world.time_step / 2 * world.state.torque->vector(i);
}

/// The places of pairs that two lists have, in both; the lists are sorted.
std::vector<std::array<std::size_t, 2>> kept_places(const Pairs& before, const Pairs& now) {
  std::vector<std::array<std::size_t, 2>> out;
  for (std::size_t old = 0, k = 0; old < before.size() && k < now.size();) {
    const auto order = before[old] <=> now[k];
    if (order == 0) out.push_back({old, k});
    old += order <= 0 ? 1 : 0;
    k += order >= 0 ? 1 : 0;
  }
  return out;
}

/// The columns of a new list, with what the old one knew of the same pairs.
void take_over(Columns& columns, const Pairs& before, const Pairs& now) {
  const std::vector<std::array<std::size_t, 2>> kept = kept_places(before, now);
  for (Column& column : columns) {
    if (column.kind().of != ColumnKind::pair) continue;
    Column next(column.name(), column.owner(), column.kind());
    next.renew(now.size());
    for (const auto& [old, k] : kept) std::ranges::copy(column.entry(old), next.entry(k).begin());
    column = std::move(next);
  }
}

/// A list of contacts as it is made: of bodies that are there, the second of higher index, sorted, each as often as it has places.
bool are_pairs(const Pairs& pairs, const Bodies& bodies) {
  for (std::size_t k = 0; k < pairs.size();) {
    const auto [i, j] = pairs[k];
    if (!(i < j && i < bodies.count && j < bodies.all()) || (k > 0 && pairs[k - 1] > pairs[k])) return false;
    const std::size_t places = bodies.places(j), first = k;
    while (k < pairs.size() && pairs[k] == pairs[first]) ++k;
    if (k - first != places) return false;
  }
  return true;
}

}  // namespace

Simulation::Simulation(const Scene& scene, Plan plan, int threads)
    : plan_(std::move(plan)), world_(std::make_unique<World>()) {
  world_->threads = threads;
  set_up(*world_, scene, plan_);
  if (plan_.needs.contacts && world_->boxes == nullptr) use_pairs(all_pairs(world_->bodies));
  list_passes();
  world_->time_step = 0;  // the forces at the start, to which no time has led
  run_all(forces_);
  world_->time_step = plan_.time_step;
}

Simulation::~Simulation() = default;

void Simulation::list_passes() {
  World& world = *world_;
  drifts_.push_back({"motion", [&world] { shift(world); }});
  if (world.has_turning()) drifts_.push_back({"turning", [&world] { rotate(world); }});
  append(drifts_, std::exchange(world.movers, {}));
  kicks_.push_back({"motion", [&world] { kick_half(world); }});
  if (world_->boxes != nullptr) forces_.push_back({"broad phase", [this] { update_list(); }});
  if (plan_.needs.contacts) forces_.push_back({"solver", [this] { solve(); }});
  if (plan_.analysis != Analysis::motion) return;
  if (plan_.needs.lives) forces_.push_back({"lives", [this] { ended_lives_ = scene::ended_lives(*world_); }});
  append(forces_, contact_stage(world, plan_));
  append(forces_, take_closing_passes(world));
  if (plan_.needs.lives) forces_.push_back({"lives", [&world] { follow_lives(world); }});
}

void Simulation::use_pairs(Pairs pairs) {
  take_over(world_->columns, world_->contacts.pairs, pairs);
  world_->contacts.pairs = std::move(pairs);
  ++totals_.lists;
}

void Simulation::update_list() {
  if (are_within(*world_, *world_->boxes)) return;
  fatten(*world_, *world_->boxes);
  use_pairs(meeting_pairs(*world_, *world_->boxes));
}

void Simulation::solve() {
  std::vector<SolveNote> notes;
  totals_ += solve_contacts(*world_, plan_.want, look_ ? &notes : nullptr);
  if (look_) look_(notes);
}

void Simulation::step() {
  run_all(kicks_);
  ++step_;
  world_->time = static_cast<double>(step_) * world_->time_step;
  run_all(drifts_);
  run_all(forces_);
  run_all(kicks_);
}

void Simulation::observe(std::function<void(std::span<const SolveNote>)> look) {
  look_ = std::move(look);
}

Pair Simulation::pair_of(std::size_t contact) const {
  return solver_pair(*world_, contact);
}

Snapshot Simulation::snapshot() const {
  Snapshot out{step_, totals_, world_->contacts.pairs, {}};
  for (const Column& column : world_->columns)
    if (column.kind().is_saved()) out.columns.emplace_back(column.name(), column.values());
  return out;
}

std::optional<Simulation::Misfit> Simulation::misfit(const Snapshot& snapshot) const {
  if (snapshot.step < 0 || snapshot.step > plan_.steps)
    return Misfit{"step", "must be from 0 to " + std::to_string(plan_.steps)};
  if (!are_pairs(snapshot.pairs, world_->bodies)) return Misfit{"pairs", "are none of the scene's bodies and walls"};
  std::set<std::string_view> kept;
  for (const auto& [name, values] : snapshot.columns) {
    const Column* column = world_->columns.find(name);
    const std::string field = "columns." + name;
    if (column == nullptr || !column->kind().is_saved()) return Misfit{field, "the scene keeps no such column"};
    if (!kept.insert(name).second) return Misfit{field, "stands twice"};
    const std::size_t entries = column->kind().of == ColumnKind::pair ? snapshot.pairs.size() : column->size();
    if (values.size() != entries * column->width())
      return Misfit{field, "has " + std::to_string(values.size()) + " numbers, and the scene " +
                               std::to_string(entries * column->width())};
  }
  for (const Column& column : world_->columns)
    if (column.kind().is_saved() && !kept.contains(column.name()))
      return Misfit{"columns." + std::string(column.name()), "missing"};
  return std::nullopt;
}

bool Simulation::restore(const Snapshot& snapshot) {
  if (misfit(snapshot)) return false;
  world_->contacts.pairs = snapshot.pairs;
  world_->columns.renew(ColumnKind::pair, snapshot.pairs.size());
  for (const auto& [name, values] : snapshot.columns) world_->columns.find(name)->values() = values;
  step_ = snapshot.step;
  totals_ = snapshot.totals;
  world_->time = static_cast<double>(step_) * world_->time_step;
  return true;
}

}  // namespace plumb::scene
