// Friction, rolling and twisting resistance of a ball on a floor, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>

#include "properties/tests/scene/crowd.hpp"
#include "properties/tests/scene/made.hpp"
#include "solver/scene/contact/stick_slip.hpp"
#include "solver/scene/part.hpp"

namespace plumb::scene {
namespace {

using made::ended;
using made::Resting;
using made::spin;
using made::started;
using made::Vec;
using made::velocity;

constexpr double g = Resting::g;
const Resting resting;

/// Of the ball about its centre, by its mass: 2/5 of radius 1.
constexpr double gyration = 0.4;

/// Damped springs, so that what they store when sliding ends does not ring on.
Friction rough(double coefficient) {
  return {.coefficient = coefficient, .damping = 0.5};
}

void step_until(Simulation& run, double time) {
  while (run.time() < time) run.step();
}

// The angular momentum about the contact, v arm + 2/5 w, is kept to rounding: friction has no moment there. Rolling, w arm = v.
TEST(Sliding, BecomesRollingAtFiveSevenths) {
  Scene scene = resting.scene();
  scene.bodies[0].velocity = {1, 0, 0};
  scene.effects.friction = rough(0.3);
  scene.run.duration = 0.3;
  const auto run = ended(scene);
  const double rolling = 1 / (1 + gyration / (resting.arm * resting.arm));
  EXPECT_NEAR(velocity(*run, 0).x(), rolling, 1e-9);
  EXPECT_NEAR(spin(*run, 0).y() * resting.arm, rolling, 1e-9);
  EXPECT_NEAR(rolling, 5.0 / 7, resting.overlap);
}

// Spring and dashpot together are at the limit as they slip, and where slipping begins, ends or turns back nothing jumps.
TEST(StickSlip, HasNoJumpAtItsLimit) {
  const StickSlip law{.stiffness = 1e3, .viscous = 20, .limit = 1};
  constexpr double step = 1e-9;  // what the force may change by: stiffness * stretch and viscous * rate, and no more
  for (const double rate : {-0.1, -0.04, 0.0, 0.04, 0.1}) {
    for (const double stretch : {-1.001e-3, -1e-3, -1e-3 + 1e-12, 1e-3 - 1e-12, 1e-3, 1.001e-3}) {
      Vec lower = {stretch - step, 0, 0}, upper = {stretch + step, 0, 0};
      const Vec force = law.pull(lower, {rate, 0, 0}, 0), next = law.pull(upper, {rate, 0, 0}, 0);
      EXPECT_LE(force.norm(), law.limit * (1 + 1e-15));
      EXPECT_NEAR(force.x(), next.x(), 2.1 * law.stiffness * step) << rate << " " << stretch;
      const double dashpot = std::clamp(law.viscous * rate, -law.limit, law.limit);
      EXPECT_NEAR(-law.stiffness * lower.x() - dashpot, force.x(), 1e-12);
      EXPECT_LE(lower.norm(), std::abs(stretch - step) * (1 + 1e-12));
    }
  }
}

// A ball that sticks: u'' + b u' + k/m' u = 0 of its point, m' the mass that a push across the normal feels there. The spring has a
// stiffness of its own, the dashpot twice the normal one's force / velocity.
TEST(Sticking, ByASpringAndAShareOfTheNormalDashpotIsADampedSwing) {
  constexpr double stiffness = 2e5, rate = 30, share = 2, speed = 1e-3;
  Scene scene = resting.scene();
  scene.effects.damping = Damping{.mass_velocity = rate};
  scene.effects.friction = {.coefficient = 10, .stiffness = stiffness, .normal_share = share};
  scene.bodies[0].velocity = {speed, 0, 0};
  const double mass = resting.weight / g, yield = 1 / mass * (1 + resting.arm * resting.arm / gyration);
  const double half = share * rate * mass * yield / 2, turns = std::sqrt(stiffness * yield - half * half);
  scene.run.duration = std::numbers::pi / turns;
  for (const int steps : {200, 400}) {
    scene.run.time_step = scene.run.duration / steps;
    const auto run = started(scene);
    double worst = 0;
    while (!run->is_done()) {
      run->step();
      const double t = run->time(), u = velocity(*run, 0).x() - spin(*run, 0).y() * resting.arm;
      const double expected = speed * std::exp(-half * t) * (std::cos(turns * t) - half / turns * std::sin(turns * t));
      worst = std::max(worst, std::abs(u - expected) / speed);
    }
    EXPECT_LT(worst, 4.0 / steps);  // order one, by the dashpot's velocity of half a step before
  }
}

TEST(Sliding, SlowsAsCoulombSays) {
  Scene scene = resting.scene();
  scene.bodies[0].velocity = {1, 0, 0};
  scene.effects.friction = rough(0.3);
  const double ends = (1 - 5.0 / 7) / (0.3 * g);
  scene.run.duration = ends;
  scene.run.outputs.contacts = true;
  const auto run = started(scene);
  step_until(*run, ends / 4);
  const double first = velocity(*run, 0).x(), from = run->time();
  step_until(*run, ends / 2);
  EXPECT_NEAR((first - velocity(*run, 0).x()) / (run->time() - from), 0.3 * g, 1e-9 * g);
  const Vec on_the_floor = run->world().contacts.force->vector(0);
  EXPECT_TRUE(on_the_floor.isApprox(resting.weight * Vec(0.3, 0, -1), 1e-9)) << on_the_floor.transpose();
}

// A belt under a ball at rest: the same, seen from the belt.
TEST(Sliding, OnABeltEndsAtTwoSeventhsOfItsSpeed) {
  Scene scene = resting.scene();
  scene.effects.friction = rough(0.3);
  scene.effects.moving_walls = MovingWalls{{{.wall = 0, .velocity = {1, 0, 0}}}};
  scene.run.duration = 0.3;
  const double rolling = 1 / (1 + gyration / (resting.arm * resting.arm));
  EXPECT_NEAR(velocity(*ended(scene), 0).x(), 1 - rolling, 1e-9);
}

/// Velocity down a slope at the half and at the end of a time: what acceleration is left once springs have come to rest.
double late_acceleration(const Scene& scene) {
  const auto run = started(scene);
  step_until(*run, scene.run.duration / 2);
  const double before = velocity(*run, 0).x(), from = run->time();
  while (!run->is_done()) run->step();
  return (velocity(*run, 0).x() - before) / (run->time() - from);
}

/// Springs swing to twice their load before they hold: the ball slips at first, and one per cent of the weight's part down the slope
/// takes a hundred times the springs' own time to stop it.
constexpr double comes_to_rest = 3;

/// A ball that a strong rolling resistance keeps from turning.
Scene block_on_slope(double slope, double coefficient) {
  Scene scene = resting.scene(slope);
  scene.effects.friction = rough(coefficient);
  scene.effects.rolling = Rolling{.coefficient = 10, .damping = 0.5};
  scene.run.duration = comes_to_rest;
  return scene;
}

TEST(Slope, HoldsJustBelowTheFrictionAngle) {
  for (const double coefficient : {0.2, 0.5, 1.0}) {
    const auto run = ended(block_on_slope(std::atan(0.99 * coefficient), coefficient));
    EXPECT_LE(velocity(*run, 0).norm(), 1e-6 * g * run->time()) << coefficient;
    EXPECT_LE(spin(*run, 0).norm(), 1e-6 * g * run->time()) << coefficient;
  }
}

TEST(Slope, SlidesJustAboveTheFrictionAngle) {
  for (const double coefficient : {0.2, 0.5, 1.0}) {
    const double slope = std::atan(1.01 * coefficient);
    const double exact = g * (std::sin(slope) - coefficient * std::cos(slope));
    EXPECT_NEAR(late_acceleration(block_on_slope(slope, coefficient)), exact, 1e-4 * exact) << coefficient;
  }
}

TEST(Slope, IsRolledDownWithFiveSevenths) {
  Scene scene = resting.scene(0.2);
  scene.effects.friction = rough(0.5);
  scene.run.duration = 0.4;
  const double exact = g * std::sin(0.2) / (1 + gyration / (resting.arm * resting.arm));
  EXPECT_NEAR(late_acceleration(scene), exact, 1e-6 * exact);
}

// Normals turn while springs are loaded: a spring that does not turn along pushes bodies apart.
TEST(Friction, SpringsStayAcrossTheNormal) {
  const auto run = started(crowd());
  const Column& springs = *run->world().columns.find("friction_spring");
  double longest = 0, greatest_along = 0;
  while (!run->is_done()) {
    run->step();
    for (const std::uint32_t c : run->world().contacts.touching) {
      longest = std::max(longest, springs.vector(c).norm());
      greatest_along =
          std::max(greatest_along, std::abs(springs.vector(c).dot(run->world().contacts.normal->vector(c))));
    }
  }
  EXPECT_GT(longest, 1e-3);
  EXPECT_LE(greatest_along, 8 * 0x1p-52 * longest);
}

/// A ball on a slope that cannot slide.
Scene roller_on_slope(double slope, double coefficient) {
  Scene scene = resting.scene(slope);
  scene.effects.friction = rough(2);
  scene.effects.rolling = Rolling{.coefficient = coefficient, .damping = 0.5};
  scene.run.duration = comes_to_rest;
  return scene;
}

// The moment of the weight about the contact, m g sin arm, against coefficient * arm * m g cos.
TEST(RollingResistance, HoldsJustBelowItsAngle) {
  for (const double coefficient : {0.05, 0.2}) {
    const auto run = ended(roller_on_slope(std::atan(0.99 * coefficient), coefficient));
    EXPECT_LE(velocity(*run, 0).norm(), 1e-6 * g * run->time()) << coefficient;
  }
}

TEST(RollingResistance, GivesWayJustAboveItsAngle) {
  for (const double coefficient : {0.05, 0.2}) {
    const double slope = std::atan(1.02 * coefficient);
    const double exact =
        g * (std::sin(slope) - coefficient * std::cos(slope)) / (1 + gyration / (resting.arm * resting.arm));
    EXPECT_NEAR(late_acceleration(roller_on_slope(slope, coefficient)), exact, 1e-4 * exact) << coefficient;
  }
}

TEST(RollingResistance, StopsARollingBall) {
  Scene scene = resting.scene();
  scene.bodies[0].velocity = {1, 0, 0};
  scene.bodies[0].angular_velocity = {0, 1 / resting.arm, 0};
  scene.effects.friction = rough(1);
  scene.effects.rolling = Rolling{.coefficient = 0.2, .damping = 0.5};
  const double slows = 0.2 * g / (1 + gyration / (resting.arm * resting.arm));
  scene.run.duration = 2 / slows;
  const auto run = started(scene);
  step_until(*run, 0.25 / slows);
  const double first = velocity(*run, 0).x(), from = run->time();
  step_until(*run, 0.75 / slows);
  EXPECT_NEAR((first - velocity(*run, 0).x()) / (run->time() - from), slows, 1e-3 * slows);
  while (!run->is_done()) run->step();
  EXPECT_LE(velocity(*run, 0).norm(), 1e-6);
  EXPECT_LE(spin(*run, 0).norm(), 1e-6);
}

// Inertia 2/5 m against coefficient * arm * m g, and nothing else turns.
TEST(TwistingResistance, StopsASpinningBallEvenly) {
  Scene scene = resting.scene();
  scene.bodies[0].angular_velocity = {0, 0, 3};
  scene.effects.twisting = Twisting{.coefficient = 0.1, .damping = 0.5};
  const double slows = 0.1 * resting.arm * g / gyration;
  scene.run.duration = 2 * 3 / slows;
  const auto run = started(scene);
  step_until(*run, 1 / slows);
  const double first = spin(*run, 0).z(), from = run->time();
  step_until(*run, 2 / slows);
  EXPECT_NEAR((first - spin(*run, 0).z()) / (run->time() - from), slows, 1e-9 * slows);
  while (!run->is_done()) run->step();
  EXPECT_LE(spin(*run, 0).norm(), 1e-6);
  EXPECT_LE(velocity(*run, 0).norm(), 1e-9);
}

TEST(TwistingResistance, LetsABallRoll) {
  Scene scene = resting.scene(0.2);
  scene.effects.friction = rough(0.5);
  scene.effects.twisting = Twisting{.coefficient = 5};
  scene.run.duration = 0.4;
  const double exact = g * std::sin(0.2) / (1 + gyration / (resting.arm * resting.arm));
  EXPECT_NEAR(late_acceleration(scene), exact, 1e-6 * exact);
}

/// A ball on a floor that is led by hand, sticking.
class LedBall {
 public:
  LedBall() {
    PartSettings settings;
    settings.effects.hertz = Hertz{1e4};
    settings.effects.friction = Friction{.coefficient = 1e6};
    settings.walls = {made::floor_at()};
    part_ = std::make_unique<Part>(settings);
    part_->renew(std::array{made::ball(1, Vec(0, 0, 0))}, {{0, 1}});
  }

