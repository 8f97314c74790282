#include "solver/scene/facts.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/scene/body/mass.hpp"

namespace plumb::scene {
namespace {

double gravity_of(const Scene& scene) {
  return scene.effects.gravity ? scene.effects.gravity->acceleration.norm() : 0;
}

double wind_of(const Scene& scene) {
  return scene.effects.drag ? scene.effects.drag->fluid_velocity.norm() : 0;
}

/// Of what turns with a wall the farthest from its axis: of a plane, as far as the scene goes.
double arm_of(const Scene& scene, const WallMotion& motion) {
  if (motion.wall < 0 || static_cast<std::size_t>(motion.wall) >= scene.walls.size()) return 0;
  const Wall& wall = scene.walls[static_cast<std::size_t>(motion.wall)];
  if (!wall.is_plane()) return extent_of(wall.shape) + motion.pivot.norm();
  double farthest = 0;
  for (const SceneBody& b : scene.bodies)
    farthest = std::max(farthest, (b.body.position - wall.point - motion.pivot).norm());
  return farthest;
}

double fastest_wall(const Scene& scene) {
  double fastest = 0;
  if (scene.effects.moving_walls)
    for (const WallMotion& motion : scene.effects.moving_walls->motions) {
      double speed = motion.velocity.norm() + 2 * std::numbers::pi * motion.frequency * motion.amplitude.norm();
      if (!motion.angular_velocity.isZero(0)) speed += motion.angular_velocity.norm() * arm_of(scene, motion);
      fastest = std::max(fastest, speed);
    }
  return fastest;
}

/// How far a body's surface may get from where its centre is now.
double reach(const Scene& scene, const SceneBody& b) {
  const double radius = bounding_radius(b.body.shape);
  if (b.is_fixed) return radius;
  const double duration = scene.run.duration;
  return radius + (b.velocity.norm() + wind_of(scene)) * duration + gravity_of(scene) * duration * duration / 2;
}

double wall_reach(const Scene& scene, std::size_t wall) {
  double sum = 0;
  if (scene.effects.moving_walls)
    for (const WallMotion& motion : scene.effects.moving_walls->motions)
      if (static_cast<std::size_t>(motion.wall) == wall) {
        sum += motion.velocity.norm() * scene.run.duration + motion.amplitude.norm();
        if (!motion.angular_velocity.isZero(0))  // a shape stays in its ball
          sum += scene.walls[wall].is_plane() ? std::numeric_limits<double>::infinity() : 2 * motion.pivot.norm();
      }
  return sum;
}

bool can_touch_wall(const Scene& scene, const SceneBody& b, double radius) {
  for (std::size_t k = 0; k < scene.walls.size(); ++k) {
    const Wall& wall = scene.walls[k];
    const Vec3<double> from = b.body.position - wall.point;
    const double height = wall.is_plane() ? wall.normal.normalized().dot(from) : from.norm() - extent_of(wall.shape);
    if (height <= radius + wall_reach(scene, k) + contact_range(scene)) return true;
  }
  return false;
}

/// m / (6 pi viscosity r), infinite without drag.
double slip_time(const Scene& scene) {
  if (!scene.effects.drag) return std::numeric_limits<double>::infinity();
  const double slowing = 6 * std::numbers::pi * scene.effects.drag->viscosity * longest_axis(scene);
  return 2 * least_contact_mass(scene) / slowing;
}

/// About what is flat of a cross-section as wide as the longest axis: nothing of ellipsoids.
double flat_area(const Scene& scene) {
  double exponent = 2;
  for (const SceneBody& b : scene.bodies) exponent = std::max({exponent, b.body.shape.n1, b.body.shape.n2});
  const double size = longest_axis(scene);
  return (1 - 2 / exponent) * std::numbers::pi * size * size;
}

/// Half a period of the stiffer of two contacts, of balls, V = pi R overlap^2, and of flats, at the volume that stops the greatest speed.
double volume_time(const Scene& scene, const Volume& law) {
  const double mass = least_contact_mass(scene), size = longest_axis(scene), m = law.exponent, flat = flat_area(scene);
  const double slow = 1e-3 * std::sqrt(law.energy(size * size * size) / mass);  // of a speed of sound
  const double speed = std::max(greatest_speed(scene), slow);
  const double volume = std::pow(mass * speed * speed / (2 * law.stiffness), 1 / m), pressure = law.pressure(volume);
  const double of_balls = pressure * 2 * std::numbers::pi * shortest_axis(scene) * (2 * m - 1);
  const double of_flats = pressure * (m - 1) / volume * flat * flat;
  return std::numbers::pi * std::sqrt(mass / std::max(of_balls, of_flats));
}

/// The same of a foundation, whose slope is stiffness * area, against a tilt up to tilt_ratio times that; of balls, the energy is stiffness * pi R overlap^3 / 3.
double foundation_time(const Scene& scene, const Foundation& law) {
  const double stiffness = law.stiffness;
  const double mass = least_contact_mass(scene), size = longest_axis(scene);
  const double slow = 1e-3 * std::sqrt(stiffness * size * size * size * size / mass);
  const double speed = std::max(greatest_speed(scene), slow);
  const double overlap = std::cbrt(1.5 * mass * speed * speed / (stiffness * std::numbers::pi * shortest_axis(scene)));
  const double area = std::max(2 * std::numbers::pi * size * std::min(overlap, size), flat_area(scene));
  return std::numbers::pi * std::sqrt(mass / (stiffness * std::max(1.0, law.tilt_ratio) * area));
}

/// A body's images meet others wherever it is.
bool repeats_itself(const Scene& scene) {
  return scene.effects.periodic_box && !scene.effects.periodic_box->sides.isZero(0);
}

/// Beyond so many bodies nobody would ask.
constexpr std::size_t most_bodies = 1000;

}  // namespace

bool can_move(const Scene& scene) {
  return std::ranges::any_of(scene.bodies, [](const SceneBody& b) { return !b.is_fixed; });
}

double contact_range(const Scene& scene) {
  return scene.effects.cohesion ? scene.effects.cohesion->range : 0;
}

bool can_touch(const Scene& scene) {
  // A step longer than a slip lasts overshoots what drag does to a body.
  const bool is_overshooting = scene.run.time_step && *scene.run.time_step > slip_time(scene);
  if (scene.bodies.size() > most_bodies || is_overshooting || repeats_itself(scene)) return true;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& a = scene.bodies[i];
    const double radius = reach(scene, a);
    if (!a.is_fixed && can_touch_wall(scene, a, radius)) return true;
    for (std::size_t j = 0; j < i; ++j) {
      const SceneBody& b = scene.bodies[j];
      if (a.is_fixed && b.is_fixed) continue;
      if ((a.body.position - b.body.position).norm() <= radius + reach(scene, b) + contact_range(scene)) return true;
    }
  }
  return false;
}

