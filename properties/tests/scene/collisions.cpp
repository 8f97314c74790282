// Collisions against closed forms: how long, how deep, how fast afterwards.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/tests/scene/made.hpp"
#include "solver/method/automatic.hpp"
#include "solver/scene/contact/hertz_contact.hpp"
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
  const double omega = std::sqrt(scene.effects.linear.value_or(Linear{}).stiffness / reduced), speed = 1,
               start = 1e-3 / speed;
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

/// The normal of the one contact there is, and its arms about both centres.
struct Line {
  Vec normal, arm1 = Vec::Zero(), arm2 = Vec::Zero();

  explicit Line(const Contacts& contacts) : normal(contacts.normal->vector(0)) {
    if (contacts.arm1 == nullptr) return;
    arm1 = contacts.arm1->vector(0);
    arm2 = contacts.arm2->vector(0);
  }
  /// Of body 2's point of contact as body 1's sees it.
  [[nodiscard]] double velocity(const Simulation& run) const {
    const double shift = normal.dot(made::velocity(run, 1) - made::velocity(run, 0));
    if (!run.world().has_turning()) return shift;
    return shift + arm2.dot(made::spin(run, 1)) - arm1.dot(made::spin(run, 0));
  }
};

/// Normal velocity after / before, of the one collision there is of the one pair there is; a wall is body 1. With the motion of the
/// step before the first touch and after the last one, along the normals of those two.
double restitution_of(Simulation& run) {
  const Contacts& contacts = run.world().contacts;
  std::optional<Line> last;
  double before = 0;
  Vec start1 = made::velocity(run, 0), start2 = made::velocity(run, 1);
  Vec spin1 = Vec::Zero(), spin2 = Vec::Zero();
  if (run.world().has_turning()) spin1 = made::spin(run, 0), spin2 = made::spin(run, 1);
  while (!run.is_done()) {
    run.step();
    if (contacts.touching.empty() && last) return -last->velocity(run) / before;
    if (contacts.touching.empty()) continue;
    const bool is_first = !last;
    last.emplace(contacts);
    if (is_first) before = last->normal.dot(start2 - start1) + last->arm2.dot(spin2) - last->arm1.dot(spin1);
  }
  ADD_FAILURE() << "no collision, or no end of it";
  return 0;
}

constexpr double impact_speed = 1;

/// A ball of density 1 falls on a wall from this much more than a thousandth of its radius.
double ball_restitution(Scene scene, double lasts, double step, double higher = 0) {
  scene.bodies = {ball(1, {0, 0, 1.001 + higher}, {0, 0, -impact_speed})};
  scene.walls = {made::floor_at()};
  scene.run.time_step = step;
  scene.run.duration = 0.001 / impact_speed + 4 * lasts;
  return restitution_of(*started(scene));
}

double ball_mass() {
  return mass(ball(1, Vec::Zero()));
}

/// Wherever in a step the bodies meet: the worst of so many places.
constexpr int places = 37;

// Order two: at accuracy a there are 1/sqrt(a) steps a collision, and e errs by a few times a, more the faster the dashpot is.
TEST(Restitution, OfTheLinearForceErrsByAFewTimesTheAccuracy) {
  const double lasts = std::numbers::pi * std::sqrt(ball_mass() / 1e7);
  for (const double e : {0.9, 0.5, 0.2})
    for (const double accuracy : {1e-3, 1e-4, 1e-5}) {
      Scene scene;
      scene.effects.linear = Linear{1e7};
      scene.effects.damping = Damping{e};
      const double step = lasts * std::sqrt(accuracy);
      for (int k = 0; k < places; ++k) {
        const double measured = ball_restitution(scene, lasts, step, impact_speed * step * k / places);
        EXPECT_NEAR(measured / e, 1, (2 - 6 * std::log(e)) * accuracy) << e << ' ' << accuracy << ' ' << k;
      }
    }
}

