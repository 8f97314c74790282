// What nothing may change: momentum and angular momentum to rounding, energy to what a step of second order swings.
#include <gtest/gtest.h>

#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include <Eigen/Geometry>

#include "properties/tests/scene/made.hpp"
#include "solver/scene/named.hpp"

namespace plumb::scene {
namespace {

using made::started;
using made::total_energy;
using made::Vec;

/// Superquadrics, ellipsoids and balls in free space that fly into each other, with every effect that acts in contacts.
Scene cloud() {
  Scene scene;
  Stream stream("cloud", 1, 0);
  for (int k = 0; k < 27; ++k) {
    const int layer = k / 9, row = k / 3 % 3;
    const Vec place = Vec(k % 3, row, layer) - Vec::Ones();
    Superellipsoid<double> shape{{1, 1, 1}};
    if (k % 3 > 0) shape.semi_axes = {0.9, 0.7, 0.8};
    if (k % 3 == 2) shape.n1 = 4, shape.n2 = 3;
    SceneBody b = made::body(shape, 2.05 * place, -place);
    for (double& x : b.velocity) x += stream.uniform(-0.5, 0.5);
    for (double& x : b.angular_velocity) x = stream.uniform(-1, 1);
    for (double& x : b.body.quaternion) x = stream.uniform(-1, 1);
    scene.bodies.push_back(b);
  }
  scene.effects.linear = Linear{1e4};
  scene.effects.damping = Damping{0.8};
  scene.effects.friction = Friction{.coefficient = 0.4, .damping = 0.2};
  scene.effects.rolling = Rolling{0.1};
  scene.effects.twisting = Twisting{0.1};
  scene.effects.cohesion = Cohesion{5, 0.05};
  scene.run.duration = 2;
  return scene;
}

TEST(Momentum, IsKeptToRoundingWhateverHappensInContacts) {
  const auto run = started(cloud());
  double speeds = 0, moments = 0, contacts = 0;
  for (std::size_t i = 0; i < 27; ++i) {
    speeds += run->world().bodies.mass[i] * made::velocity(*run, i).norm();
    moments += run->world().bodies.mass[i] * made::velocity(*run, i).norm() * made::position(*run, i).norm();
  }
  const Vec momentum = run->momentum(), angular = run->angular_momentum();
  while (!run->is_done()) {
    run->step();
    contacts += static_cast<double>(run->world().contacts.touching.size());
  }
  // One rounding a step and body, of what adds up to this, as a random walk that is given ten times its deviation.
  const double rounding = 10 * std::sqrt(static_cast<double>(run->steps())) * 0x1p-52;
  EXPECT_GE(contacts, 1000);
  EXPECT_LE((run->momentum() - momentum).norm(), rounding * speeds);
  EXPECT_LE((run->angular_momentum() - angular).norm(), rounding * moments);
  EXPECT_EQ(run->totals().failed, 0);
}

// A ball beside the crown of a fixed egg, which turns about nothing, and a ball elsewhere that spins, whereby bodies have torques at
// all: the egg's is the force's about its centre, whose line goes through the ball's.
TEST(Torque, OfAFixedBodyIsThatOfItsContacts) {
  Scene scene;
  scene.bodies = {made::ball(1, {0.6, 0, 1.9}), made::body({{2, 1.5, 1}}, Vec::Zero()), made::ball(1, {9, 0, 0})};
  scene.bodies[1].is_fixed = true;
  scene.bodies[2].angular_velocity = {0, 0, 1};
  scene.effects.linear = Linear{1e3};
  scene.run.duration = 1e-3;
  const auto run = started(scene);
  const State& state = run->world().state;
  const Vec force = state.force->vector(1), torque = state.torque->vector(1);
  EXPECT_GE(force.norm(), 1);
  EXPECT_GE(torque.norm(), 0.1);
  EXPECT_LE((torque - made::position(*run, 0).cross(force)).norm(), 1e-9 * torque.norm());
}

/// Greatest |E - E0| / E0 in each of so many equal parts of a run.
std::vector<double> energy_errors(Simulation& run, std::int64_t steps, std::size_t parts) {
  const double first = total_energy(run);
  std::vector<double> errors(parts, 0);
  for (std::int64_t k = 0; k < steps; ++k) {
    run.step();
    double& worst = errors[static_cast<std::size_t>(k * static_cast<std::int64_t>(parts) / steps)];
    worst = std::max(worst, std::abs(total_energy(run) / first - 1));
  }
  return errors;
}

// Contacts that never open: the Hamiltonian is smooth, and a symplectic step keeps one beside it for good.
TEST(Energy, OfTheChainDoesNotDriftInAMillionSteps) {
  const Scene scene = find_named_scene("chain")->make(4);
  const auto run = started(scene);
  const std::vector<double> errors = energy_errors(*run, 1'000'000, 10);
  const double mass = run->world().bodies.mass[1], dt = run->plan().time_step;
  const double order2 = 4 * scene.effects.linear.value_or(Linear{}).stiffness / mass * dt *
                        dt;  // (omega dt)^2 of a body between two springs
  EXPECT_LE(errors.front(), order2);
  EXPECT_LE(errors.back(), 2 * errors.front());
  EXPECT_EQ(run->totals().failed, 0);
}

/// An ellipsoid that bounces between floor and ceiling, turning as it will, under gravity.
Scene bouncing() {
  Scene scene;
  scene.bodies = {made::body({{1, 0.7, 0.5}}, Vec::Zero(), {0.3, 0.2, 1})};
  scene.bodies[0].angular_velocity = {0.5, 1, -0.7};
  scene.bodies[0].body.quaternion = {1, 0.4, 0.2, -0.3};
  scene.walls = {made::floor_at(-2), {{0, 0, 2}, {0, 0, -1}, {}}};
  scene.effects.gravity = Gravity{{0, 0, -1}};
  scene.effects.linear = Linear{200};
  scene.run.duration = 1;
  scene.run.time_step = 2e-3;
  return scene;
}

// Each collision starts and ends somewhere within a step, where the force has a kink: an error of the order of
// (omega dt)^2 with either sign. A thousand of them add up as a random walk, some of them partly undone; a drift would be a thousand times one.
TEST(Energy, OfABouncingEllipsoidDoesNotDriftInAMillionSteps) {
  const auto run = started(bouncing());
  const std::vector<double> errors = energy_errors(*run, 1'000'000, 10);
  const double least_mass = run->world().bodies.mass[0] / 6;
  EXPECT_LE(errors.back(), 10 * 200 / least_mass * 4e-6);
}

// No potential, no kink: the splitting keeps a quadratic form beside the energy.
TEST(Energy, OfTheNeedleDoesNotDriftInAMillionSteps) {
  const auto run = started(find_named_scene("needle")->make(0));
  const std::vector<double> errors = energy_errors(*run, 1'000'000, 10);
  EXPECT_LE(errors.front(), 1e-4);  // the accuracy asked for
  EXPECT_LE(errors.back(), 1.5 * errors.front());
}

// ---- free rotation ----

/// Angular momentum in body axes of a free body with I1 < I2 < I3, that starts with m2 = 0, m1 > 0, m3 > 0 and L^2 > 2 E I2
/// (Landau & Lifshitz, Mechanics, section 37; their start has m1 = 0 as well turned by a quarter of a period: cn for cn).
struct FreeTop {
  Vec inertia;
  double m1, m3;

