// Gravity, cohesion, drag, conduction and moving walls against closed forms.
#include <gtest/gtest.h>

#include "properties/tests/scene/made.hpp"

namespace plumb::scene {
namespace {

using made::ball;
using made::mass;
using made::position;
using made::Vec;
using made::velocity;

constexpr double pi = std::numbers::pi;

// A leapfrog is exact where the acceleration is constant: rounding of each step, and no more.
TEST(FreeFall, IsAParabolaToRounding) {
  const Vec start(1, 2, 3), thrown(4, -5, 6), acceleration(0.5, 0, -9.81);
  Scene scene;
  scene.bodies = {ball(1, start, thrown)};
  scene.effects.gravity = Gravity{acceleration};
  scene.run.duration = 2;
  scene.run.time_step = 1e-3;
  const auto run = made::ended(scene);
  const double t = run->time(), rounding = 2000 * 0x1p-52 * 20;
  EXPECT_EQ(t, 2);
  EXPECT_LE((position(*run, 0) - (start + thrown * t + acceleration * t * t / 2)).norm(), rounding);
  EXPECT_LE((velocity(*run, 0) - (thrown + acceleration * t)).norm(), rounding);
}

/// A ball that hangs from a ceiling by its cohesion, or falls: the overlap at the end.
double hanging_overlap(const Effects& elastic, double share_of_pull_off, double start) {
  Scene scene;
  scene.bodies = {ball(1, {0, 0, start - 1})};
  scene.walls = {{Vec::Zero(), -Vec::UnitZ(), {}}};
  scene.effects = elastic;
  scene.effects.damping = Damping{0.1};
  scene.effects.cohesion = Cohesion{100};
  scene.effects.gravity = Gravity{{0, 0, -share_of_pull_off * 100 / mass(scene.bodies[0])}};
  scene.run.duration = 1;
  const auto run = made::ended(scene);
  return position(*run, 0).z() + 1;
}

TEST(Cohesion, HoldsUpToThePullOffForce) {
  Effects linear, hertz;
  linear.linear = Linear{1e5};
  hertz.hertz = Hertz{1e6, 0};
  const double rest_of_pull = (1 - 0.99) * 100;
  const double linear_overlap = rest_of_pull / 1e5, hertz_overlap = std::pow(rest_of_pull / (4.0 / 3 * 5e5), 2.0 / 3);
  EXPECT_NEAR(hanging_overlap(linear, 0.99, linear_overlap / 2), linear_overlap, 1e-6 * linear_overlap);
  EXPECT_NEAR(hanging_overlap(hertz, 0.99, hertz_overlap / 2), hertz_overlap, 1e-6 * hertz_overlap);
  EXPECT_LT(hanging_overlap(linear, 1.01, linear_overlap / 2), -0.01);
  EXPECT_LT(hanging_overlap(hertz, 1.01, hertz_overlap / 2), -0.01);
}

// With a range the pull is that of a potential, which two bodies enter and leave with the same speed: order (omega dt)^2.
TEST(Cohesion, OfARangeKeepsEnergy) {
  Scene scene;
  scene.bodies = {ball(1, Vec::Zero(), {0.5, 0, 0}), ball(1, {2.5, 0, 0}, {-0.5, 0, 0})};
  scene.effects.linear = Linear{1e4};
  scene.effects.cohesion = Cohesion{30, 0.1};
  scene.run.duration = 2;
  scene.run.time_step = 1e-4;
  const auto run = made::started(scene);
  const double reduced = mass(scene.bodies[0]) / 2, omega = std::sqrt(1e4 / reduced);
  double fastest = 0;
  while (!run->is_done()) {
    run->step();
    fastest = std::max(fastest, velocity(*run, 0).x());
    EXPECT_NEAR(made::total_energy(*run), reduced / 2, std::pow(omega * 1e-4, 2) * reduced / 2);
  }
  // Down to where the spring, 1e4 x, holds the pull: 30^2 / 2e4 more than the range has.
  const double work = 30 * 0.1 / 2 + 30 * 30 / 2e4;
  EXPECT_NEAR(fastest, std::sqrt(1 + 2 * work / reduced) / 2, omega * 1e-4);
  EXPECT_NEAR(velocity(*run, 0).x(), -0.5, std::pow(omega * 1e-4, 2));
}

constexpr double viscosity = 0.05;

/// m / (6 pi viscosity r) of a ball of density 1.
double decay_time(double radius) {
  return 4.0 / 3 * pi * radius * radius * radius / (6 * pi * viscosity * radius);
}

Vec momentum(const Simulation& run) {
  return run.world().state.angular_momentum->vector(0);
}

// A step multiplies by 1 - x + x^2/2, x = dt/tau: t dt^2 / (6 tau^3) from the exponential.
TEST(Drag, SlowsExponentially) {
  const double tau = decay_time(0.5), spin_tau = 0.3 * tau;
  Scene scene;
  scene.bodies = {ball(0.5, Vec::Zero(), {1, 0, 0})};
  scene.bodies[0].angular_velocity = {0, 2, 0};
  scene.effects.drag = Drag{viscosity};
  scene.run.duration = tau;
  scene.run.time_step = tau / 1000;
  const auto run = made::ended(scene);
  const double left = std::exp(-run->time() / tau), spin_left = std::exp(-run->time() / spin_tau);
  const double first = 2 * 0.4 * 4.0 / 3 * pi * std::pow(0.5, 5);  // of the spin of 2
  EXPECT_NEAR(velocity(*run, 0).x(), left, 2e-7 * left);
  EXPECT_NEAR(momentum(*run).y(), first * spin_left, 2e-7 / (0.3 * 0.3 * 0.3) * first * spin_left);
}

/// A quarter of the error with half the step: of a body that turns about no axis of its own, and falls.
TEST(Drag, IsOfSecondOrder) {
  const auto momentum_after = [](double steps) {
    Scene scene;
    scene.bodies = {made::body({{2, 1, 0.5}}, Vec::Zero())};
    scene.bodies[0].angular_velocity = {1, 2, 0.5};
    scene.effects.gravity = Gravity{{0, 0, -10}};
    scene.effects.drag = Drag{viscosity};
    scene.run.duration = 1;
    scene.run.time_step = 1 / steps;
    return momentum(*made::ended(scene));
  };
  const Vec finest = momentum_after(3200);
  const double coarse = (momentum_after(100) - finest).norm(), fine = (momentum_after(200) - finest).norm();
  EXPECT_LE(coarse, 1e-3 * finest.norm());
  EXPECT_LE(fine, coarse / 3.8);
}

TEST(Drag, EndsAtTheTerminalVelocityInTheWind) {
  const double tau = decay_time(0.5);
  const Vec wind(1, 2, 0), g(0, 0, -10);
  Scene scene;
  scene.bodies = {ball(0.5, Vec::Zero())};
  scene.effects.gravity = Gravity{g};
  scene.effects.drag = Drag{viscosity, wind};
  scene.run.duration = 40 * tau;  // exp(-40) is rounding
  const Vec ends = velocity(*made::ended(scene), 0);
  EXPECT_LE((ends - (wind + g * tau)).norm(), 1e-12 * ends.norm());
}

TEST(Drag, OfAnEllipsoidIsThatOfTheSphereOfEqualVolume) {
  Scene scene;
  scene.bodies = {made::body({{2, 1, 0.5}}, Vec::Zero())};
  scene.effects.gravity = Gravity{{0, 0, -10}};
  scene.effects.drag = Drag{viscosity};
  scene.run.duration = 40 * decay_time(1);
  EXPECT_NEAR(velocity(*made::ended(scene), 0).z(), -10 * decay_time(1), 1e-10 * decay_time(1));
}

/// Two balls pressed into each other for good, because nothing pushes.
Scene warm_and_cold() {
  Scene scene;
  scene.bodies = {ball(1, Vec::Zero()), ball(0.5, {1.49, 0, 0})};
  scene.bodies[0].temperature = 400;
  scene.bodies[1].temperature = 300;
  scene.effects.conduction = Conduction{0.2, 3};
  return scene;
}

// The patch: radius sqrt(overlap R1 R2 / (R1 + R2)). Steps of 1 - rate dt: t dt rate^2 / 2 from the exponential.
TEST(Conduction, EqualisesExponentiallyAndKeepsTheHeat) {
  Scene scene = warm_and_cold();
  const double c1 = 3 * mass(scene.bodies[0]), c2 = 3 * mass(scene.bodies[1]);
  const double rate = 2 * 0.2 * std::sqrt(0.01 * 0.5 / 1.5) * (1 / c1 + 1 / c2);
  scene.run.duration = 1 / rate;
  scene.run.time_step = 1e-3 / rate;
  const auto run = made::ended(scene);
  const Column& temperature = *run->world().columns.find("temperature");
  EXPECT_NEAR((temperature[0] - temperature[1]) / 100, std::exp(-rate * run->time()), 1e-3 * std::exp(-1));
  EXPECT_NEAR(c1 * temperature[0] + c2 * temperature[1], c1 * 400 + c2 * 300, 1000 * 0x1p-52 * (c1 * 400 + c2 * 300));
}

// However well they conduct: a time step of its own keeps the explicit step stable.
TEST(Conduction, NeverOvershoots) {
  Scene scene = warm_and_cold();
  scene.effects.conduction = Conduction{1e4, 3};
  scene.run.duration = 1;
  const auto run = made::started(scene);
  const Column& temperature = *run->world().columns.find("temperature");
  while (!run->is_done()) {
    run->step();
    ASSERT_GE(temperature[0], temperature[1] - 1e-9);
    ASSERT_LE(temperature[0], 400);
  }
  EXPECT_NEAR(temperature[0], temperature[1], 1e-6);
}

TEST(Conduction, LeavesWallsAndFixedBodiesAsWarmAsTheyAre) {
  Scene scene;
  scene.bodies = {ball(1, {0, 0, 0.99}), ball(1, {1.99, 0, 0.99})};
  scene.bodies[0].temperature = scene.bodies[1].temperature = 300;
  scene.bodies[1].is_fixed = true;
  scene.walls = {made::floor_at()};
  scene.walls[0].temperature = 500;
  scene.effects.conduction = Conduction{0.2, 3};
  scene.run.duration = 6000;
  scene.run.time_step = 1;
  const auto run = made::ended(scene);
  const Column& temperature = *run->world().columns.find("temperature");
  EXPECT_EQ(temperature[1], 300);
  EXPECT_EQ(temperature[2], 500);
  // Patches sqrt(overlap R): 0.1 to the wall, sqrt(0.01/2) to the ball; between them the resistances share the difference.
  const double to_wall = 0.1, to_ball = std::sqrt(0.005);
  EXPECT_NEAR(temperature[0], (500 * to_wall + 300 * to_ball) / (to_wall + to_ball), 1e-6);
}

TEST(MovingWall, IsWhereItWasTold) {
  Scene scene;
  scene.bodies = {ball(0.1, {0, 0, 50})};
  scene.walls = {made::floor_at(1), made::floor_at(0)};
  scene.effects.linear = Linear{1};
  scene.effects.moving_walls = MovingWalls{{{1, {0, 0, 0.3}, {0.1, 0, 0.2}, 2}}};
  scene.run.duration = 1.3;
  scene.run.time_step = 0.01;
  const auto run = made::started(scene);
  while (!run->is_done()) {
    run->step();
    const double t = run->time();
    const Vec exact = Vec(0, 0, 0.3) * t + Vec(0.1, 0, 0.2) * std::sin(4 * pi * t);
    EXPECT_LE((position(*run, 2) - exact).norm(), 1e-14);
    EXPECT_EQ(position(*run, 1), Vec(0, 0, 1));
  }
}

TEST(MovingWall, CarriesWhatLiesOnIt) {
  Scene scene = made::Resting{}.scene();
  scene.effects.damping = Damping{0.1};
  scene.effects.moving_walls = MovingWalls{{{.wall = 0, .velocity = {0, 0, 2}}}};
  scene.run.duration = 0.2;
  const auto run = made::ended(scene);
  EXPECT_NEAR(velocity(*run, 0).z(), 2, 1e-9);
  EXPECT_NEAR(position(*run, 0).z() - position(*run, 1).z(), 1 - made::Resting{}.overlap, 1e-9);
}

// Shaken at 1 Hz, far below its own frequency: the overlap follows the acceleration, g - A w^2 sin(w t), to (w/own)^2.
TEST(MovingWall, ShakesWhatLiesOnIt) {
  const made::Resting resting;
  Scene scene = resting.scene();
  scene.effects.damping = Damping{0.1};
  const double amplitude = 0.1, turns = 2 * pi;
  scene.effects.moving_walls = MovingWalls{{{.wall = 0, .amplitude = {0, 0, amplitude}, .frequency = 1}}};
  scene.run.duration = 1.2;
  const auto run = made::ended(scene);
  const double weight = mass(scene.bodies[0]), own_square = made::Resting::stiffness / weight;
  const double acceleration = 10 - amplitude * turns * turns * std::sin(turns * run->time());
  const double overlap = 1 - (position(*run, 0).z() - position(*run, 1).z());
  const double lag = 2 * turns / std::sqrt(own_square);  // what the damper makes of it
  EXPECT_NEAR(overlap, acceleration / own_square, lag * acceleration / own_square);
}

}  // namespace
}  // namespace plumb::scene
