// Collisions against closed forms: how long, how deep, how fast afterwards.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/tests/scene/made.hpp"
#include "solver/scene/hertz_contact.hpp"
#include "solver/scene/named.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::scene {
namespace {

using made::ball;
using made::ended;
using made::mass;
using made::started;
using made::Vec;

/// A collision as it was seen from step to step.
struct Seen {
  double lasted = 0;  ///< steps with contact, as a time
  double deepest = 0;
};

Seen watch(Simulation& run) {
  Seen seen;
  while (!run.is_done()) {
    run.step();
    for (const std::uint32_t c : run.world().contacts.touching) {
      seen.lasted += run.plan().time_step;
      seen.deepest = std::max(seen.deepest, (*run.world().contacts.overlap)[c]);
    }
  }
  return seen;
}

/// force = factor overlap^(3/2), bodies of this reduced mass that meet at this speed (Johnson 1985, eqs. 11.23-11.24).
struct HertzCollision {
  double factor, mass, speed;
  [[nodiscard]] double deepest() const { return std::pow(5 * mass * speed * speed / (4 * factor), 0.4); }
  [[nodiscard]] double lasts() const {
    const double shape = 0.8 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9);  // 2.9433
    return shape * deepest() / speed;
  }
};

constexpr int steps_a_collision = 400;

/// A leapfrog's error is of the order (omega dt)^2 = (pi / steps)^2, and each end of a contact is known to a step.
void expect_collision(Scene scene, const HertzCollision& exact) {
  scene.run.time_step = exact.lasts() / steps_a_collision;
  scene.run.duration = 2 * exact.lasts();
  const auto run = started(scene);
  const Seen seen = watch(*run);
  const double order2 = std::pow(std::numbers::pi / steps_a_collision, 2);
  EXPECT_NEAR(seen.deepest, exact.deepest(), order2 * exact.deepest());
  EXPECT_NEAR(seen.lasted, exact.lasts(), 1.01 * *scene.run.time_step);
  EXPECT_EQ(run->totals().failed, 0);
}

constexpr double youngs_modulus = 1e9, poissons_ratio = 0.3;
constexpr double contact_modulus = youngs_modulus / (2 * (1 - poissons_ratio * poissons_ratio));

Scene hertz_scene() {
  Scene scene;
  scene.effects.hertz = Hertz{youngs_modulus, poissons_ratio};
  return scene;
}

TEST(HertzCollision, OfTwoBallsLastsAndIsAsDeepAsInTheBooks) {
  for (const double radius2 : {1.0, 0.3, 4.0}) {
    Scene scene = hertz_scene();
    scene.bodies = {ball(1, Vec::Zero(), {0.5, 0, 0}), ball(radius2, {1 + radius2, 0, 0}, {-0.5, 0, 0})};
    const double m1 = mass(scene.bodies[0]), m2 = mass(scene.bodies[1]);
    const double factor = 4.0 / 3 * contact_modulus * std::sqrt(radius2 / (1 + radius2));
    expect_collision(scene, {factor, m1 * m2 / (m1 + m2), 1});
  }
}

TEST(HertzCollision, OfABallWithAWallLastsAndIsAsDeepAsInTheBooks) {
  Scene scene = hertz_scene();
  scene.bodies = {ball(0.7, {0, 0, 0.7}, {0, 0, -2})};
  scene.walls = {made::floor_at()};
  expect_collision(scene, {4.0 / 3 * contact_modulus * std::sqrt(0.7), mass(scene.bodies[0]), 2});
}

// Radii of curvature at the end of axis c: a^2/c and b^2/c; the gap to a plane is x^2/2R1 + y^2/2R2.
TEST(HertzCollision, OfAnEllipsoidAlongItsAxisHasAnEllipticPatch) {
  Scene scene = hertz_scene();
  scene.bodies = {made::body({{1.2, 0.6, 0.8}}, {0, 0, 0.8}, {0, 0, -1})};
  scene.walls = {made::floor_at()};
  const double a = 0.8 / (2 * 1.2 * 1.2), b = 0.8 / (2 * 0.6 * 0.6);
  expect_collision(scene, {contact_modulus * hertz_contact(a, b).force_factor, mass(scene.bodies[0]), 1});
}

/// Greatest difference of the overlap from the half sine, and of the speeds after it, relative.
double error_of_impact(double accuracy) {
  Scene scene = find_named_scene("impact")->make(0);
  scene.run.accuracy = accuracy;
  const double m1 = mass(scene.bodies[0]), m2 = mass(scene.bodies[1]), reduced = m1 * m2 / (m1 + m2);
  const double omega = std::sqrt(scene.effects.linear->stiffness / reduced), speed = 1, start = 1e-3 / speed;
  const auto run = started(scene);
  double worst = 0;
  while (!run->is_done()) {
    run->step();
    const double phase = omega * (run->time() - start);
    const double exact = phase > 0 && phase < std::numbers::pi ? speed / omega * std::sin(phase) : 0;
    const auto& contacts = run->world().contacts;
    const double overlap = contacts.touching.empty() ? 0 : (*contacts.overlap)[contacts.touching[0]];
    worst = std::max(worst, std::abs(overlap - exact) * omega / speed);
  }
  const double after = (scene.bodies[0].velocity.x() * (m1 - m2) + 2 * m2 * scene.bodies[1].velocity.x()) / (m1 + m2);
  return std::max(worst, std::abs(made::velocity(*run, 0).x() - after) / speed);
}