  [[nodiscard]] Vec momentum(double t) const {
    const auto [i1, i2, i3] = std::array{inertia.x(), inertia.y(), inertia.z()};
    const double twice_energy = m1 * m1 / i1 + m3 * m3 / i3, square = m1 * m1 + m3 * m3;
    const double above = square - twice_energy * i1, below = twice_energy * i3 - square;
    const double rate = std::sqrt((i3 - i2) * above / (i1 * i2 * i3));
    const double modulus = std::sqrt((i2 - i1) * below / ((i3 - i2) * above));
    double cn = 0, dn = 0;
    const double sn = boost::math::jacobi_elliptic(modulus, rate * t, &cn, &dn);
    return {m1 * cn, std::sqrt(i2 * below / (i3 - i2)) * sn, m3 * dn};
  }
};

/// An ellipsoid that spins freely; its moments are those of its axes.
Scene spinning_top() {
  Scene scene;
  scene.bodies = {made::body({{1.2, 0.8, 0.6}}, Vec::Zero())};
  scene.bodies[0].angular_velocity = {1, 0, 1.5};
  scene.run.duration = 10;
  return scene;
}

/// Largest difference from the exact momentum in body axes, relative.
double error_of_top(double time_step) {
  Scene scene = spinning_top();
  scene.run.time_step = time_step;
  const auto run = started(scene);
  const Vec inertia = run->world().bodies.inertia[0];
  const FreeTop exact{inertia, inertia.x() * 1, inertia.z() * 1.5};
  double worst = 0;
  while (!run->is_done()) {
    run->step();
    const auto q = run->world().state.orientation->entry(0);
    const Vec momentum = run->world().state.angular_momentum->vector(0);
    const Vec own = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).conjugate() * momentum;
    worst = std::max(worst, (own - exact.momentum(run->time())).norm() / momentum.norm());
  }
  return worst;
}

TEST(FreeRotation, IsJacobisToSecondOrder) {
  const double coarse = error_of_top(0.02), fine = error_of_top(0.002);
  EXPECT_LE(coarse, 0.02 * 0.02 * 10);  // dt^2, and a phase that grows with time
  EXPECT_NEAR(std::log10(coarse / fine), 2, 0.05);
}

TEST(FreeRotation, KeepsAngularMomentumToTheLastBit) {
  for (const bool has_effect : {false, true}) {
    Scene scene = spinning_top();
    scene.run.duration = 100;
    if (has_effect) scene.effects.gravity = Gravity{{0, 0, -10}};
    const auto run = started(scene);
    const Vec before = run->world().state.angular_momentum->vector(0);
    while (!run->is_done()) run->step();
    EXPECT_EQ(Vec(run->world().state.angular_momentum->vector(0)), before);
  }
}

// Two equal moments: precession and spin are turns by exact angles, whatever the step.
TEST(FreeRotation, OfABodyOfRevolutionIsExact) {
  for (const Vec& axes : {Vec(1, 1, 0.4), Vec(0.3, 1, 1), Vec(0.7, 1.5, 0.7)}) {
    Scene scene = spinning_top();
    scene.bodies[0].body.shape.semi_axes = axes;
    std::array<Eigen::Vector4d, 2> ends;
    for (const int k : {0, 1}) {
      scene.run.time_step = k == 0 ? 1 : 0.01;
      const auto run = made::ended(scene);
      ends[static_cast<std::size_t>(k)] = Eigen::Vector4d::Map(run->world().state.orientation->entry(0).data());
    }
    EXPECT_NEAR(std::abs(ends[0].dot(ends[1])), 1, 1e-12);
    EXPECT_LE(std::min((ends[0] - ends[1]).norm(), (ends[0] + ends[1]).norm()), 1e-12);
  }
}

/// Where the chain's bodies are, against a run with a 32nd of the step.
double chain_error(double time_step) {
  Scene scene = find_named_scene("chain")->make(4);
  scene.run.duration = 1e-3;
  scene.run.outputs = {};
  std::array<std::unique_ptr<Simulation>, 2> runs;
  for (const std::size_t k : {0U, 1U}) {
    scene.run.time_step = k == 0 ? time_step : 1e-3 / 4096;
    runs[k] = made::ended(scene);
  }
  double worst = 0;
  for (std::size_t i = 1; i <= 4; ++i)
    worst = std::max(worst, (made::position(*runs[0], i) - made::position(*runs[1], i)).norm());
  return worst;
}

TEST(Trajectory, ConvergesToSecondOrder) {
  EXPECT_NEAR(std::log2(chain_error(1e-3 / 64) / chain_error(1e-3 / 256)) / 2, 2, 0.05);
}

}  // namespace
}  // namespace plumb::scene
