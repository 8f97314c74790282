// The same bits: with any number of threads, and after a snapshot in mid-run.
#include <gtest/gtest.h>

#include "properties/laws/motion/scene.hpp"
#include "properties/tests/scene/crowd.hpp"
#include "properties/tests/scene/made.hpp"
#include "solver/scene/named.hpp"

namespace plumb::scene {
namespace {

using made::started;

void step_to(Simulation& run, std::int64_t steps) {
  while (run.steps() < steps && !run.is_done()) run.step();
}

/// Scenes with all there is: every effect, a broad phase whose list changes, walls that move.
std::vector<Scene> varied_scenes() {
  std::vector<Scene> all{crowd(),
                         crowd(),
                         find_named_scene("pile")->make(40),
                         find_named_scene("hopper")->make(20),
                         find_named_scene("billiards")->make(16),
                         find_named_scene("chain")->make(6)};
  all[1].effects.linear.reset();
  all[1].effects.hertz = Hertz{3e4};
  return all;
}

constexpr std::int64_t long_enough = 2500;

TEST(Determinism, ThreadsChangeNoBit) {
  for (const Scene& scene : varied_scenes()) {
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2, 3}) {
      const auto run = started(scene, threads);
      step_to(*run, long_enough);
      hashes.push_back(run->hash());
    }
    EXPECT_EQ(hashes[1], hashes[0]) << scene.name;
    EXPECT_EQ(hashes[2], hashes[0]) << scene.name;
  }
}

// With so many pairs that threads are put to work, and a list that changes.
TEST(Determinism, ThreadsThatWorkChangeNoBit) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 2, 3}) {
    const auto run = started(find_named_scene("pile")->make(100), threads);
    step_to(*run, long_enough);
    ASSERT_GT(run->world().contacts.pairs.size(), 200U);
    hashes.push_back(run->hash());
  }
  EXPECT_EQ(hashes[1], hashes[0]);
  EXPECT_EQ(hashes[2], hashes[0]);
}

/// Bodies in rows, each pressed into its six neighbours from the first step on.
Scene block(const Effects& effects) {
  constexpr int side = 9;
  Scene scene;
  for (int k = 0; k < side * side * side; ++k) {
    const int row = k / side % side, layer = k / (side * side);
    const Vec3<double> place(k % side, row, layer);
    SceneBody b =
        made::body({{0.52, 0.51, 0.505}, 2, k % 2 == 0 ? 2.0 : 4.0}, place, 0.1 * Vec3<double>(k % 3, k % 5, -k % 7));
    b.angular_velocity = {0.1, -0.2, 0.3};
    scene.bodies.push_back(b);
  }
  scene.effects = effects;
  return scene;
}

// With so many contacts that threads are put to work on forces too.
TEST(Determinism, ThreadsThatShareForcesChangeNoBit) {
  Effects springs, sticky, patches;
  springs.linear = Linear{2e4};
  springs.damping = patches.damping = Damping{0.7};
  springs.friction = patches.friction = Friction{0.4, 0.3, 0.2};
  springs.rolling = Rolling{0.1};
  springs.twisting = Twisting{0.1};
  sticky.hertz = Hertz{3e4};
  sticky.cohesion = Cohesion{2, 0.02};
  sticky.dmt = Dmt{3};
  sticky.jkr = Jkr{5};
  patches.foundation = Foundation{2e4, 1.4};
  for (const Effects& effects : {springs, sticky, patches}) {
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2, 3}) {
      const auto run = started(block(effects), threads);
      step_to(*run, 12);
      EXPECT_GT(run->world().contacts.pressing.size(), 1200U);
      hashes.push_back(run->hash());
    }
    EXPECT_EQ(hashes[1], hashes[0]);
    EXPECT_EQ(hashes[2], hashes[0]);
  }
}

/// So many steps of it, none of them longer or shorter.
Scene cut(Scene scene, std::int64_t steps) {
  scene.run.time_step = make_plan(scene).time_step;
  scene.run.duration = *scene.run.time_step * static_cast<double>(steps);
  return scene;
}

