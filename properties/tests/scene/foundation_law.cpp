// The elastic foundation: stiffness times volume at the volume's centre, so that a face resists tilt and turning.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/tests/scene/made.hpp"

namespace plumb::scene {
namespace {

constexpr double winkler = 1e4;

/// A die of half 1 that is a hundredth deep in the floor.
Scene die_on_the_floor(double tilt, double exponent = 40) {
  Scene scene;
  SceneBody die = made::body({Vec3<double>::Ones(), exponent, exponent}, {0, 0, 0.99});
  die.body.quaternion = {std::cos(tilt / 2), std::sin(tilt / 2), 0, 0};
  scene.bodies = {die};
  scene.walls = {made::floor_at()};
  scene.effects.foundation = Foundation{winkler};
  scene.run.duration = 1;
  scene.run.accuracy = 1e-4;
  return scene;
}

/// Of a square of side 2 pressed in by d the volume is 4 d; its second moment 16/12. The edges are round: a tenth of the volume is missing.
TEST(FoundationLaw, OfAFaceIsThatOfAWinklerFoundation) {
  constexpr double force_of_square = winkler * 4 * 0.01, stiffness_of_square = winkler * 16 / 12;
  double first = 0;
  for (const double tilt : {1e-3, 1e-6, 1e-9, -1e-6, -1e-3}) {
    const auto run = made::started(die_on_the_floor(tilt));
    const double force = run->world().state.force->vector(0).z(), torque = run->world().state.torque->vector(0).x();
    EXPECT_TRUE(force < force_of_square && force > 0.88 * force_of_square) << tilt << ' ' << force;
    const double stiffness = -torque / tilt;
    EXPECT_TRUE(stiffness < stiffness_of_square && stiffness > 0.75 * stiffness_of_square) << tilt << ' ' << stiffness;
    if (first == 0) first = stiffness;
    EXPECT_NEAR(stiffness, first, 0.02 * first) << tilt;  // linear through zero
  }
}

/// Against the tilt of a flat face tilt_ratio times the moment of springs, and the same force.
TEST(FoundationLaw, ATiltRatioMultipliesTheMomentOfTheDepthThatVaries) {
  constexpr double tilt = 1e-5, of_square = winkler * 16 / 12;
  const auto wrench_at = [&](double ratio) {
    Scene scene = die_on_the_floor(tilt);
    scene.effects.foundation->tilt_ratio = ratio;
    const auto run = made::started(scene);
    return std::pair{run->world().state.force->vector(0).z(), run->world().state.torque->vector(0).x()};
  };
  const auto [force, torque] = wrench_at(1);
  for (const double ratio : {0.0, 1.4, 8.0 / 3}) {
    const auto [other_force, other_torque] = wrench_at(ratio);
    EXPECT_EQ(other_force, force);
    const double stiffness = (torque - other_torque) / (ratio - 1) / tilt;
    EXPECT_TRUE(stiffness < of_square && stiffness > 0.75 * of_square) << ratio << ' ' << stiffness;
  }
}

/// All pressure on a ball goes through its centre, that of dashpots too.
TEST(FoundationLaw, DashpotsDoNotSlowABallThatSpins) {
  for (const bool is_volume : {false, true}) {
    Scene scene;
    scene.bodies = {made::ball(1, {0, 0, 0.95}), made::body({{1, 0.8, 0.7}, 4, 4}, {0.3, 0, 2.5})};
    scene.bodies[0].angular_velocity = {3, 2, 1};
    scene.walls = {made::floor_at()};
    scene.effects.gravity = Gravity{{0, 0, -10}};
    scene.effects.damping = Damping{0.5};
    if (is_volume)
      scene.effects.volume = Volume{winkler, 1.5};
    else
      scene.effects.foundation = Foundation{winkler};
    scene.run.duration = 1;
    scene.run.accuracy = 1e-2;
    const auto run = made::ended(scene);
    EXPECT_TRUE(made::spin(*run, 0).isApprox(scene.bodies[0].angular_velocity, 1e-12)) << made::spin(*run, 0);
    EXPECT_GT(made::spin(*run, 1).norm(), 0.1);  // which fell on the ball
  }
}

TEST(FoundationLaw, AWallGivesBackWhatItTakes) {
  Stream stream("foundation law", 5, 1);
  for (const double exponent : {2.0, 8.0}) {
    Scene scene;
    SceneBody body = made::body({Vec3<double>(1, 0.8, 1.2), exponent, exponent}, {0, 0, 2.5}, {0.2, 0.1, -1});
    body.body.quaternion = {stream.uniform(), stream.uniform(), stream.uniform(), stream.uniform()};
    body.angular_velocity = {0.5, -0.3, 0.2};
    scene.bodies = {body};
    scene.walls = {made::floor_at()};
    scene.effects.foundation = Foundation{winkler};
    scene.run.duration = 3;
    scene.run.accuracy = 1e-2;
    const auto run = made::started(scene);
    const double start = made::total_energy(*run);
    while (!run->is_done()) run->step();
    EXPECT_GT(made::velocity(*run, 0).z(), 0);  // it has been there
    EXPECT_NEAR(made::total_energy(*run), start, 1e-4 * start) << exponent;
  }
}

/// A die that lies in the floor by its weight and rocks: dashpots c = 2 beta sqrt(k A m) over the patch take its energy as
/// exp(-c S t / I), S the patch's mean square of y. Those at its centre alone would take next to nothing.
TEST(FoundationLaw, DashpotsOverThePatchStopADieThatRocks) {
  constexpr double exponent = 8;
  Scene scene = die_on_the_floor(0, exponent);
  scene.run.accuracy = 1e-2;
  const double mass = made::mass(scene.bodies[0]), beta = -std::log(0.8) / std::hypot(std::numbers::pi, std::log(0.8));
  const auto lying = made::started(scene);
  const Contacts& contacts = lying->world().contacts;
  const double weight = lying->world().state.force->vector(0).z(),
               viscous = 2 * beta * std::sqrt(winkler * (*contacts.area)[0] * mass),
               square = std::pow(contacts.patch_radius(0), 2) / 2, moment = lying->world().bodies.inertia[0].x();
  scene.effects.gravity = Gravity{{0, 0, -weight / mass}};
  scene.effects.damping = Damping{0.8};
  scene.bodies[0].angular_velocity = {1e-3, 0, 0};
  constexpr double small = 1e-6;
  const double stiffness =
      -made::started(die_on_the_floor(small, exponent))->world().state.torque->vector(0).x() / small;
  const auto rocking = [&](const Simulation& run) {
    const double tilt = 2 * run.world().state.orientation_of(0).x(), spin = made::spin(run, 0).x();
    return (moment * spin * spin + stiffness * tilt * tilt) / 2;
  };
  for (const double halvings : {1.0, 4.0}) {
    scene.run.duration = halvings * std::log(2) * moment / (viscous * square);
    const auto run = made::started(scene);
    const double start = rocking(*run);
    while (!run->is_done()) run->step();
    EXPECT_NEAR(std::log2(start / rocking(*run)), halvings, 0.1 * halvings);
  }
}

/// Without a coefficient of twisting: what slides at the patch's radius stops.
TEST(FoundationLaw, FrictionStopsADieThatSpinsOnItsFace) {
  Scene scene = die_on_the_floor(0);
  scene.bodies[0].angular_velocity = {0, 0, 1};
  scene.effects.gravity = Gravity{{0, 0, -10}};
  scene.effects.damping = Damping{0.3};
  scene.effects.friction = Friction{.coefficient = 0.5, .damping = 0.3};
  scene.run.accuracy = 1e-2;
  const auto run = made::ended(scene);
  EXPECT_LT(made::spin(*run, 0).norm(), 1e-2);
}

}  // namespace
}  // namespace plumb::scene
