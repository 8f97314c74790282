// Parts of a scene that another engine moves: with bodies shared out to two of them, the same bits as the scene by itself.
#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "properties/tests/scene/crowd.hpp"
#include "properties/tests/scene/made.hpp"
#include "solver/scene/body/rotation.hpp"
#include "solver/scene/part.hpp"

namespace plumb::scene {
namespace {

using Pairs = std::vector<std::array<std::uint32_t, 2>>;
using made::Vec;

/// A leapfrog of its own over two parts; body i belongs to part i % 2, which knows of the contacts of its bodies alone.
class TwoParts {
 public:
  TwoParts(const Scene& scene, const Simulation& like) : scene_(scene), like_(like) {
    PartSettings settings{scene.effects, scene.walls, like.plan().time_step, scene.run.accuracy};
    settings.effects.gravity.reset();
    for (auto& part : parts_) part = std::make_unique<Part>(settings);
    const State& state = like.world().state;
    x_ = state.position->values();
    v_ = state.velocity->values();
    q_ = state.orientation->values();
    momentum_ = state.angular_momentum->values();
    force_.resize(x_.size());
    torque_.resize(x_.size());
    renew();
    compute(0, 0);
  }

  void step() {
    const double dt = like_.plan().time_step;
    kick(dt);
    for (const std::uint32_t i : like_.world().bodies.movable) at(x_, i) += dt * at(v_, i);
    for (const std::uint32_t i : like_.world().bodies.turning) turn(i, dt);
    renew();
    compute(like_.time(), dt);
    kick(dt);
  }

  [[nodiscard]] const std::vector<double>& positions() const { return x_; }
  [[nodiscard]] double energy() const {
    double sum = 0;
    for (std::size_t k = 0; k < 2; ++k)
      sum += parts_[k]->energy(
          [&](std::size_t contact) { return parts_[k]->world().contacts.pairs[contact][0] % 2 == k; });
    return sum;
  }
  /// Of all contacts of one part, summed one by one, and at once.
  [[nodiscard]] std::pair<double, double> energies() const {
    const std::vector<double> each = parts_[0]->energies();
    return {std::accumulate(each.begin(), each.end(), 0.0), parts_[0]->energy([](std::size_t) { return true; })};
  }

 private:
  static Eigen::Map<Vec> at(std::vector<double>& values, std::size_t i) {
    return Eigen::Map<Vec>(values.data() + 3 * i);
  }

  void kick(double dt) {
    const Bodies& bodies = like_.world().bodies;
    for (const std::uint32_t i : bodies.movable) at(v_, i) += dt / 2 * bodies.inverse_mass[i] * at(force_, i);
    for (const std::uint32_t i : bodies.turning) at(momentum_, i) += dt / 2 * at(torque_, i);
  }

  void turn(std::size_t i, double dt) {
    double* entry = q_.data() + 4 * i;
    const Eigen::Quaterniond q = rotated({entry[0], entry[1], entry[2], entry[3]}, at(momentum_, i),
                                         like_.world().bodies.inverse_inertia[i], dt);
    std::ranges::copy(std::array{q.w(), q.x(), q.y(), q.z()}, entry);
  }

  /// Each with its share of the scene's own list, and what it knew of these contacts.
  void renew() {
    for (std::size_t k = 0; k < 2; ++k) {
      Pairs pairs = like_.world().contacts.pairs;
      std::erase_if(pairs, [&](const auto& pair) {
        return pair[0] % 2 != k && (pair[1] % 2 != k || pair[1] >= scene_.bodies.size());
      });
      Part& part = *parts_[k];
      std::map<std::array<std::uint32_t, 2>, std::vector<double>> known;
      for (std::size_t c = 0; c < part.world().contacts.pairs.size(); ++c) {
        if (!part.has_history(c)) continue;
        part.history(c, known.try_emplace(part.world().contacts.pairs[c], part.history_width()).first->second);
      }
      part.renew(scene_.bodies, pairs);
      for (std::size_t c = 0; c < pairs.size(); ++c)
        if (const auto found = known.find(pairs[c]); found != known.end()) part.set_history(c, found->second);
    }
  }

