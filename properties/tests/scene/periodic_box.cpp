// A box that repeats itself: bodies meet images as they meet each other, and a box that changes does what Newton's law says of it.
#include <gtest/gtest.h>

#include <functional>
#include <numeric>

#include "properties/laws/motion/scene.hpp"
#include "properties/tests/scene/crowded_box.hpp"
#include "solver/method/automatic.hpp"
#include "solver/scene/bulk/bulk.hpp"
#include "solver/scene/contact/narrow_phase.hpp"

namespace plumb::scene {
namespace {

using made::ball;
using made::crowded_box;
using made::position;
using made::Vec;
using made::velocity;
constexpr double side = made::crowded_side;
using PairSet = std::set<std::array<std::uint32_t, 2>>;

/// Elastic, without friction.
Scene gas() {
  Scene scene = crowded_box();
  scene.effects = {};
  scene.effects.linear = Linear{2e4};
  scene.effects.periodic_box = PeriodicBox{Vec::Constant(side)};
  return scene;
}

/// One that no wall and no contact disturbs.
TEST(PeriodicBox, ABodyAloneMovesAsInTheFrameOfTheBox) {
  Scene scene;
  const Vec start(1, 7, 3), speed(3, -2, 0.5), sides(8, 9, 10), rate(-1, 2, 0);
  scene.bodies = {ball(0.5, start, speed)};
  scene.effects.periodic_box = PeriodicBox{sides, rate};
  scene.run.duration = 2;
  const auto run = made::ended(scene);
  const Vec factor = (sides + 2 * rate).cwiseQuotient(sides);
  EXPECT_TRUE(position(*run, 0).isApprox(factor.cwiseProduct(start) + 2 * speed, 1e-13));
  EXPECT_TRUE(velocity(*run, 0).isApprox(speed.cwiseQuotient(factor), 1e-13));
  EXPECT_TRUE(run->world().state.box_sides->vector(0).isApprox(sides + 2 * rate, 1e-13));
}

// What happens in the middle of a large box happens in none.
TEST(PeriodicBox, ThatNothingReachesChangesNoBit) {
  Scene boxed = crowded_box(), open = boxed;
  boxed.effects.periodic_box = PeriodicBox{Vec::Constant(100)};
  for (SceneBody& b : boxed.bodies) b.body.position += Vec::Constant(32);
  for (SceneBody& b : open.bodies) b.body.position += Vec::Constant(32);
  open.effects.periodic_box.reset();
  const auto with = made::ended(boxed), without = made::ended(open);
  EXPECT_EQ(with->hashes().at("position"), without->hashes().at("position"));
  EXPECT_EQ(with->hashes().at("angular_momentum"), without->hashes().at("angular_momentum"));
}

// Each body may be given by any of its images.
TEST(PeriodicBox, IsTheSameWhicheverImagesAreGiven) {
  const Scene scene = crowded_box();
  Scene moved = scene;
  for (std::size_t k = 0; k < moved.bodies.size(); ++k) {
    const int n = static_cast<int>(k);
    moved.bodies[k].body.position += side * Vec(n % 3 - 1, n % 5 - 2, n % 2);
  }
  const auto run = made::ended(scene), other = made::ended(moved);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Vec shift = moved.bodies[k].body.position - scene.bodies[k].body.position;
    EXPECT_LT((position(*other, k) - shift - position(*run, k)).norm(), 1e-9) << k;
  }
}

Vec nearest(const Vec& apart, const Vec& sides) {
  return apart - sides.cwiseProduct(Vec(apart.cwiseQuotient(sides).array().round()));
}

/// Every pair in every image, solved cold.
PairSet touching_images(const World& world) {
  PairSet out;
  const Vec sides = world.state.box_sides->vector(0);
  for (std::uint32_t i = 0; i < world.bodies.count; ++i)
    for (std::uint32_t j = i + 1; j < world.bodies.count; ++j)
      for (int k = 0; k < 27; ++k) {
        const int y = k / 3 % 3 - 1, z = k / 9 - 1;
        Pair pair{solver_body(world, i), solver_body(world, j)};
        const Vec apart = nearest(pair.body2.position - pair.body1.position, sides);
        pair.body2.position = pair.body1.position + apart + sides.cwiseProduct(Vec(k % 3 - 1, y, z));
        if (automatic<double>(pair, Want{}, nullptr).overlap > -world.contacts.range) out.insert({i, j});
      }
  return out;
}

TEST(PeriodicBox, LosesNoContactWhileItShrinksAndGrows) {
  for (const double rate : {-0.4, 1.0}) {
    Scene scene = crowded_box();
    made::periodic_box(scene).rate = {rate, 0, rate / 2};
    const auto run = made::started(scene);
    std::size_t contacts = 0;
    while (!run->is_done()) {
      run->step();
      if (run->steps() % 40 != 0) continue;
      const PairSet expected = touching_images(run->world());
      PairSet listed;
      for (const std::uint32_t c : run->world().contacts.touching) listed.insert(run->world().contacts.pairs[c]);
      EXPECT_EQ(listed, expected) << run->steps();
      contacts += expected.size();
    }
    EXPECT_GT(contacts, 100U);
    EXPECT_EQ(run->totals().failed, 0);
  }
}

TEST(PeriodicBox, KeepsMomentumAndEnergy) {
  Scene scene = gas();
  scene.run.accuracy = 1e-4;
  const auto run = made::started(scene);
  const Vec momentum = run->momentum();
  const double energy = made::total_energy(*run);
  while (!run->is_done()) run->step();
  EXPECT_LT((run->momentum() - momentum).norm(), 1e-9 * momentum.norm());
  EXPECT_NEAR(made::total_energy(*run), energy, 1e-3 * energy);
  EXPECT_GT(run->energy().at("linear"), 0);
}

/// By how much the energy differs from what the box has done by its stress.
double error_of_work(double accuracy) {
  Scene scene = gas();
  made::periodic_box(scene).rate = {-1, 0.5, 0};
  scene.run.accuracy = accuracy;
  scene.run.outputs.contacts = true;
  const auto run = made::started(scene);
  const World& world = run->world();
  const auto power = [&] {
    double sum = 0;
    for (const std::uint32_t i : world.bodies.movable)
      sum -= world.bodies.mass[i] * velocity(*run, i).dot(world.by_box(velocity(*run, i)));
    for (const std::uint32_t c : world.contacts.touching) {
      const Vec apart = world.second_position(c) - world.state.position->vector(world.contacts.pairs[c][0]);
      sum -= world.contacts.force->vector(c).dot(world.by_box(apart));
    }
    return sum;
  };
  const double before = made::total_energy(*run);
  double work = 0, last = power();
  while (!run->is_done()) {
    run->step();
    const double now = power();
    work += run->plan().time_step * (last + now) / 2;
    last = now;
  }
  EXPECT_GT(work, 0.1 * before);
  return std::abs(made::total_energy(*run) - before - work) / before;
}

TEST(PeriodicBox, ThatShrinksDoesTheWorkOfItsStress) {
  const double coarse = error_of_work(1e-2), fine = error_of_work(1e-4);
  EXPECT_LT(coarse, 1e-1);
  EXPECT_LT(fine, 1e-3);
}

TEST(PeriodicBox, StopsAtItsPressure) {
  Scene scene = gas();
  scene.effects.damping = Damping{0.3};
  scene.effects.drag = Drag{1};
  made::periodic_box(scene).rate = Vec::Constant(-1);
  made::periodic_box(scene).pressure = 50;
  scene.run.duration = 8;
  scene.run.outputs.bulk = true;
  const auto run = made::ended(scene);
  const Bulk bulk = bulk_of(run->world(), {});
  EXPECT_NEAR(-(made::matrix(bulk.stress) + made::matrix(bulk.kinetic)).trace() / 3, 50, 0.5);
  EXPECT_GT(bulk.coordination.value_or(0), 6);
  EXPECT_LT(run->world().state.box_sides->vector(0).maxCoeff(), 0.9 * side);
}

TEST(PeriodicBox, GoesOnFromAnySnapshotAndWithAnyThreads) {
  Scene scene = crowded_box();
  made::periodic_box(scene).rate = Vec::Constant(-0.5);
  made::periodic_box(scene).pressure = 300;
  for (const std::int64_t step : {1, 50, 333}) EXPECT_EQ(find_snapshot_change(scene, step), "");
  EXPECT_EQ(made::ended(scene, 2)->hash(), made::ended(scene)->hash());
}

// Through the sides of x and y each, and a floor under them.
TEST(PeriodicBox, MayBeOpenAlongAnAxisThatWallsAreAcross) {
  Scene scene;
  scene.bodies = {ball(1, {0.5, 4, 0.99}), ball(1, {7.505, 3.9, 0.99})};
  scene.walls = {made::floor_at()};
  scene.effects.linear = Linear{1e4};
  scene.effects.periodic_box = PeriodicBox{{9, 8, 0}};
  scene.run.duration = 1e-6;
  const auto run = made::started(scene);
  EXPECT_EQ(run->world().contacts.touching.size(), 3U);
  EXPECT_NEAR(velocity(*run, 0).norm(), 0, 0);
  EXPECT_GT(run->world().state.force->vector(0).x(), 0);
}

TEST(PeriodicBox, RefusesWhatHasNoMeaningInIt) {
  const auto refused = [](const PeriodicBox& box, const std::function<void(Scene&)>& change = nullptr) {
    Scene scene = gas();
    scene.effects.periodic_box = box;
    if (change) change(scene);
    return made::refused_field(scene);
  };
  const Vec sides = Vec::Constant(side), shrinks = Vec::Constant(-1);
  EXPECT_EQ(refused({sides, shrinks, 5}), "");
  EXPECT_EQ(refused({Vec(-1, 1, 1)}), "effects.periodic_box.sides");
  EXPECT_EQ(refused({Vec(side, side, 5)}), "effects.periodic_box.sides");
  EXPECT_EQ(refused({Vec(side, side, 0), shrinks}), "effects.periodic_box.rate");
  EXPECT_EQ(refused({sides, 10 * shrinks}), "effects.periodic_box.rate");
  EXPECT_EQ(refused({sides, 10 * shrinks, 5}), "");  // it may stop before
  EXPECT_EQ(refused({sides, -shrinks, 5}), "effects.periodic_box.rate");
  EXPECT_EQ(refused({sides, Vec::Zero(), 5}), "effects.periodic_box.rate");
  EXPECT_EQ(refused({Vec(side, side, 0), Vec(-1, 0, 0), 5}), "effects.periodic_box.pressure");
  EXPECT_EQ(refused({sides, shrinks}, [](Scene& s) { s.bodies[3].is_fixed = true, s.bodies[3].velocity.setZero(); }),
            "effects.periodic_box.rate");
  EXPECT_EQ(refused({sides}, [](Scene& s) { s.walls = {made::floor_at()}; }), "walls[0].normal");
  EXPECT_EQ(refused({sides}, [](Scene& s) { s.walls.emplace_back().shape = BoxWall{Vec::Ones()}; }), "walls[0]");
  EXPECT_EQ(
      refused({sides},
              [](Scene& s) { s.run.outputs.region = Region{-Vec::Ones(), Vec::Ones()}, s.run.outputs.bulk = true; }),
      "run.outputs.region");
  EXPECT_EQ(refused({Vec(side, side, 0)},
                    [](Scene& s) {
                      s.walls = {made::floor_at(-5)};
                      s.effects.moving_walls = MovingWalls{{{.wall = 0, .angular_velocity = Vec::UnitZ()}}};
                    }),
            "effects.moving_walls");
}

TEST(PeriodicBox, IsThereWhereNothingMoves) {
  Scene scene;
  scene.bodies = {ball(1, {0.2, 4, 4}), ball(1, {9.9, 4.5, 4.1})};
  scene.effects.periodic_box = PeriodicBox{Vec::Constant(side)};
  EXPECT_EQ(made::started(scene)->world().contacts.touching.size(), 1U);
  scene.run.outputs.contacts = true;
  const auto run = made::started(scene);
  const World& world = run->world();
  ASSERT_EQ(world.contacts.touching.size(), 1U);
  EXPECT_TRUE(world.contacts.normal->vector(0).isApprox(Vec(-0.3, 0.5, 0.1).normalized(), 1e-12));
  EXPECT_NEAR((*world.contacts.overlap)[0], 2 - Vec(0.3, 0.5, 0.1).norm(), 1e-12);
}

TEST(PeriodicBox, HasTheMeasuresOfItsWholeSpace) {
  constexpr double stiffness = 1e4, overlap = 0.01;
  Scene scene;
  scene.bodies = {ball(1, {0.5, 4, 4}), ball(1, {0.5 - 2 + overlap + side, 4, 4})};
  scene.effects.linear = Linear{stiffness};
  scene.effects.periodic_box = PeriodicBox{Vec::Constant(side)};
  scene.run.duration = 1e-6;
  scene.run.outputs.bulk = true;
  const auto run = made::started(scene);
  const Bulk bulk = bulk_of(run->world(), {});
  const double volume = side * side * side;
  EXPECT_DOUBLE_EQ(bulk.packing_fraction, 2 * 4 * std::numbers::pi / 3 / volume);
  EXPECT_TRUE(bulk.region.low.isZero(0));
  EXPECT_TRUE(bulk.region.high.isApprox(Vec::Constant(side)));
  EXPECT_EQ(bulk.bodies, 2U);
  for (const auto& profile : bulk.profiles)
    EXPECT_NEAR(std::accumulate(profile.begin(), profile.end(), 0.0) / 10, bulk.packing_fraction, 1e-12);
  const auto cap = [](double h) {
    return std::numbers::pi * h * h * (3 - h) / 3;
  };  // of the second, and of the first's image
  EXPECT_NEAR(bulk.profiles[0][9], (cap(0.5 + overlap) + cap(0.5)) / (side * side), 1e-3);
  EXPECT_NEAR(made::matrix(bulk.stress)(0, 0), -stiffness * overlap * (2 - overlap) / volume, 1e-9);
  EXPECT_NEAR(made::matrix(bulk.stress)(1, 1), 0, 1e-12);
}

}  // namespace
}  // namespace plumb::scene
