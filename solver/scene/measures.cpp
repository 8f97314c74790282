// What is asked of a simulation beside its steps: sums over bodies, hashes, costs.
#include <Eigen/Geometry>
#include <cmath>

#include "solver/scene/body/world_setup.hpp"
#include "solver/scene/simulation.hpp"

namespace plumb::scene {
namespace {

double kinetic_energy(const World& world) {
  double sum = 0;
  for (const std::uint32_t i : world.bodies.movable)
    sum += world.bodies.mass[i] * world.state.velocity->vector(i).squaredNorm() / 2;
  for (const std::uint32_t i : world.bodies.turning) {
    const Vec3<double> momentum = world.state.angular_momentum->vector(i);
    const Vec3<double> own = world.state.orientation_of(i).conjugate() * momentum;
    sum += own.cwiseAbs2().dot(world.bodies.inverse_inertia[i]) / 2;
  }
  return sum;
}

std::uint64_t hash_of_pairs(const Contacts& contacts) {
  std::vector<double> indices;
  for (const auto& [i, j] : contacts.pairs)
    indices.insert(indices.end(), {static_cast<double>(i), static_cast<double>(j)});
  return hash_of(indices);
}

}  // namespace

std::map<std::string, double> Simulation::energy() const {
  std::map<std::string, double> out;
  if (plan_.analysis != Analysis::motion) return out;
  out["kinetic"] = kinetic_energy(*world_);
  for (const StoredEnergy& stored : world_->energies) out[std::string(stored.owner)] += stored.energy();
  return out;
}

Vec3<double> Simulation::momentum() const {
  Vec3<double> sum = Vec3<double>::Zero();
  for (const std::uint32_t i : world_->bodies.movable)
    sum += world_->bodies.mass[i] * world_->state.velocity->vector(i);
  return sum;
}

Vec3<double> Simulation::angular_momentum() const {
  Vec3<double> sum = Vec3<double>::Zero();
  const State& state = world_->state;
  for (const std::uint32_t i : world_->bodies.movable)
    sum += world_->bodies.mass[i] * state.position->vector(i).cross(state.velocity->vector(i));
  for (const std::uint32_t i : world_->bodies.turning) sum += state.angular_momentum->vector(i);
  return sum;
}

std::map<std::string, std::uint64_t> Simulation::hashes() const {
  std::map<std::string, std::uint64_t> out;
  for (const Column& column : world_->columns)
    if (column.kind().is_kept) out[std::string(column.name())] = hash_of(column.values());
  if (plan_.needs.contacts) out["pairs"] = hash_of_pairs(world_->contacts);
  return out;
}

std::uint64_t Simulation::hash() const {
  std::vector<double> parts{static_cast<double>(step_)};
  for (const auto& [name, hash] : hashes())
    for (const std::uint64_t half : {hash >> 32U, hash & 0xffffffffU}) parts.push_back(static_cast<double>(half));
  return hash_of(parts);
}

std::map<std::string, double> Simulation::seconds() const {
  std::map<std::string, double> out;
  for (const auto* passes : {&kicks_, &drifts_, &forces_})
    for (const Pass& pass : *passes) out[std::string(pass.owner)] += std::chrono::duration<double>(pass.spent).count();
  for (const ContactPass& pass : world_->contact_passes) {
    out[std::string(pass.owner)] += pass.seconds;
    out["contacts"] -= pass.seconds;  // whose pass runs them
  }
  return out;
}

std::map<std::string, Memory> memory_of(const Scene& scene, const Plan& plan) {
  World world;
  set_up(world, scene, plan);
  std::map<std::string, Memory> out;
  for (const Column& column : world.columns) {
    Memory& of_owner = out[std::string(column.owner())];
    if (column.kind().of == ColumnKind::scene) continue;
    (column.kind().of == ColumnKind::body ? of_owner.body : of_owner.pair) += column.width() * sizeof(double);
  }
  return out;
}

std::vector<Life> Simulation::lasting_lives() const {
  return plan_.needs.lives ? scene::lasting_lives(*world_) : std::vector<Life>{};
}

std::optional<std::size_t> Simulation::lost_body() const {
  const State& state = world_->state;
  for (std::size_t i = 0; i < world_->bodies.count; ++i) {
    const bool is_placed = state.position->vector(i).allFinite() && std::isfinite(state.orientation->entry(i)[0]);
    if (!is_placed || (state.velocity != nullptr && !state.velocity->vector(i).allFinite())) return i;
  }
  return std::nullopt;
}

}  // namespace plumb::scene
