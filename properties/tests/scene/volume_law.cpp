// The volume law: its force is the gradient of its energy, whatever the shapes, and a face on a face makes nothing jump.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "properties/tests/draws.hpp"
#include "properties/tests/scene/made.hpp"

namespace plumb::scene {
namespace {

using made::Vec;

class Random {
 public:
  explicit Random(std::uint64_t index) : stream_("volume law", 5, index) {}
  double between(double low, double high) { return low + (high - low) * stream_.uniform(); }
  Vec vector(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }

 private:
  Stream stream_;
};

SceneBody drawn(Random& random, double exponent, const Vec& at, const Vec& velocity) {
  SceneBody out = made::body({Vec::Ones() + random.vector(0.2), exponent, exponent}, at, velocity);
  out.body.quaternion = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
  out.angular_velocity = random.vector(1);
  return out;
}

Scene with_volume(std::vector<SceneBody> bodies, bool has_floor, double accuracy) {
  Scene out;
  out.bodies = std::move(bodies);
  if (has_floor) out.walls = {made::floor_at()};
  out.effects.volume = Volume{3e3, 1.5};
  out.run.duration = 3;
  out.run.accuracy = accuracy;
  return out;
}

Scene two(Random& random, double exponent, double accuracy) {
  return with_volume({drawn(random, exponent, Vec(-1.6, 0, 0) + random.vector(0.3), Vec::UnitX()),
                      drawn(random, exponent, Vec(1.6, 0, 0), -Vec::UnitX())},
                     false, accuracy);
}

Scene onto_the_floor(Random& random, double exponent, double accuracy) {
  return with_volume({drawn(random, exponent, Vec(0, 0, 2.5), Vec(0.2, 0.1, -1))}, true, accuracy);
}

TEST(VolumeLaw, NoCollisionGainsOrLosesEnergy) {
  for (const double exponent : {2.0, 4.0, 8.0})
    for (std::uint64_t i = 0; i < 4; ++i)
      for (auto* scene : {two, onto_the_floor}) {
        Random random(i);
        const auto run = made::started(scene(random, exponent, 1e-2));
        const double start = made::total_energy(*run);
        double stored = 0;
        while (!run->is_done()) {
          run->step();
          stored = std::max(stored, run->energy().at("volume"));
        }
        EXPECT_GT(stored, 0.05 * start) << exponent << ' ' << i;  // they met
        EXPECT_NEAR(made::total_energy(*run), start, 1e-4 * start) << exponent << ' ' << i;
      }
}

/// Eight bodies in a closed box, that never come to rest: balls under `linear`, or exponents 2 to 8 under `volume`.
Scene billiards(bool are_balls) {
  Random random(34);
  Scene out;
  for (int i = 0; i < 8; ++i) {
    const Vec at((i & 1) != 0 ? 1.5 : -1.5, (i & 2) != 0 ? 1.5 : -1.5, (i & 4) != 0 ? 1.5 : -1.5);
    SceneBody body = drawn(random, 2, at, random.vector(1));
    body.body.shape.n1 = random.between(2, 8);
    body.body.shape.n2 = random.between(2, 8);
    out.bodies.push_back(are_balls ? made::ball(1, at, body.velocity) : body);
  }
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0})
      out.walls.push_back({3.2 * side * Vec::Unit(axis), -side * Vec::Unit(axis), {}});
  if (are_balls)
    out.effects.linear = Linear{3e3};
  else
    out.effects.volume = Volume{3e3, 1.5};
  out.run.accuracy = 1e-2;
  out.run.time_step = 4e-3;  // a collision takes about 30
  return out;
}

/// The largest relative change of the energy.
double drift_of(Scene scene, std::uint64_t steps) {
  scene.run.duration = static_cast<double>(steps) * scene.run.time_step.value_or(0);
  const auto run = made::started(scene);
  const double start = made::total_energy(*run);
  double worst = 0;
  while (!run->is_done()) {
    run->step();
    worst = std::max(worst, std::abs(made::total_energy(*run) / start - 1));
  }
  EXPECT_EQ(run->totals().failed, 0);
  return worst;
}

