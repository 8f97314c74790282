// Adhesion against closed forms: forces at an overlap, what a collision loses, where bodies come to rest.
#include <gtest/gtest.h>

#include "properties/tests/scene/made.hpp"

namespace plumb::scene {
namespace {

using made::ball;
using made::Vec;

constexpr Hertz soft{.youngs_modulus = 1e6, .poissons_ratio = 0.3};
constexpr double work = 5, pi_work = std::numbers::pi * work;

/// A body above the floor, its lowest point at -overlap, with Hertz's force.
Scene on_floor(SceneBody b, double overlap) {
  Scene scene;
  b.body.position = {0, 0, b.body.shape.semi_axes[2] - overlap};
  scene.bodies = {b};
  scene.walls = {made::floor_at()};
  scene.effects.hertz = soft;
  scene.run.duration = 1;
  return scene;
}

double force_at_start(const Scene& scene) {
  const auto run = made::started(scene);
  const Contacts& contacts = run->world().contacts;
  return contacts.touching.empty() ? 0 : (*contacts.normal_force)[contacts.touching.front()];
}

/// s of jkr.hpp, of a ball of radius R on a plane.
double jkr_scale(double radius) {
  return std::cbrt(pi_work * radius * radius / (8 * soft.contact_modulus()));
}

/// The radius of the patch from the overlap by halving, and the force by it: the paper's own form.
double jkr_force(double overlap, double radius) {
  const double modulus = soft.contact_modulus();
  const auto overlap_of = [&](double a) { return a * a / radius - std::sqrt(2 * pi_work * a / modulus); };
  double low = jkr_scale(radius), high = 100 * low;
  for (int k = 0; k < 200; ++k) (overlap_of((low + high) / 2) < overlap ? low : high) = (low + high) / 2;
  return 4 * modulus * low * low * low / (3 * radius) - std::sqrt(8 * pi_work * modulus * low * low * low);
}

TEST(Jkr, HasTheForceOfThePaper) {
  for (const double radius : {0.5, 1.0, 3.0})
    for (const double overlap : {1e-9, 1e-4, 1e-3, 5e-3, 2e-2, 0.1}) {
      Scene scene = on_floor(ball(radius, Vec::Zero()), overlap);
      scene.effects.jkr = Jkr{work};
      const double wanted = jkr_force(overlap, radius);
      EXPECT_NEAR(force_at_start(scene), wanted, 1e-8 * std::abs(wanted) + 1e-8 * work * radius)
          << radius << ' ' << overlap;
    }
}

TEST(Jkr, PullsByFourThirdsWhereBodiesMeet) {
  Scene scene = on_floor(ball(1, Vec::Zero()), 1e-14);
  scene.effects.jkr = Jkr{work};
  EXPECT_NEAR(force_at_start(scene), -4.0 / 3 * pi_work, 1e-6 * work);
}

/// A ball that comes down with this speed and has left again, or has had the time to.
std::unique_ptr<Simulation> after_collision(const Effects& effects, double speed, double accuracy = 1e-5) {
  Scene scene = on_floor(ball(1, Vec::Zero(), {0, 0, -speed}), -1e-3);
  scene.effects = effects;
  scene.run.accuracy = accuracy;
  scene.run.duration = 0.02 / speed + 0.2;
  return made::ended(scene);
}

// 7.09 (w^5 R^4 / E*^2)^(1/3) of its energy are gone, whatever it had.
TEST(Jkr, LosesTheSameInEachCollision) {
  Effects effects;
  effects.hertz = soft;
  effects.jkr = Jkr{work};
  const double lost = 7.09 * std::cbrt(std::pow(work, 5) / std::pow(soft.contact_modulus(), 2));
  const double mass = made::mass(ball(1, Vec::Zero())), sticks_below = std::sqrt(2 * lost / mass);
  for (const double speed : {2 * sticks_below, 5 * sticks_below}) {
    const auto run = after_collision(effects, speed);
    const double wanted = std::sqrt(speed * speed - 2 * lost / mass);
    EXPECT_NEAR(made::velocity(*run, 0)[2], wanted, 3e-3 * speed) << speed;
    EXPECT_GT(made::position(*run, 0)[2], 1.001);
  }
  const auto run = after_collision(effects, 0.9 * sticks_below);
  EXPECT_LT(made::position(*run, 0)[2], 1 + 3 * std::pow(jkr_scale(1), 2));
}

TEST(Jkr, ComesToRestWhereItHasNoForce) {
  Scene scene = on_floor(ball(1, Vec::Zero()), 1e-5);
  scene.effects.jkr = Jkr{work};
  scene.effects.damping = Damping{0.05};
  scene.run.duration = 3;
  const auto run = made::ended(scene);
  const double scale = jkr_scale(1);
  EXPECT_NEAR(1 - made::position(*run, 0)[2], 2 * std::cbrt(6.0) * scale * scale, 1e-6 * scale * scale);
}

// A pull beyond the overlap of 0, and none of what was never together.
TEST(Jkr, HoldsWhatItHeldAndNothingElse) {
  Scene scene = on_floor(ball(1, Vec::Zero(), {0, 0, 0.01}), 1e-6);
  scene.effects.jkr = Jkr{work};
  scene.run.accuracy = 1e-4;
  const auto run = made::started(scene);
  double highest = 0;
  for (int k = 0; k < 2000; ++k) {
    run->step();
    highest = std::max(highest, made::position(*run, 0)[2] - 1);
  }
  EXPECT_GT(highest, 0);  // it was let go up, and came back
  EXPECT_LT(made::position(*run, 0)[2], 1);
  Scene apart = on_floor(ball(1, Vec::Zero()), -jkr_scale(1) * jkr_scale(1));
  apart.effects.jkr = Jkr{work};
  EXPECT_EQ(force_at_start(apart), 0);
}

TEST(Jkr, IsHertzWithoutAdhesion) {
  Scene scene = on_floor(made::body({Vec(1, 0.8, 0.6)}, Vec::Zero()), 1e-2);
  const double hertz = force_at_start(scene);
  scene.effects.jkr = Jkr{1e-9};
  EXPECT_NEAR(force_at_start(scene), hertz, 1e-4 * hertz);
}

// An ellipsoid on its pole: A = c / (2 a^2), B = c / (2 b^2).
TEST(Dmt, PullsByTheWorkOverTheCurvatures) {
  const Vec axes(1, 0.8, 0.6);
  Scene scene = on_floor(made::body({axes}, Vec::Zero()), 1e-3);
  const double hertz = force_at_start(scene);
  scene.effects.dmt = Dmt{work};
  const double wanted = pi_work * 2 * axes[0] * axes[1] / axes[2];
  EXPECT_NEAR(hertz - force_at_start(scene), wanted, 1e-9 * wanted);
}

TEST(Dmt, LosesNothing) {
  Effects effects;
  effects.hertz = soft;
  effects.dmt = Dmt{work};
  for (const double speed : {0.5, 2.0}) {
    const auto run = after_collision(effects, speed);
    EXPECT_NEAR(made::velocity(*run, 0)[2], speed, 1e-3 * speed);
  }
}

TEST(Adhesion, NeedsAnElasticForce) {
  const auto refusal = [](const std::function<void(Effects&)>& change) -> std::string {
    Scene scene = on_floor(ball(1, Vec::Zero()), 1e-3);
    scene.effects = {};
    change(scene.effects);
    try {
      (void)make_plan(scene);
    } catch (const SceneError& error) {
      return error.field + ": " + error.what();
    }
    return {};
  };
  EXPECT_EQ(refusal([](Effects& e) { e.jkr = Jkr{1}, e.linear = Linear{1e4}; }),
            "effects.jkr: is Hertz's contact with adhesion, and there is none: add hertz");
  EXPECT_EQ(refusal([](Effects& e) { e.jkr = Jkr{1}, e.hertz = Hertz{}; }),
            "effects.jkr: pulls bodies into each other, and the elastic force is 0");
  EXPECT_EQ(refusal([](Effects& e) { e.dmt = Dmt{1}, e.hertz = Hertz{}; }),
            "effects.dmt: pulls bodies into each other, and the elastic force is 0");
}

}  // namespace
}  // namespace plumb::scene