TEST(Restitution, OfTheHertzForceIsWhatWasAsked) {
  const double lasts = HertzCollision{4.0 / 3 * contact_modulus, ball_mass(), impact_speed}.lasts();
  for (const double e : {0.9, 0.5, 0.1}) {
    Scene scene = hertz_scene();
    scene.effects.damping = Damping{e};
    for (const int steps : {200, 2000})
      EXPECT_NEAR(ball_restitution(scene, lasts, lasts / steps), e, -2 * std::log(e) / steps) << steps;
  }
}

TEST(Restitution, IsOneWithoutDamping) {
  Scene linear, hertz = hertz_scene();
  linear.effects.linear = Linear{1e7};
  const double lasts = std::numbers::pi * std::sqrt(ball_mass() / 1e7);
  const double order2 = std::pow(std::numbers::pi / 400, 2);
  EXPECT_NEAR(ball_restitution(linear, lasts, lasts / 400), 1, order2);
  const double hertz_lasts = HertzCollision{4.0 / 3 * contact_modulus, ball_mass(), 1}.lasts();
  EXPECT_NEAR(ball_restitution(hertz, hertz_lasts, hertz_lasts / 400), 1, order2);
}

// x'' + c x' + k/m x = 0: back at x = 0 after half a period of what is left of the frequency.
TEST(Restitution, OfADashpotByTheMassIsThatOfADampedSpring) {
  const double frequency = std::sqrt(1e7 / ball_mass()), lasts = std::numbers::pi / frequency;
  for (const double share : {0.1, 0.5, 1.0}) {
    Scene scene;
    scene.effects.linear = Linear{1e7};
    scene.effects.damping = Damping{.mass_velocity = share * frequency};
    const double half_rate = share * frequency / 2,
                 expected =
                     std::exp(-std::numbers::pi * half_rate / std::sqrt(frequency * frequency - half_rate * half_rate));
    for (const double accuracy : {1e-3, 1e-5})
      EXPECT_NEAR(ball_restitution(scene, lasts, lasts * std::sqrt(accuracy)) / expected, 1, 10 * accuracy) << share;
  }
}

// Until the force would pull: e = exp(-b/w (pi - atan(2 b w / (w^2 - b^2)))), b half the rate and w what is left of the frequency (Schwager
// & Poschel 2007, Granular Matter 9, 465).
TEST(Restitution, OfADashpotThatDoesNotPullIsGreater) {
  const double frequency = std::sqrt(1e7 / ball_mass()), lasts = std::numbers::pi / frequency;
  for (const double share : {0.2, 1.0}) {
    Scene scene;
    scene.effects.linear = Linear{1e7};
    scene.effects.damping = Damping{.mass_velocity = share * frequency, .pull = 0};
    const double half_rate = share * frequency / 2, left = std::sqrt(frequency * frequency - half_rate * half_rate);
    const double angle = std::numbers::pi - std::atan2(2 * half_rate * left, left * left - half_rate * half_rate);
    const double expected = std::exp(-half_rate / left * angle);
    for (const double accuracy : {1e-3, 1e-5})
      EXPECT_NEAR(ball_restitution(scene, lasts, lasts * std::sqrt(accuracy)) / expected, 1, 10 * accuracy)
          << share << ' ' << accuracy;
  }
}

