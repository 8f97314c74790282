// Lives of contacts against closed forms: how long, how deep, how strong.
#include <gtest/gtest.h>

#include "properties/tests/scene/made.hpp"

namespace plumb::scene {
namespace {

using made::ball;
using made::Vec;

Scene collision(double duration) {
  Scene scene;
  scene.bodies = {ball(1, Vec(0, 0, 1.003), Vec(0, 0, -1))};
  scene.walls = {made::floor_at()};
  scene.effects.linear = Linear{.stiffness = 1e6};
  scene.run.duration = duration;
  scene.run.accuracy = 1e-4;
  scene.run.outputs.lives = true;
  return scene;
}

TEST(Lives, OfACollisionAreThoseOfASpring) {
  const Scene scene = collision(0.02);
  const double rate = std::sqrt(1e6 / made::mass(scene.bodies[0]));
  const auto run = made::started(scene);
  std::vector<Life> lives;
  while (!run->is_done()) {
    run->step();
    lives.insert(lives.end(), run->ended_lives().begin(), run->ended_lives().end());
  }
  ASSERT_EQ(lives.size(), 1U);
  const Life& life = lives[0];
  EXPECT_TRUE(life.has_ended);
  EXPECT_EQ(life.body1, 0U);
  EXPECT_EQ(life.body2, 1U);
  EXPECT_NEAR(life.start, 0.003, 1e-3 / rate);
  EXPECT_NEAR(life.duration, std::numbers::pi / rate, 1e-3 / rate);
  EXPECT_NEAR(life.greatest_overlap, 1 / rate, 1e-3 / rate);
  EXPECT_NEAR(life.greatest_force.value_or(0), 1e6 / rate, 1e3 / rate);
  EXPECT_TRUE(run->lasting_lives().empty());
}

TEST(Lives, OfOneThatGoesOn) {
  const auto run = made::ended(collision(0.005));
  const std::vector<Life> lives = run->lasting_lives();
  ASSERT_EQ(lives.size(), 1U);
  EXPECT_FALSE(lives[0].has_ended);
  EXPECT_NEAR(lives[0].start + lives[0].duration, run->time(), 1e-15);
}

// What is followed changes nothing of what moves.
TEST(Lives, ChangeNoBitOfTheMotion) {
  Scene scene = collision(0.02);
  const auto with = made::ended(scene);
  scene.run.outputs.lives = false;
  const auto without = made::ended(scene);
  EXPECT_EQ(made::position(*with, 0), made::position(*without, 0));
  EXPECT_EQ(made::velocity(*with, 0), made::velocity(*without, 0));
  EXPECT_EQ(without->world().columns.find("life"), nullptr);
}

}  // namespace
}  // namespace plumb::scene
