#include "solver/scene/contact/neighbours.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>

#include "solver/scene/threads.hpp"

namespace plumb::scene {
namespace {

namespace geometry = boost::geometry;
using Point = geometry::model::point<double, 3, geometry::cs::cartesian>;
using Box = geometry::model::box<Point>;
using Entry = std::pair<Box, std::uint32_t>;
using Pairs = std::vector<std::array<std::uint32_t, 2>>;

constexpr double share_of_radius =
    0.05;  // of the margin; twice that builds half the lists and solves a tenth more pairs
constexpr double steps_ahead = 20;

Vec3<double> low_of(const Column& boxes, std::size_t i) {
  return Vec3<double>::Map(boxes.entry(i).data());
}
Vec3<double> high_of(const Column& boxes, std::size_t i) {
  return Vec3<double>::Map(boxes.entry(i).data() + 3);
}

/// In the box at the origin, where there is one that repeats itself, and from there by `shift`.
Box box_of(const World& world, const Column& boxes, std::size_t i, const Vec3<double>& shift = Vec3<double>::Zero()) {
  Vec3<double> low = low_of(boxes, i), high = high_of(boxes, i);
  if (world.state.box_sides != nullptr) {
    const Vec3<double> centre = (low + high) / 2, by = world.home(centre) - centre + shift;
    low += by;
    high += by;
  }
  return {{low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}};
}

/// visit(shift) for each image of the box at the origin that is beside it, and for itself.
template <class Visit>
void each_image(const World& world, const Visit& visit) {
  if (world.state.box_sides == nullptr) return visit(Vec3<double>(Vec3<double>::Zero()));
  const Vec3<double> sides = world.state.box_sides->vector(0);
  std::array<int, 3> last{};
  for (int k = 0; k < 3; ++k) last[static_cast<std::size_t>(k)] = sides[k] > 0 ? 1 : 0;
  for (int x = -last[0]; x <= last[0]; ++x)
    for (int y = -last[1]; y <= last[1]; ++y)
      for (int z = -last[2]; z <= last[2]; ++z) visit(Vec3<double>(x * sides[0], y * sides[1], z * sides[2]));
}

bool can_meet(const Bodies& bodies, std::uint32_t i, std::uint32_t j) {
  return bodies.movable.empty() || bodies.inverse_mass[i] > 0 || bodies.inverse_mass[j] > 0;
}

/// How far a wall may move before its list is made anew.
double wall_margin(const World& world) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t i : world.bodies.movable) least = std::min(least, world.bodies.radius[i]);
  return world.bodies.movable.empty() ? 0 : share_of_radius * least;
}

/// How far a body's fat box reaches beyond its own.
double margin_of(const World& world, std::size_t i) {
  if (world.bodies.inverse_mass[i] == 0 || world.state.velocity == nullptr) return 0;
  const double moves = steps_ahead * world.time_step * world.state.velocity->vector(i).norm();
  return std::clamp(moves, share_of_radius * world.bodies.radius[i], world.bodies.radius[i]);
}

using Tree = geometry::index::rtree<Entry, geometry::index::linear<16>>;

Tree tree_of(const World& world, const Column& boxes) {
  std::vector<Entry> entries;
  entries.reserve(world.bodies.count);
  for (std::uint32_t i = 0; i < world.bodies.count; ++i) entries.emplace_back(box_of(world, boxes, i), i);
  return Tree(entries);  // packed: built at once
}

/// Bodies after body i whose fat boxes meet its or an image of it, sorted.
void add_bodies(const World& world, const Column& boxes, const Tree& tree, std::uint32_t i, Pairs& pairs) {
  const auto first = static_cast<std::ptrdiff_t>(pairs.size());
  const auto is_pair = [&](const Entry& other) { return other.second > i && can_meet(world.bodies, i, other.second); };
  each_image(world, [&](const Vec3<double>& shift) {
    const Box box = box_of(world, boxes, i, shift);
    if (!geometry::intersects(box, tree.bounds())) return;
    const auto query = geometry::index::intersects(box) && geometry::index::satisfies(is_pair);
    for (auto met = tree.qbegin(query); met != tree.qend(); ++met) pairs.push_back({i, met->second});
  });
  std::sort(pairs.begin() + first, pairs.end());
  pairs.erase(std::unique(pairs.begin() + first, pairs.end()), pairs.end());
}

/// Whether a wall may reach into a box: of a plane by its normal, of others by the ball about their point, whose turning is nothing.
bool reaches(const Bodies& bodies, std::size_t wall, const Vec3<double>& from, const Vec3<double>& half, double range) {
  const Vec3<double> normal = bodies.wall_normal[wall];
  if (std::holds_alternative<PlaneWall>(bodies.wall_shape[wall]))
    return normal.dot(from) <= normal.cwiseAbs().dot(half) + range;
  return (from.cwiseAbs() - half).cwiseMax(0).norm() <= extent_of(bodies.wall_shape[wall]) + range;
}

void add_places(const Bodies& bodies, std::uint32_t i, std::uint32_t j, Pairs& pairs) {
  pairs.insert(pairs.end(), bodies.places(j), {i, j});
}

/// Walls that reach into body i's box.
void add_walls(const World& world, const Column& boxes, double margin, std::uint32_t i, Pairs& pairs) {
  const Bodies& bodies = world.bodies;
  for (std::size_t wall = 0; wall < bodies.walls; ++wall) {
    const auto j = static_cast<std::uint32_t>(bodies.count + wall);
    if (!can_meet(bodies, i, j)) break;
    const Vec3<double> low = low_of(boxes, i), high = high_of(boxes, i), half = (high - low) / 2;
    const Vec3<double> from = (low + high) / 2 - low_of(boxes, j);
    if (reaches(bodies, wall, from, half, world.contacts.range / 2 + margin)) add_places(bodies, i, j, pairs);
  }
}