TEST(VolumeLaw, BilliardsKeepTheirEnergyBetterThanBallsUnderLinear) {
  const std::uint64_t steps = draws(1'000'000, 10'000);
  EXPECT_LT(drift_of(billiards(false), steps), drift_of(billiards(true), steps));
}

/// Of the bodies as they stand.
double stored(const Scene& scene) {
  return made::started(scene)->energy().at("volume");
}

TEST(VolumeLaw, TheWrenchIsTheGradientOfTheEnergy) {
  constexpr double h = 1e-4;
  for (const double exponent : {2.0, 4.0, 8.0})
    for (auto* make : {two, onto_the_floor}) {
      Random random(7);
      Scene scene = make(random, exponent, 1e-6);
      SceneBody& last = scene.bodies.back();
      last.body.position -= (scene.walls.empty() ? Vec(1.5, 0, 0) : Vec(0, 0, 1.7));
      const auto run = made::started(scene);
      const Vec force = run->world().state.force->vector(scene.bodies.size() - 1),
                torque = run->world().state.torque->vector(scene.bodies.size() - 1);
      ASSERT_GT(force.norm(), 1);
      const Eigen::Quaterniond q(last.body.quaternion[0], last.body.quaternion[1], last.body.quaternion[2],
                                 last.body.quaternion[3]);
      for (int axis = 0; axis < 3; ++axis) {
        std::array<double, 2> shifted{}, turned{};
        for (const int side : {0, 1}) {
          Scene other = scene;
          const Vec by = (side == 0 ? h : -h) * Vec::Unit(axis);
          other.bodies.back().body.position += by;
          shifted.at(static_cast<std::size_t>(side)) = stored(other);
          other = scene;
          const Eigen::Quaterniond t = Eigen::AngleAxisd(by.norm(), by.normalized()) * q;
          other.bodies.back().body.quaternion = {t.w(), t.x(), t.y(), t.z()};
          turned.at(static_cast<std::size_t>(side)) = stored(other);
        }
        EXPECT_NEAR(-(shifted[0] - shifted[1]) / (2 * h), force[axis], 1e-3 * force.norm()) << exponent;
        EXPECT_NEAR(-(turned[0] - turned[1]) / (2 * h), torque[axis], 1e-3 * force.norm()) << exponent;
      }
    }
}

TEST(VolumeLaw, BallsDoNotSpin) {
  Scene scene =
      with_volume({made::ball(1, Vec(-1.2, 0.5, 0), Vec::UnitX()), made::ball(0.7, Vec(1.2, 0, 0), -Vec::UnitX()),
                   drawn(*std::make_unique<Random>(3), 4, Vec(0, 3, 0), Vec(0, -1, 0))},
                  true, 1e-2);
  for (SceneBody& b : scene.bodies) b.body.position.z() += 0.9;
  const auto run = made::ended(scene);
  EXPECT_TRUE(made::spin(*run, 0).isZero(0));
  EXPECT_TRUE(made::spin(*run, 1).isZero(0));
}

/// A die whose face tilts through the floor: the point of `linear` goes from edge to edge within 1e-12 rad, the patch's centre stays.
TEST(VolumeLaw, AFaceThatTiltsThroughZeroIsNotTurned) {
  const auto torque_at = [](double tilt, bool is_volume) {
    SceneBody die = made::body({Vec::Ones(), 20, 20}, Vec(0, 0, 0.99));
    die.body.quaternion = {1, tilt / 2, 0, 0};
    Scene scene = with_volume({die}, true, 1e-4);
    if (!is_volume) {
      scene.effects.volume.reset();
      scene.effects.linear = Linear{1e4};
    }
    const auto run = made::started(scene);
    return run->world().state.torque->vector(0).x() / run->world().state.force->vector(0).z();
  };
  EXPECT_GT(std::abs(torque_at(1e-12, false)), 0.1);
  for (const double tilt : {1e-16, 1e-12, 1e-8, 1e-6})
    EXPECT_LT(std::abs(torque_at(tilt, true)), 1e-6 + 300 * tilt) << tilt;
}

}  // namespace
}  // namespace plumb::scene
