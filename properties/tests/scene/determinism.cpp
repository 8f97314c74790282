// The same bits: with any number of threads, and after a snapshot in mid-run.
#include <gtest/gtest.h>

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

// With so many pairs that threads are put to work.
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

TEST(Determinism, ASnapshotGoesOnAsIfNothingHadHappened) {
  for (const Scene& scene : varied_scenes()) {
    const auto whole = started(scene), resumed = started(scene);
    step_to(*whole, long_enough / 3);
    const Snapshot snapshot = whole->snapshot();
    step_to(*whole, long_enough);
    ASSERT_TRUE(resumed->restore(snapshot)) << scene.name;
    EXPECT_EQ(resumed->steps(), snapshot.step);
    step_to(*resumed, long_enough);
    EXPECT_EQ(resumed->hashes(), whole->hashes()) << scene.name;
    EXPECT_EQ(resumed->hash(), whole->hash()) << scene.name;
    EXPECT_EQ(resumed->totals().solves, whole->totals().solves) << scene.name;
    EXPECT_EQ(resumed->totals().evaluations, whole->totals().evaluations) << scene.name;
  }
}

// From any step, also one whose list is about to change.
TEST(Determinism, EverySnapshotGoesOn) {
  const Scene scene = crowd();
  const auto whole = made::ended(scene), running = started(scene);
  while (!running->is_done()) {
    running->step();
    if (running->steps() % 17 != 0) continue;
    const auto resumed = started(scene);
    ASSERT_TRUE(resumed->restore(running->snapshot()));
    while (!resumed->is_done()) resumed->step();
    ASSERT_EQ(resumed->hash(), whole->hash()) << running->steps();
  }
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
  EXPECT_FALSE(run->restore(started(fewer)->snapshot()));
  EXPECT_FALSE(run->restore(started(smooth)->snapshot()));
  EXPECT_FALSE(started(smooth)->restore(run->snapshot()));
  EXPECT_EQ(run->hash(), before);
}

}  // namespace
}  // namespace plumb::scene