  /// What belongs to each part, from there.
  void collect() {
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      const State& state = parts_[i % 2]->world().state;
      at(force_, i) = state.force->vector(i);
      at(torque_, i) = state.torque->vector(i);
    }
  }

  void compute(double time, double dt) {
    for (auto& part : parts_) {
      for (std::size_t i = 0; i < scene_.bodies.size(); ++i)
        part->place(i, at(x_, i), at(v_, i), {q_[4 * i], q_[4 * i + 1], q_[4 * i + 2], q_[4 * i + 3]},
                    at(momentum_, i));
      part->press(time, dt);
    }
    collect();
    const Vec3<double> gravity = scene_.effects.gravity.value_or(Gravity{}).acceleration;
    for (const std::uint32_t i : like_.world().bodies.movable) at(force_, i) += like_.world().bodies.mass[i] * gravity;
    for (auto& part : parts_) {
      for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
        part->world().state.force->vector(i) = at(force_, i);
        part->world().state.torque->vector(i) = at(torque_, i);
      }
      part->close();
    }
    collect();
  }

  const Scene& scene_;
  const Simulation& like_;
  std::array<std::unique_ptr<Part>, 2> parts_;
  std::vector<double> x_, v_, q_, momentum_, force_, torque_;
};

Scene crowd_without_heat(bool is_hertz) {
  Scene scene = without(crowd(), Conduction::name);
  for (SceneBody& b : scene.bodies)
    b.angular_velocity = Vec::Zero();  // made from the momentum, it is another in the last bit
  if (is_hertz) {
    scene.effects.linear.reset();
    scene.effects.hertz = Hertz{3e4};
  }
  return scene;
}

double elastic_energy(const Simulation& run) {
  double sum = 0;
  for (const auto& [owner, energy] : run.energy())
    if (owner != "kinetic" && owner != Gravity::name) sum += energy;
  return sum;
}

TEST(Part, TwoOfThemMoveAsTheScene) {
  for (const bool is_hertz : {false, true}) {
    const Scene scene = crowd_without_heat(is_hertz);
    const auto run = made::started(scene);
    TwoParts parts(scene, *run);
    bool is_same = true;
    for (int step = 0; step < 1500 && is_same; ++step) {
      run->step();
      parts.step();
      for (std::size_t k = 0; k < 3 * scene.bodies.size(); ++k)
        is_same = is_same && parts.positions()[k] == run->world().state.position->values()[k];
      EXPECT_TRUE(is_same) << "step " << step << (is_hertz ? ", Hertz" : ", linear");
    }
    EXPECT_GT(run->totals().lists, 3);
    EXPECT_GT(run->world().contacts.pressing.size(), 5U);
    EXPECT_NEAR(parts.energy(), elastic_energy(*run), 1e-12 * std::abs(elastic_energy(*run)));
    const auto [one_by_one, at_once] = parts.energies();
    EXPECT_NEAR(one_by_one, at_once, 1e-12 * std::abs(at_once));
  }
}

std::string refused_field(PartSettings settings) {
  try {
    const Part part(settings);
  } catch (const SceneError& error) {
    return error.field;
  }
  return "none";
}

TEST(Part, RefusesWhatHasNoPlaceInIt) {
  PartSettings settings;
  EXPECT_EQ(refused_field(settings), "effects");
  settings.effects.linear = Linear{1};
  EXPECT_EQ(refused_field(settings), "none");
  settings.effects.conduction = Conduction{1};
  EXPECT_EQ(refused_field(settings), "effects.conduction");
  settings.effects.conduction.reset();
  settings.effects.damping = Damping{2};
  EXPECT_EQ(refused_field(settings), "effects.damping.restitution");
}

}  // namespace
}  // namespace plumb::scene
