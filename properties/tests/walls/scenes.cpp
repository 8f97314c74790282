// The named scenes in containers, with fewer bodies and for a shorter time.
#include <gtest/gtest.h>

#include "properties/tests/walls/made.hpp"
#include "solver/scene/named.hpp"
#include "solver/scene/named/named_scenes.hpp"

namespace plumb::scene {
namespace {

using made::position;
using made::started;
using made::Vec;

std::unique_ptr<Simulation> run_of(const char* name, int bodies, double duration) {
  Scene scene = find_named_scene(name)->make(bodies);
  scene.run.duration = duration;
  auto run = started(scene);
  while (!run->is_done()) run->step();
  EXPECT_EQ(run->totals().failed, 0);
  EXPECT_EQ(run->lost_body(), std::nullopt);
  return run;
}

TEST(WallScenes, ADrumCarriesItsBodies) {
  const auto run = run_of("drum", 24, 0.3);
  Vec middle = Vec::Zero();
  for (std::size_t i = 0; i < 24; ++i) {
    const Vec x = position(*run, i);
    EXPECT_LT(std::hypot(x.x(), x.z()), 0.08);
    EXPECT_LT(std::abs(x.y()), 0.03);
    middle += x / 24;
  }
  EXPECT_LT(middle.z(), -0.05);
  EXPECT_LT(middle.x(), -0.001);  // the lowest wall moves towards -x
}

TEST(WallScenes, ASiloLetsItsBodiesOut) {
  const auto run = run_of("silo", 20, 0.4);
  int out = 0;
  for (std::size_t i = 0; i < 20; ++i) {
    const Vec x = position(*run, i);
    if (x.z() > 0) {
      EXPECT_LT(std::hypot(x.x(), x.y()), 0.04);
    }
    EXPECT_GT(x.z(), -0.03);
    out += x.z() < -0.005 ? 1 : 0;
  }
  EXPECT_GT(out, 2);
}

TEST(WallScenes, ABladeStirsAPot) {
  const auto run = run_of("mixer", 24, 0.3);
  double turning = 0;
  for (std::size_t i = 0; i < 24; ++i) {
    const Vec x = position(*run, i), v = made::velocity(*run, i);
    EXPECT_LT(std::hypot(x.x(), x.y()), 0.04);
    EXPECT_GT(x.z(), 0);
    turning += x.x() * v.y() - x.y() * v.x();
  }
  EXPECT_GT(turning, 0);
}

}  // namespace
}  // namespace plumb::scene