  /// So much deeper and across, in small steps. What was done to the ball.
  double move(double deeper, double across) {
    constexpr int steps = 2000;
    const Vec velocity(across, 0, -deeper);
    double work = 0;
    for (int i = 0; i < steps; ++i) {
      const double before = force();
      at_ += velocity / steps;
      part_->place(0, at_, velocity, {1, 0, 0, 0}, Vec::Zero());
      part_->press(0, 1.0 / steps);
      work -= (before + force()) / 2 * across / steps;
    }
    return work;
  }
  /// Along x.
  [[nodiscard]] double force() const { return part_->world().state.force->vector(0).x(); }
  [[nodiscard]] double stored() {
    const auto all = [](std::size_t /*contact*/) { return true; };
    const double whole = part_->energy(all), depth = 1 - at_.z();
    return whole - 2.0 / 5 * normal_factor() * std::pow(depth, 2.5);
  }

 private:
  [[nodiscard]] static double normal_factor() { return 4.0 / 3 * Hertz{1e4}.contact_modulus(); }

  std::unique_ptr<Part> part_;
  Vec at_{0, 0, 1};
};

// The stiffness goes as the root of the depth.
TEST(StickingInHertzContact, KeepsItsForceAsItIsPressedAndGivesWayAsItIsLetGo) {
  LedBall ball;
  ball.move(1e-3, 0);
  ball.move(0, 1e-5);
  const double held = ball.force();
  EXPECT_LT(held, 0);
  ball.move(3e-3, 0);
  EXPECT_NEAR(ball.force() / held, 1, 1e-9);
  ball.move(-3e-3, 0);
  EXPECT_NEAR(ball.force() / held, 0.5, 1e-9);
}

// Pressed between there and back: a spring that stiffens with what it holds gives more than it took.
TEST(StickingInHertzContact, MakesNoEnergy) {
  LedBall ball;
  ball.move(1e-3, 0);
  double work = ball.move(0, 1e-5);
  EXPECT_NEAR(ball.stored(), work, 1e-9 * work);
  work += ball.move(3e-3, 0);
  EXPECT_LT(ball.stored(), work);
  work += ball.move(0, -1e-5);
  work += ball.move(-3e-3, 0);
  EXPECT_GT(work, 0);
  EXPECT_LE(ball.stored(), work);
}

}  // namespace
}  // namespace plumb::scene