/// How far any point of a body's surface can have moved in the last step, at most: sums of magnitudes spare two roots.
double greatest_motion(const World& world, std::uint32_t i) {
  const double shift = world.state.velocity->vector(i).cwiseAbs().sum();
  if (!world.has_turning()) return shift * world.time_step;
  const double momentum = world.state.angular_momentum->vector(i).cwiseAbs().sum();
  const double turn = momentum * world.bodies.inverse_inertia[i].maxCoeff() * world.bodies.radius[i];
  return (shift + turn) * world.time_step;
}

/// Between the box that a body needs now and its fat one; negative where it has left that, NaN where there is none.
double room_in_box(const World& world, const Column& boxes, std::uint32_t i) {
  const Vec3<double> x = world.state.position->vector(i), half = half_extent(world, i);
  const Vec3<double> below = x - half - low_of(boxes, i), above = high_of(boxes, i) - x - half;
  const double low = below.minCoeff<Eigen::PropagateNaN>(), high = above.minCoeff<Eigen::PropagateNaN>();
  return std::isnan(low) ? low : std::min(low, high);
}

bool walls_stand(const World& world, const Column& boxes) {
  const Bodies& bodies = world.bodies;
  if (bodies.walls == 0) return true;
  const double margin = wall_margin(world);
  for (std::size_t wall = 0; wall < bodies.walls; ++wall) {
    const Vec3<double> moved = world.state.position->vector(bodies.count + wall) - low_of(boxes, bodies.count + wall);
    const bool is_plane = std::holds_alternative<PlaneWall>(bodies.wall_shape[wall]);
    if (!((is_plane ? bodies.wall_normal[wall].dot(moved) : moved.norm()) <= margin)) return false;
    if (is_plane && !bodies.wall_spin[wall].isZero(0)) return false;
  }
  return true;
}

}  // namespace

Vec3<double> half_extent(const World& world, std::size_t body) {
  const Mat3<double> rotation = world.state.orientation_of(body).toRotationMatrix();
  const Vec3<double> box = rotation.cwiseAbs() * world.bodies.shape[body].semi_axes;
  return box.cwiseMin(world.bodies.radius[body]).array() + world.contacts.range / 2;
}

bool are_within(const World& world, Column& boxes) {
  if (std::isnan(boxes.entry(0)[6])) return false;
  for (const std::uint32_t i : world.bodies.movable) {
    double& room = boxes.entry(i)[6];
    room -= greatest_motion(world, i);
    if (room >= 0) continue;
    room = room_in_box(world, boxes, i);
    if (!(room >= 0)) return false;
  }
  return walls_stand(world, boxes);
}

void fatten(const World& world, Column& boxes) {
  const Bodies& bodies = world.bodies;
  for (std::size_t i = 0; i < bodies.all(); ++i) {
    const Vec3<double> x = world.state.position->vector(i);
    Vec3<double> half = Vec3<double>::Zero();
    boxes.entry(i)[6] = 0;
    if (i < bodies.count) {
      const double room = margin_of(world, i);
      half = half_extent(world, i).array() + room;
      boxes.entry(i)[6] = room;
    }
    Vec3<double>::Map(boxes.entry(i).data()) = x - half;
    Vec3<double>::Map(boxes.entry(i).data() + 3) = x + half;
  }
}

void stretch(const World& world, const Vec3<double>& factor, Column& boxes) {
  const double most = (factor.array() - 1).abs().maxCoeff();
  for (const std::uint32_t i : world.bodies.movable) {
    const Vec3<double> low = low_of(boxes, i), high = high_of(boxes, i);
    // A fat box that shrinks has less room for its body, which does not.
    boxes.entry(i)[6] -=
        most * ((high - low).maxCoeff() / 2 + world.state.velocity->vector(i).norm() * world.time_step);
    Vec3<double>::Map(boxes.entry(i).data()) = factor.cwiseProduct(low);
    Vec3<double>::Map(boxes.entry(i).data() + 3) = factor.cwiseProduct(high);
  }
}

Pairs meeting_pairs(const World& world, const Column& boxes) {
  constexpr std::size_t worth_waking = 256;
  const std::size_t bodies = world.bodies.count;
  const Tree tree = tree_of(world, boxes);
  const double margin = wall_margin(world);
  std::vector<Pairs> parts(parts_of(bodies, worth_waking));
  for_each_part(bodies, worth_waking, world.threads, [&](std::size_t part, std::size_t first, std::size_t end) {
    for (auto i = static_cast<std::uint32_t>(first); i < end; ++i) {
      add_bodies(world, boxes, tree, i, parts[part]);
      add_walls(world, boxes, margin, i, parts[part]);
    }
  });
  Pairs pairs;
  for (const Pairs& part : parts) pairs.insert(pairs.end(), part.begin(), part.end());
  return pairs;
}

Pairs all_pairs(const Bodies& bodies) {
  const bool is_still = bodies.movable.empty();
  Pairs pairs;
  for (std::uint32_t i = 0; i < bodies.count; ++i)
    for (std::uint32_t j = i + 1; j < bodies.all(); ++j)
      if (is_still || can_meet(bodies, i, j)) add_places(bodies, i, j, pairs);
  return pairs;
}

}  // namespace plumb::scene