/// Velocity after / before of x'' = -spring x^(3/2) - rate sqrt(x) x', by Runge and Kutta's method of order four.
double restitution_of_ode(double spring, double rate, double speed, double step) {
  const auto slope = [&](const Eigen::Vector2d& s) -> Eigen::Vector2d {
    const double root = std::sqrt(std::max(s[0], 0.0));
    return {s[1], -spring * s[0] * root - rate * root * s[1]};
  };
  Eigen::Vector2d s(0, speed), last = s;
  while (s[0] >= 0) {
    last = s;
    const Eigen::Vector2d k1 = slope(s), k2 = slope(s + step / 2 * k1), k3 = slope(s + step / 2 * k2),
                          k4 = slope(s + step * k3);
    s += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  const double share = last[0] / (last[0] - s[0]);
  return -(last[1] + share * (s[1] - last[1])) / speed;
}

// Of a ball on a wall R is its radius, 1, and Hertz's force 4/3 E* x^(3/2).
TEST(Restitution, OfAViscoelasticDashpotIsThatOfItsEquation) {
  const double lasts = HertzCollision{4.0 / 3 * contact_modulus, ball_mass(), impact_speed}.lasts();
  for (const double rate : {5 / lasts, 50 / lasts}) {
    Scene scene = hertz_scene();
    scene.effects.damping = Damping{.viscoelastic = rate};
    const double expected =
        restitution_of_ode(4.0 / 3 * contact_modulus / ball_mass(), rate, impact_speed, lasts / 20000);
    EXPECT_LT(expected, 0.99);
    for (const int steps : {200, 2000})
      EXPECT_NEAR(ball_restitution(scene, lasts, lasts / steps), expected, 0.2 / steps) << rate << ' ' << steps;
  }
}

SceneBody spinning_egg(Stream& stream, const Vec& velocity) {
  SceneBody b = made::body({{1, 0.7, 0.5}}, Vec::Zero(), velocity);
  for (double& x : b.body.quaternion) x = stream.uniform(-1, 1);
  for (double& x : b.angular_velocity) x = stream.uniform(-0.3, 0.3);
  return b;
}

/// How far a body reaches along a unit vector.
double reach(const SceneBody& b, const Vec& along) {
  const auto& q = b.body.quaternion;
  return support<double>(b.body.shape, Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().conjugate() * along);
}

/// Moves a body down until the gap to another is about so small; their distance is no longer than the way along z.
void lower(SceneBody& upper, const SceneBody& lower, double gap) {
  for (int k = 0; k < 100; ++k) {
    const double apart = -automatic<double>({upper.body, lower.body}, Want{}, nullptr).overlap;
    if (apart <= gap) return;
    upper.body.position.z() -= 0.9 * apart;
  }
}

/// A collision on its way that takes about this long: an egg falls on a wall, or two meet, off their centres either way.
struct OffCentre {
  double lasts;
  bool has_wall, is_hertz;

  [[nodiscard]] Scene scene(std::uint64_t index, double restitution) const {
    Stream stream("off centre", 1, index);
    SceneBody falls = spinning_egg(stream, {stream.uniform(-1, 1), 0, -1});
    const SceneBody waits = spinning_egg(stream, Vec::Zero());
    Vec& place = falls.body.position;
    place.z() = reach(falls, -Vec::UnitZ()) + 0.1 * lasts;
    if (!has_wall) place += Vec(stream.uniform(-0.3, 0.3), stream.uniform(-0.3, 0.3), reach(waits, Vec::UnitZ()));
    Scene out;
    out.bodies = {falls};
    if (has_wall) {
      out.walls = {made::floor_at()};
    } else {
      lower(out.bodies[0], waits, 0.1 * lasts);
      out.bodies.push_back(waits);
    }
    choose_force(out, restitution);
    out.run.time_step = lasts / 2000;
    out.run.duration = 5 * lasts;
    return out;
  }

  void choose_force(Scene& out, double restitution) const {
    const double mass_there = mass(out.bodies[0]);
    if (is_hertz)
      out.effects.hertz = Hertz{20 * mass_there * std::pow(lasts, -2.5), 0.3};
    else
      out.effects.linear = Linear{mass_there * std::pow(std::numbers::pi / lasts, 2)};
    if (restitution < 1) out.effects.damping = Damping{restitution};
  }
};

// The mass that the normal feels is constant only for as long as nothing turns: the error goes with the duration, in which bodies of
// size 1 at speeds of 1 turn by so much. A step cuts a thousandth off the first and the last force.
TEST(Restitution, OffCentreIsThatOfTheNormalVelocityAtTheContact) {
  for (const bool is_hertz : {false, true})
    for (const bool has_wall : {true, false})
      for (const double e : {1.0, 0.6})
        for (const double lasts : {1e-2, 1e-3})
          for (std::uint64_t i = 0; i < 5; ++i) {
            const Scene scene = OffCentre{lasts, has_wall, is_hertz}.scene(i, e);
            EXPECT_NEAR(restitution_of(*started(scene)), e, 4 * lasts + 1e-3)
                << i << ' ' << lasts << ' ' << has_wall << ' ' << is_hertz;
          }
}

}  // namespace
}  // namespace plumb::scene
