// No contact is lost: what a run has in its list is what every pair, solved cold, says.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/tests/scene/crowd.hpp"
#include "properties/tests/scene/made.hpp"
#include "solver/method/automatic.hpp"
#include "solver/scene/contact/narrow_phase.hpp"
#include "solver/scene/contact/neighbours.hpp"
#include "solver/scene/named.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::scene {
namespace {

using made::Vec;
using PairSet = std::set<std::array<std::uint32_t, 2>>;

bool can_change(const World& world, std::uint32_t i, std::uint32_t j) {
  return world.bodies.inverse_mass[i] > 0 || world.bodies.inverse_mass[j] > 0;
}

/// overlap > -range, by the support function for walls and by a cold solve to rounding for bodies.
double cold_overlap(const World& world, std::uint32_t i, std::uint32_t j) {
  const Body first = solver_body(world, i);
  if (!world.bodies.is_wall(j)) return automatic<double>({first, solver_body(world, j)}, Want{}, nullptr).overlap;
  const Vec into = -world.bodies.wall_normal[j - world.bodies.count];
  const auto& q = first.quaternion;
  const Vec own = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).conjugate() * into;
  return support<double>(first.shape, own) - into.dot(world.state.position->vector(j) - first.position);
}

PairSet touching_by_force(const World& world) {
  PairSet out;
  for (std::uint32_t i = 0; i < world.bodies.count; ++i)
    for (std::uint32_t j = i + 1; j < world.bodies.all(); ++j)
      if (can_change(world, i, j) && cold_overlap(world, i, j) > -world.contacts.range) out.insert({i, j});
  return out;
}

PairSet touching_in_list(const World& world) {
  PairSet out;
  for (const std::uint32_t c : world.contacts.touching) out.insert(world.contacts.pairs[c]);
  return out;
}

/// What the list is good for: no body has left the box that it was made with, but for what rounding sums up to.
bool are_in_their_boxes(const World& world) {
  const Column& boxes = *world.columns.find("box");
  return std::ranges::all_of(world.bodies.movable, [&](std::uint32_t i) {
    const Vec low = Vec::Map(boxes.entry(i).data()), high = Vec::Map(boxes.entry(i).data() + 3);
    const Vec at = world.state.position->vector(i), half = half_extent(world, i);
    const double room = std::min((at - half - low).minCoeff(), (high - at - half).minCoeff());
    return room >= -1e-12 * world.bodies.radius[i];
  });
}

/// Looks every so many steps; how many contacts there were to lose.
std::size_t expect_none_lost(const Scene& scene, std::int64_t every) {
  const auto run = made::started(scene);
  std::size_t contacts = 0;
  while (!run->is_done()) {
    if (run->steps() % every == 0) {
      const PairSet expected = touching_by_force(run->world());
      EXPECT_EQ(touching_in_list(run->world()), expected) << scene.name << " step " << run->steps();
      contacts += expected.size();
    }
    run->step();
    EXPECT_TRUE(are_in_their_boxes(run->world())) << scene.name << " step " << run->steps();
  }
  EXPECT_EQ(run->totals().failed, 0) << scene.name;
  return contacts;
}

TEST(ContactList, OfThePileIsThatOfAllPairs) {
  EXPECT_GE(expect_none_lost(find_named_scene("pile")->make(40), 97), 3000U);
}

// Fixed plates among the bodies, which are large and stay.
TEST(ContactList, OfTheHopperIsThatOfAllPairs) {
  EXPECT_GE(expect_none_lost(find_named_scene("hopper")->make(30), 211), 500U);
}

TEST(ContactList, OfBilliardsIsThatOfAllPairs) {
  Scene scene = find_named_scene("billiards")->make(16);
  scene.run.duration = 0.5;
  EXPECT_GE(expect_none_lost(scene, 3), 100U);
}

// A range, a floor that shakes.
TEST(ContactList, OfACrowdIsThatOfAllPairs) {
  EXPECT_GE(expect_none_lost(crowd(), 1), 1000U);
}

// A pull that reaches further than the boxes' margins, to bodies and to walls.
TEST(ContactList, OfALongRangeIsThatOfAllPairs) {
  Scene scene = crowd();
  scene.effects.cohesion = Cohesion{2, 0.7};
  const auto run = made::started(scene);
  for (int k = 0; k < 10; ++k) {
    EXPECT_EQ(touching_in_list(run->world()), touching_by_force(run->world())) << k;
    for (int i = 0; i < 20 && !run->is_done(); ++i) run->step();
  }
}

}  // namespace
}  // namespace plumb::scene