// Steps are as the root of the accuracy; 10 of the least contact mass's collision are (pi/24)^2 of this one's phase squared.
TEST(Impact, IsTheHalfSineToSecondOrder) {
  const double coarse = error_of_impact(1e-2), middle = error_of_impact(1e-4), fine = error_of_impact(1e-6);
  EXPECT_LE(coarse, 2e-2);
  EXPECT_LE(fine, coarse * 1e-3);  // 1e-4 but for where in a step the contact starts
  EXPECT_LE(middle, coarse * 0.1);
}

/// Relative velocity along the normal of a wall with normal z, at the point of body 0 that is deepest in it.
double wall_velocity(const Simulation& run) {
  const auto q = run.world().state.orientation->entry(0);
  const Eigen::Quaterniond turn(q[0], q[1], q[2], q[3]);
  const Vec down = turn.conjugate() * Vec(-Vec::UnitZ());
  const Vec arm = turn * Vec(support_point<double>(run.world().bodies.shape[0], down).gradient);
  const Vec spin = run.world().has_turning() ? made::spin(run, 0) : Vec::Zero();
  return made::velocity(run, 0).z() + spin.cross(arm).z();
}

/// After / before, of the one collision there is.
double restitution_of(Simulation& run) {
  double before = 0;
  bool has_touched = false;
  while (!run.is_done()) {
    const double now = wall_velocity(run);
    run.step();
    const bool touches = !run.world().contacts.touching.empty();
    if (!has_touched) before = now;
    if (has_touched && !touches) break;
    has_touched = has_touched || touches;
  }
  return -wall_velocity(run) / before;
}

constexpr double impact_speed = 1;

/// A ball of density 1 falls on a wall; `steps` for a collision of the linear force without damping.
double ball_restitution(Scene scene, double lasts, int steps) {
  scene.bodies = {ball(1, {0, 0, 1.001 * 1}, {0, 0, -impact_speed})};
  scene.walls = {made::floor_at()};
  scene.run.time_step = lasts / steps;
  scene.run.duration = 0.001 / impact_speed + 4 * lasts;
  return restitution_of(*started(scene));
}

double ball_mass() {
  return mass(ball(1, Vec::Zero()));
}

// The kicks take the velocity half a step late: first order, so a step's share of the decay, 2 beta omega dt.
TEST(Restitution, OfTheLinearForceIsWhatWasAsked) {
  const double lasts = std::numbers::pi * std::sqrt(ball_mass() / 1e7);
  for (const double e : {0.9, 0.5, 0.1}) {
    Scene scene;
    scene.effects.linear = Linear{1e7};
    scene.effects.damping = Damping{e};
    for (const int steps : {200, 2000})
      EXPECT_NEAR(ball_restitution(scene, lasts, steps), e, -2 * std::log(e) / steps) << steps;
  }
}

TEST(Restitution, OfTheHertzForceIsWhatWasAsked) {
  const double lasts = HertzCollision{4.0 / 3 * contact_modulus, ball_mass(), impact_speed}.lasts();
  for (const double e : {0.9, 0.5, 0.1}) {
    Scene scene = hertz_scene();
    scene.effects.damping = Damping{e};
    for (const int steps : {200, 2000})
      EXPECT_NEAR(ball_restitution(scene, lasts, steps), e, -2 * std::log(e) / steps) << steps;
  }
}

TEST(Restitution, IsOneWithoutDamping) {
  Scene linear, hertz = hertz_scene();
  linear.effects.linear = Linear{1e7};
  const double lasts = std::numbers::pi * std::sqrt(ball_mass() / 1e7);
  const double order2 = std::pow(std::numbers::pi / 400, 2);
  EXPECT_NEAR(ball_restitution(linear, lasts, 400), 1, order2);
  EXPECT_NEAR(ball_restitution(hertz, HertzCollision{4.0 / 3 * contact_modulus, ball_mass(), 1}.lasts(), 400), 1,
              order2);
}

/// An ellipsoid in some orientation, spinning, just above a wall.
Scene tilted_fall(std::uint64_t index, double stiffness) {
  Stream stream("tilted fall", 1, index);
  Scene scene;
  scene.bodies = {made::body({{1, 0.7, 0.5}}, Vec::Zero(), {stream.uniform(-1, 1), 0, -1})};
  SceneBody& b = scene.bodies[0];
  for (double& x : b.body.quaternion) x = stream.uniform(-1, 1);
  for (double& x : b.angular_velocity) x = stream.uniform(-0.3, 0.3);
  const auto& q = b.body.quaternion;
  const Eigen::Quaterniond turn = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized();
  const double lasts = std::numbers::pi * std::sqrt(mass(b) / stiffness);
  b.body.position.z() = support<double>(b.body.shape, turn.conjugate() * Vec(-Vec::UnitZ())) + 0.1 * lasts;
  scene.walls = {made::floor_at()};
  scene.effects.linear = Linear{stiffness};
  scene.run.time_step = lasts / 2000;
  scene.run.duration = 3 * lasts;
  return scene;
}

// The effective mass is constant only for as long as nothing turns: the error goes with the duration, the turn in it being of order
// speed * duration / size. It is tested as a law of the stiffness: a hundredfold one is ten times closer.
TEST(Restitution, OffCentreIsThatOfTheNormalVelocityAtTheContact) {
  for (const double e : {1.0, 0.6})
    for (std::uint64_t i = 0; i < 6; ++i)
      for (const double stiffness : {1e6, 1e8}) {
        Scene scene = tilted_fall(i, stiffness);
        if (e < 1) scene.effects.damping = Damping{e};
        const double turned = std::numbers::pi * std::sqrt(mass(scene.bodies[0]) / stiffness);
        EXPECT_NEAR(restitution_of(*started(scene)), e, 4 * turned + 1e-3) << i << ' ' << stiffness;
      }
}

}  // namespace
}  // namespace plumb::scene
