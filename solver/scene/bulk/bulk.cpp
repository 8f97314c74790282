#include "solver/scene/bulk/bulk.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <numeric>

#include "solver/scene/body/mass.hpp"
#include "solver/scene/bulk/region.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::scene {
namespace {

constexpr int least_contacts = 4;  // of a body that is no rattler

/// How far a body reaches from its centre along the axes.
Vec3<double> reach_of(const World& world, std::size_t i) {
  const Eigen::Matrix3d axes = world.solver_orientation(i).toRotationMatrix();
  Vec3<double> out;
  for (int k = 0; k < 3; ++k) out[k] = support<double>(world.bodies.shape[i], axes.row(k).transpose());
  return out;
}

Region box_of_all(const World& world) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Region out{Vec3<double>::Constant(infinite), Vec3<double>::Constant(-infinite)};
  for (std::size_t i = 0; i < world.bodies.count; ++i) {
    const Vec3<double> at = world.state.position->vector(i), reach = reach_of(world, i);
    out.low = out.low.cwiseMin(at - reach);
    out.high = out.high.cwiseMax(at + reach);
  }
  return out;
}

/// Along the axes of a box that repeats itself that box, or without an end: a body counts everywhere.
Region in_box(const World& world, Region region, bool is_endless) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (world.state.box_sides == nullptr) return region;
  const Vec3<double> sides = world.state.box_sides->vector(0);
  for (int k = 0; k < 3; ++k)
    if (sides[k] > 0) region.low[k] = is_endless ? -infinite : 0, region.high[k] = is_endless ? infinite : sides[k];
  return region;
}

double volume_of(const Region& region) {
  return (region.high - region.low).prod();
}

double volume_within(const World& world, const Region& region) {
  double sum = 0;
  for (std::size_t i = 0; i < world.bodies.count; ++i)
    sum += mass_properties(world.bodies.shape[i]).volume *
           share_within(region, world.bodies.shape[i], world.state.position->vector(i), world.solver_orientation(i));
  return sum;
}

Profiles profiles_of(const World& world, const Region& counted, const Region& box) {
  Profiles out{};
  for (std::size_t i = 0; i < world.bodies.count; ++i)
    add_to_profiles(counted, box, world.bodies.shape[i], world.state.position->vector(i), world.solver_orientation(i),
                    mass_properties(world.bodies.shape[i]).volume, out);
  return out;
}

/// The bodies that count, and the contacts between all.
class Packing {
 public:
  Packing(const World& world, const Region& region) : world_(world), counts_(world.bodies.all(), 0) {
    for (const std::uint32_t i : world.bodies.movable) {
      const Vec3<double> at = world.state.position->vector(i);
      counts_[i] = (at.array() >= region.low.array()).all() && (at.array() <= region.high.array()).all() ? 1 : 0;
      if (counts_[i] != 0) bodies_.push_back(i);
    }
    for (const std::uint32_t c : world.contacts.touching)
      if ((*world.contacts.overlap)[c] > 0) touching_.push_back(c);
  }

  [[nodiscard]] const std::vector<std::uint32_t>& bodies() const { return bodies_; }

  /// visit(contact, body, sign) of each contact of a body that counts; sign: +1 for a contact's second body.
  template <class Visit>
  void each_end(Visit&& visit) const {
    for (const std::uint32_t c : touching_) {
      const auto [i, j] = world_.contacts.pairs[c];
      if (counts_[i] != 0) visit(c, i, -1.0);
      if (counts_[j] != 0) visit(c, j, 1.0);
    }
  }

  /// Contacts of each body among those that are there, a flag each.
  [[nodiscard]] std::vector<int> contacts_among(const std::vector<char>& there) const {
    std::vector<int> out(world_.bodies.all(), 0);
    for (const std::uint32_t c : touching_) {
      const auto [i, j] = world_.contacts.pairs[c];
      if (there[i] == 0 || there[j] == 0) continue;
      ++out[i];
      ++out[j];
    }
    return out;
  }

 private:
  const World& world_;
  std::vector<char> counts_;
  std::vector<std::uint32_t> bodies_, touching_;
};

/// 1 for what is left when rattlers are taken away until there are none; walls and fixed bodies stay.
std::vector<char> without_rattlers(const World& world, const Packing& packing) {
  std::vector<char> left(world.bodies.all(), 1);
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    const std::vector<int> contacts = packing.contacts_among(left);
    for (const std::uint32_t i : world.bodies.movable)
      if (left[i] != 0 && contacts[i] < least_contacts) {
        left[i] = 0;
        goes_on = true;
      }
  }
  return left;
}

