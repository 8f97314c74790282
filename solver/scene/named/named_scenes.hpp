// The makers of the named scenes, and what they share. SI units throughout.
#pragma once

#include <cmath>
#include <cstdint>

#include "solver/scene/scene.hpp"
#include "solver/scene/wall/mesh.hpp"

namespace plumb::scene::named {

[[nodiscard]] Scene impact(int bodies);
[[nodiscard]] Scene rolling(int bodies);
[[nodiscard]] Scene rod(int bodies);
[[nodiscard]] Scene needle(int bodies);
[[nodiscard]] Scene chain(int bodies);
[[nodiscard]] Scene billiards(int bodies);
[[nodiscard]] Scene pile(int bodies);
[[nodiscard]] Scene hopper(int bodies);
[[nodiscard]] Scene dice(int bodies);
[[nodiscard]] Scene tower(int bodies);
[[nodiscard]] Scene wall(int bodies);
[[nodiscard]] Scene packing(int bodies);
[[nodiscard]] Scene drum(int bodies);
[[nodiscard]] Scene silo(int bodies);
[[nodiscard]] Scene mixer(int bodies);
/// The mixer's, as corpus/scenes/blade.stl has it.
[[nodiscard]] std::vector<Triangle> blade();

inline constexpr double standard_gravity = 9.81;  ///< m/s^2

/// Numbers that are the same bits everywhere: SplitMix64 (Steele, Lea & Flood 2014) and square roots.
class Draw {
 public:
  Draw() = default;
  explicit Draw(std::uint64_t seed) : state_(seed) {}
  [[nodiscard]] double between(double low, double high) {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    const double unit = static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
    return low + (high - low) * unit;
  }
  [[nodiscard]] Vec3<double> in_box(double half) {
    Vec3<double> out;
    for (double& x : out) x = between(-half, half);
    return out;
  }
  /// Uniform among all orientations: a point of the 4-ball by rejection; its length does not count.
  [[nodiscard]] std::array<double, 4> orientation() {
    while (true) {
      std::array<double, 4> q{};
      double square = 0;
      for (double& x : q) {
        x = between(-1, 1);
        square += x * x;
      }
      if (square <= 1 && square > 0.01) return q;
    }
  }

 private:
  std::uint64_t state_ = 20240229;
};

[[nodiscard]] inline SceneBody body_at(const Vec3<double>& position, const Superellipsoid<double>& shape,
                                       double density) {
  SceneBody out;
  out.body.shape = shape;
  out.body.position = position;
  out.density = density;
  return out;
}

[[nodiscard]] inline Effects under_gravity() {
  Effects effects;
  effects.gravity = Gravity{{0, 0, -standard_gravity}};
  return effects;
}

/// A hundred pictures of the whole run.
inline void run_for(Scene& scene, double duration, double accuracy) {
  scene.run.duration = duration;
  scene.run.accuracy = accuracy;
  scene.run.outputs.every = duration / 100;
  scene.run.outputs.playback = true;
}

/// Four walls about the origin, looking inwards.
inline void fence(Scene& scene, double half_x, double half_y) {
  for (const double side : {-1.0, 1.0}) {
    scene.walls.push_back({Vec3<double>(side * half_x, 0, 0), Vec3<double>(-side, 0, 0), {}});
    scene.walls.push_back({Vec3<double>(0, side * half_y, 0), Vec3<double>(0, -side, 0), {}});
  }
}

}  // namespace plumb::scene::named