TEST(Determinism, ASnapshotGoesOnAsIfNothingHadHappened) {
  for (const Scene& scene : varied_scenes())
    EXPECT_EQ(find_snapshot_change(cut(scene, long_enough), long_enough / 3), "") << scene.name;
}

// It stands where a later step finds none.
TEST(Determinism, ASnapshotHasEachContactsLastAnswer) {
  const Scene scene = crowd();
  const auto whole = started(scene), resumed = started(scene);
  step_to(*whole, 100);
  ASSERT_TRUE(resumed->restore(whole->snapshot()));
  ASSERT_FALSE(whole->world().contacts.touching.empty());
  for (const char* name : {"overlap", "normal", "arm1", "arm2", "inverse_mass"}) {
    const Column *last = whole->world().columns.find(name), *again = resumed->world().columns.find(name);
    ASSERT_NE(last, nullptr) << name;
    EXPECT_EQ(hash_of(again->values()), hash_of(last->values())) << name;
  }
}

// From any step, also one whose list is about to change.
TEST(Determinism, EverySnapshotGoesOn) {
  const Scene scene = crowd();
  const std::int64_t steps = make_plan(scene).steps;
  for (std::int64_t step = 17; step < steps; step += 17) ASSERT_EQ(find_snapshot_change(scene, step), "");
}

TEST(Determinism, LookingOnChangesNoBit) {
  const Scene scene = crowd();
  const auto alone = made::ended(scene), watched = started(scene);
  std::size_t notes = 0;
  watched->observe([&](std::span<const SolveNote> round) { notes += round.size(); });
  while (!watched->is_done()) {
    watched->step();
    (void)watched->energy();
    (void)watched->seconds();
  }
  EXPECT_EQ(watched->hash(), alone->hash());
  EXPECT_GT(notes, 0U);
}

TEST(Snapshot, OfAnotherSceneIsRefusedAndChangesNothing) {
  const auto run = started(crowd());
  step_to(*run, 10);
  const std::uint64_t before = run->hash();
  Scene fewer = crowd(), smooth = crowd();
  fewer.bodies.pop_back();
  smooth.effects.friction.reset();
  EXPECT_EQ(run->misfit(run->snapshot()).has_value(), false);
  EXPECT_EQ(started(smooth)->misfit(run->snapshot()).value_or(Simulation::Misfit{}).field, "columns.friction_spring");
  EXPECT_FALSE(run->restore(started(fewer)->snapshot()));
  EXPECT_FALSE(run->restore(started(smooth)->snapshot()));
  EXPECT_FALSE(started(smooth)->restore(run->snapshot()));
  EXPECT_EQ(run->hash(), before);
}

// The file of a checkpoint may say anything.
TEST(Snapshot, OfNoRunIsRefusedAndChangesNothing) {
  const auto run = started(crowd());
  step_to(*run, 10);
  const std::uint64_t before = run->hash();
  const Snapshot fine = run->snapshot();
  const auto refuses = [&](auto&& spoil) {
    Snapshot spoiled = fine;
    spoil(spoiled);
    return !run->restore(spoiled);
  };
  EXPECT_TRUE(refuses([](Snapshot& s) { s.pairs.back()[1] = 1000; }));
  EXPECT_TRUE(refuses([](Snapshot& s) { std::swap(s.pairs.back()[0], s.pairs.back()[1]); }));
  EXPECT_TRUE(refuses([](Snapshot& s) { std::swap(s.pairs.front(), s.pairs.back()); }));
  EXPECT_TRUE(refuses([](Snapshot& s) { s.columns.back() = s.columns.front(); }));
  EXPECT_TRUE(refuses([](Snapshot& s) { s.step = -1; }));
  EXPECT_TRUE(refuses([](Snapshot& s) { s.step = 1'000'000'000'000; }));
  EXPECT_EQ(run->hash(), before);
}

}  // namespace
}  // namespace plumb::scene