bool has_elastic_force(const Effects& effects) {
  return (effects.linear && effects.linear->stiffness > 0) || (effects.hertz && effects.hertz->youngs_modulus > 0) ||
         (effects.volume && effects.volume->stiffness > 0) || (effects.foundation && effects.foundation->stiffness > 0);
}

void require_elastic_force(const Scene& scene, std::string_view effect, const char* why) {
  if (elastic_laws(scene) > 0) return;
  throw SceneError("effects." + std::string(effect),
                   std::string(why) + ", and there is none: add " + names_of_elastic_laws);
}

void require_one_elastic_law(const Scene& scene, std::string_view effect) {
  if (elastic_laws(scene) > 1)
    throw SceneError("effects." + std::string(effect),
                     std::string("there is one elastic law: ") + names_of_elastic_laws);
}

int elastic_laws(const Scene& scene) {
  const Effects& effects = scene.effects;
  return int{effects.linear.has_value()} + int{effects.hertz.has_value()} + int{effects.volume.has_value()} +
         int{effects.foundation.has_value()};
}

double collision_time(const Scene& scene) {
  const std::optional<Linear>& linear = scene.effects.linear;
  const std::optional<Hertz>& hertz = scene.effects.hertz;
  const double mass = least_contact_mass(scene);
  if (linear && linear->stiffness > 0) return std::numbers::pi * std::sqrt(mass / linear->stiffness);
  if (scene.effects.volume && scene.effects.volume->stiffness > 0) return volume_time(scene, *scene.effects.volume);
  if (scene.effects.foundation && scene.effects.foundation->stiffness > 0)
    return foundation_time(scene, *scene.effects.foundation);
  if (!hertz || hertz->youngs_modulus == 0) return std::numeric_limits<double>::infinity();
  const double size = longest_axis(scene), modulus = hertz->contact_modulus();
  const double sound = std::sqrt(modulus * size * size * size / mass);
  const double speed = std::max(greatest_speed(scene), 1e-3 * sound);
  return 2.87 * std::pow(mass * mass / (size * modulus * modulus * speed), 0.2);
}

double drag_time(const Scene& scene) {
  return 0.3 * slip_time(scene);
}

double least_contact_mass(const Scene& scene) {
  // Off its centre an ellipsoid answers with a sixth of its mass: 1 + m r^2 / I with I = m r^2 / 5 about its short axes.
  constexpr double off_centre = 1.0 / 6;
  double least = std::numeric_limits<double>::infinity();
  for (const SceneBody& b : scene.bodies) {
    if (b.is_fixed) continue;
    const double mass = b.density * mass_properties(b.body.shape).volume;
    least = std::min(least, is_sphere(b.body.shape) ? mass : off_centre * mass);
  }
  return least / 2;
}

double greatest_speed(const Scene& scene) {
  double first = 0;
  Eigen::AlignedBox3d box;
  for (const SceneBody& b : scene.bodies) {
    if (!b.is_fixed)
      first = std::max(first, b.velocity.norm() + b.angular_velocity.norm() * bounding_radius(b.body.shape));
    box.extend(b.body.position);
  }
  const double by_box = scene.effects.periodic_box ? scene.effects.periodic_box->rate.norm() : 0;
  for (const Wall& wall : scene.walls) {
    const Vec3<double> about = Vec3<double>::Constant(wall.is_plane() ? 0 : extent_of(wall.shape));
    box.extend(Eigen::AlignedBox3d(wall.point - about, wall.point + about));
  }
  const double g = gravity_of(scene);
  const double height = box.isEmpty() ? 0 : box.diagonal().norm();
  const double own = std::min(first + g * scene.run.duration, std::sqrt(first * first + 2 * g * height));
  return own + wind_of(scene) + fastest_wall(scene) + by_box;
}

double longest_axis(const Scene& scene) {
  double longest = 0;
  for (const SceneBody& b : scene.bodies)
    if (!b.is_fixed) longest = std::max(longest, b.body.shape.semi_axes.maxCoeff());
  return longest;
}

double shortest_axis(const Scene& scene) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const SceneBody& b : scene.bodies)
    if (!b.is_fixed) shortest = std::min(shortest, b.body.shape.semi_axes.minCoeff());
  return shortest;
}

}  // namespace plumb::scene