void count_contacts(const World& world, const Packing& packing, Bulk& out) {
  const std::vector<char> all(world.bodies.all(), 1), left = without_rattlers(world, packing);
  const std::vector<int> of_all = packing.contacts_among(all), of_left = packing.contacts_among(left);
  std::size_t sum = 0, sum_left = 0;
  for (const std::uint32_t i : packing.bodies()) {
    sum += static_cast<std::size_t>(of_all[i]);
    sum_left += static_cast<std::size_t>(of_left[i]);
    out.rattlers += left[i] == 0 ? 1 : 0;
  }
  out.bodies = packing.bodies().size();
  if (out.bodies == 0) return;
  out.coordination = static_cast<double>(sum) / static_cast<double>(out.bodies);
  if (out.rattlers < out.bodies)
    out.coordination_without_rattlers = static_cast<double>(sum_left) / static_cast<double>(out.bodies - out.rattlers);
}

std::optional<Eigen::Matrix3d> fabric_of(const World& world, const Packing& packing) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  int ends = 0;
  packing.each_end([&](std::uint32_t c, std::uint32_t, double) {
    const Vec3<double> normal = world.contacts.normal->vector(c);
    sum += normal * normal.transpose();
    ++ends;
  });
  if (ends == 0) return std::nullopt;
  return sum / ends;
}

std::optional<Vec3<double>> order_of(const World& world, const Packing& packing) {
  std::array<Eigen::Matrix3d, 3> sums;
  sums.fill(Eigen::Matrix3d::Zero());
  int shapes = 0;
  for (const std::uint32_t i : packing.bodies()) {
    if (world.bodies.is_sphere[i] != 0) continue;
    const Eigen::Matrix3d axes = world.state.orientation_of(i).toRotationMatrix();
    for (int k = 0; k < 3; ++k) sums[static_cast<std::size_t>(k)] += axes.col(k) * axes.col(k).transpose();
    ++shapes;
  }
  if (shapes == 0) return std::nullopt;
  Vec3<double> out;
  for (int k = 0; k < 3; ++k) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> of_mean(sums[static_cast<std::size_t>(k)] / shapes,
                                                                 Eigen::EigenvaluesOnly);
    out[k] = (3 * of_mean.eigenvalues()[2] - 1) / 2;
  }
  return out;
}

Eigen::Matrix3d stress_of(const World& world, const Packing& packing, double volume) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  packing.each_end([&](std::uint32_t c, std::uint32_t body, double sign) {
    const Levers levers = world.levers(c);
    const Vec3<double>& arm = body == world.contacts.pairs[c][0] ? levers.r1 : levers.r2;
    sum += sign * arm * world.contacts.force->vector(c).transpose();
  });
  return sum / volume;
}

Eigen::Matrix3d kinetic_of(const World& world, const Packing& packing, double volume) {
  Vec3<double> momentum = Vec3<double>::Zero();
  double mass = 0;
  for (const std::uint32_t i : packing.bodies()) {
    momentum += world.bodies.mass[i] * world.state.velocity->vector(i);
    mass += world.bodies.mass[i];
  }
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const std::uint32_t i : packing.bodies()) {
    const Vec3<double> apart = world.state.velocity->vector(i) - momentum / mass;
    sum -= world.bodies.mass[i] * apart * apart.transpose();
  }
  return sum / volume;
}

/// A contact between two bodies of the region counts once for each.
std::optional<ForceDistribution> forces_of(const World& world, const Packing& packing) {
  std::vector<double> forces;
  packing.each_end(
      [&](std::uint32_t c, std::uint32_t, double) { forces.push_back((*world.contacts.normal_force)[c]); });
  if (forces.empty()) return std::nullopt;
  std::ranges::sort(forces);
  ForceDistribution out;
  out.mean = std::accumulate(forces.begin(), forces.end(), 0.0) / static_cast<double>(forces.size());
  if (!(out.mean > 0)) return out;
  for (std::size_t k = 0; k < out.deciles.size(); ++k) out.deciles[k] = forces[(k + 1) * forces.size() / 10] / out.mean;
  out.greatest = forces.back() / out.mean;
  return out;
}

}  // namespace

Bulk bulk_of(const World& world, const std::optional<Region>& region) {
  Bulk out;
  out.region = in_box(world, region ? *region : box_of_all(world), false);
  const Region counted = in_box(world, out.region, true);
  const Packing packing(world, counted);
  const double volume = volume_of(out.region);
  out.packing_fraction = volume_within(world, counted) / volume;
  out.profiles = profiles_of(world, counted, out.region);
  count_contacts(world, packing, out);
  if (out.bodies == 0) return out;
  out.fabric = fabric_of(world, packing);
  out.order = order_of(world, packing);
  if (world.contacts.force == nullptr) return out;
  out.stress = stress_of(world, packing, volume);
  out.kinetic = kinetic_of(world, packing, volume);
  out.forces = forces_of(world, packing);
  return out;
}

}  // namespace plumb::scene
