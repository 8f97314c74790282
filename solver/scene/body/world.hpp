// What effects work on: the bodies, the state, the contacts, and the list of passes that is one step.
#pragma once

#include <Eigen/Geometry>
#include <chrono>
#include <cmath>
#include <functional>
#include <span>

#include "solver/scene/body/columns.hpp"
#include "solver/scene/body/rotation.hpp"
#include "solver/scene/material/mixing.hpp"
#include "solver/scene/scene.hpp"

namespace plumb::scene {

/// What does not change, one entry a body and, after the bodies, one a wall (of which nobody reads the body's shape). A wall that turns
/// has its normal of now.
struct Bodies {
  std::size_t count = 0;  ///< without walls
  std::size_t walls = 0;
  std::vector<Superellipsoid<double>> shape;
  std::vector<char> is_sphere;
  std::vector<double> radius;                          ///< of a ball about the centre that holds the body
  std::vector<std::size_t> material;                   ///< index in the scene's materials
  std::vector<double> mass;                            ///< also of what is fixed; walls: infinite
  std::vector<double> inverse_mass;                    ///< 0 where nothing moves it
  std::vector<Vec3<double>> inertia, inverse_inertia;  ///< principal, body axes; inverse 0 where nothing turns it
  std::vector<double> sphere_radius;                   ///< of equal volume
  std::vector<std::uint32_t> movable, turning;
  std::vector<Vec3<double>> wall_normal;  ///< unit, out of the wall: of planes
  std::vector<Vec3<double>> wall_spin;    ///< rad / time about its point, world axes; 0 of what does not turn
  std::vector<WallShape> wall_shape;
  [[nodiscard]] std::size_t all() const { return count + walls; }
  [[nodiscard]] bool is_wall(std::uint32_t i) const { return i >= count; }
  /// Entries of the contact list that a pair with this body or wall has.
  [[nodiscard]] std::size_t places(std::uint32_t i) const { return is_wall(i) ? places_of(wall_shape[i - count]) : 1; }
};

/// What moves. Columns of what no effect and no output asks for are nullptr.
struct State {
  Column* position = nullptr;          ///< 3; a point of a wall
  Column* velocity = nullptr;          ///< 3; at the middle of the step while forces are computed
  Column* orientation = nullptr;       ///< 4: quaternion (w, x, y, z)
  Column* angular_momentum = nullptr;  ///< 3, world axes
  Column* angular_velocity = nullptr;  ///< 3, world axes, made from the momentum
  Column* force = nullptr;             ///< 3
  Column* torque = nullptr;            ///< 3, about the centre
  Column* turned = nullptr;            ///< of separation.hpp
  Column* box_sides = nullptr;         ///< 3, of the scene: of a box that repeats itself, 0 along an open axis
  Column* box_rates = nullptr;         ///< 3, of the scene: of the sides

  [[nodiscard]] Eigen::Quaterniond orientation_of(std::size_t body) const {
    const auto q = orientation->entry(body);
    return {q[0], q[1], q[2], q[3]};
  }
};

/// The contact list: pairs that may touch (body 2 has the higher index, a wall is body 2), and those of them that do.
/// A contact's entry of `Contacts::chart`, three numbers for each body: the charts where the solver starts next time, those of the step before,
/// and their bends.
struct ChartEntry {
  static constexpr std::size_t last = 0, before_last = 6, bend = 12, width = 18;
};

struct Contacts {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  std::vector<std::uint32_t> touching;  ///< indices in pairs, rising: overlap > -range
  std::vector<std::uint32_t> pressing;  ///< those of them that overlap
  std::vector<std::uint32_t> parted;    ///< those that overlapped in the step before, and no longer do
  double range = 0;
  Column* is_pressing = nullptr;  ///< 1 or 0
  Column* image =
      nullptr;  ///< 3: from body 2 to the image of it that is nearest to body 1, in a box that repeats itself
  Column* chart = nullptr;       ///< of ChartEntry
  Column* separation = nullptr;  ///< of separation.hpp
  Column* overlap = nullptr;     ///< 1
  Column* normal = nullptr;      ///< 3, from body 1 to body 2
  Column* point = nullptr;       ///< 3: where the force acts
  Column* volume = nullptr;      ///< 1: of the patch, as the next two; the normal and the point are the patch's then
  Column* area = nullptr;        ///< 1
  Column* patch_arms =
      nullptr;  ///< 9: of the roots of its three second moments along their axes, each times the normal
  Column* area_moment = nullptr;  ///< 3: about the point; 0 of a ball
  double patch_tolerance = 0;
  Column* curvature = nullptr;     ///< 2: A <= B, the gap being A x^2 + B y^2 (1/length)
  bool follows_curvature = false;  ///< in each step; else it is that of a contact's first, or a part's
  Column* arm1 = nullptr;          ///< 3: (point - centre) x normal, exactly 0 for spheres
  Column* arm2 = nullptr;
  Column* yield1 =
      nullptr;  ///< 3: the inverse inertia, world axes, times the arm: how a body turns by an impulse along the normal
  Column* yield2 = nullptr;
  Column* inverse_mass = nullptr;  ///< 1 / the mass that an impulse along the normal feels
  Column* radius = nullptr;        ///< 1: 1 / (1/r1 + 1/r2) of the distances to the centres; r2 of a wall is infinite
  Column* normal_force = nullptr;  ///< 1, > 0 pushes apart
  Column* force = nullptr;         ///< 3: all of it, on body 2
  Column* life = nullptr;          ///< of lives.hpp
  Column* stiffness = nullptr;     ///< 1: slope of the elastic force by the overlap

  /// How far from its centre a patch is, across the normal: the root of the mean square.
  [[nodiscard]] double patch_radius(std::size_t contact) const;
};

/// From the bodies' centres to the point of contact; 0 of a wall, which nothing turns.
struct Levers {
  Vec3<double> r1, r2;
};

/// What a contact does: a force on body 2, and its moments about the centre of body 1 and of body 2.
struct Action {
  Vec3<double> force, moment1, moment2;

  [[nodiscard]] static Action none() { return {Vec3<double>::Zero(), Vec3<double>::Zero(), Vec3<double>::Zero()}; }

  /// Adds a force at the point of contact.
  void push(const Vec3<double>& more, const Levers& levers) {
    force += more;
    moment1 += levers.r1.cross(more);
    moment2 += levers.r2.cross(more);
  }
  void turn(const Vec3<double>& couple) {
    moment1 += couple;
    moment2 += couple;
  }
  Action& operator+=(const Action& more) {
    force += more.force;
    moment1 += more.moment1;
    moment2 += more.moment2;
    return *this;
  }
};

/// One step of work on all bodies or on all contacts.
struct Pass {
  std::string_view owner;
  std::function<void()> run;
  std::chrono::steady_clock::duration spent{};
};

/// Contacts that follow each other in the list: pairs [first, end), those of them that touch and press, and what they do so far.
struct ContactRange {
  std::size_t first, end;
  std::span<const std::uint32_t> touching, pressing;
  std::span<Action> actions;  ///< at a pair's place from `first`, of those that touch

  [[nodiscard]] Action& action(std::size_t contact) const { return actions[contact - first]; }
};

/// One step of work on contacts. Threads share the list: it changes what is these contacts' own, and no body.
struct ContactPass {
  std::string_view owner;
  std::function<void(const ContactRange& range)> run;
  double seconds = 0;
};

/// What an effect stores, for who asks: nothing of a step.
struct StoredEnergy {
  std::string_view owner;
  std::function<double()> energy;
};

struct World {
  double time = 0, time_step = 0;
  int threads = 1;
  Effects effects;           ///< asked for: of the scene, where it has no materials
  PairEffects pair_effects;  ///< else of each pair of them
  Bodies bodies;
  Columns columns;
  State state;
  Contacts contacts;
  Column* boxes = nullptr;  ///< of the contact list (neighbours.hpp); none where the list holds for good

  /// In the order of a step, each in that of effects(): what moves by itself, forces of contacts, forces of bodies, and forces
  /// that go by the velocities to which all others lead.
  std::vector<Pass> movers, body_passes, closing_passes;
  std::vector<ContactPass> contact_passes;
  std::vector<StoredEnergy> energies;
  /// What sets an effect's columns once they have their size.
  std::vector<std::function<void(const Scene&)>> starts;

  [[nodiscard]] bool has_turning() const { return state.torque != nullptr; }
  /// As the solver takes it: a sphere has none, so that turning it changes no bit.
  [[nodiscard]] Eigen::Quaterniond solver_orientation(std::size_t body) const {
    return bodies.is_sphere[body] != 0 ? Eigen::Quaterniond::Identity() : state.orientation_of(body);
  }

  /// Where a contact has body 2: the image of it that is nearest to body 1.
  [[nodiscard]] Vec3<double> second_position(std::size_t contact) const;
  /// In the box at the origin, where there is one that repeats itself.
  [[nodiscard]] Vec3<double> home(const Vec3<double>& position) const;
  [[nodiscard]] Levers levers(std::size_t contact) const;
  /// How fast a box that changes parts two places.
  [[nodiscard]] Vec3<double> by_box(const Vec3<double>& apart) const;
  /// Of body 2, and what the box adds to it as body 1 sees it; or of a wall where it is touched.
  [[nodiscard]] Vec3<double> second_velocity(std::size_t contact) const;
  /// The velocity of body 2's point of contact as body 1's sees it, where bodies turn.
  [[nodiscard]] Vec3<double> relative_velocity(std::size_t contact, const Levers& levers) const;
  /// Its component along the normal; negative: they approach. Of spheres, turning does nothing to it, exactly.
  [[nodiscard]] double normal_velocity(std::size_t contact) const;
  /// How it changes by the forces so far: of the bodies, not of the normal.
  [[nodiscard]] double normal_acceleration(std::size_t contact) const;
  /// Angular velocity of body 2 as body 1 sees it.
  [[nodiscard]] Vec3<double> relative_turn(std::size_t contact) const;
  /// The inverse inertia of a body, world axes, times a vector; 0 of what nothing turns.
  [[nodiscard]] Vec3<double> yield(std::uint32_t body, const Vec3<double>& torque) const;
  /// A force along the normal.
  [[nodiscard]] Action along_normal(std::size_t contact, double size) const;
  /// Adds it to what acts on the two bodies.
  void act(std::size_t contact, const Action& action);
};

inline double Contacts::patch_radius(std::size_t contact) const {
  return Eigen::Map<const Eigen::Matrix3d>(patch_arms->entry(contact).data()).norm();
}

inline Vec3<double> World::second_position(std::size_t contact) const {
  const Vec3<double> position = state.position->vector(contacts.pairs[contact][1]);
  return contacts.image == nullptr ? position : Vec3<double>(position + contacts.image->vector(contact));
}

inline Vec3<double> World::home(const Vec3<double>& position) const {
  if (state.box_sides == nullptr) return position;
  Vec3<double> out = position;
  for (int k = 0; k < 3; ++k)
    if (const double side = state.box_sides->vector(0)[k]; side > 0) out[k] -= side * std::floor(out[k] / side);
  return out;
}

inline Levers World::levers(std::size_t contact) const {
  const auto [i, j] = contacts.pairs[contact];
  const Vec3<double> point = contacts.point->vector(contact);
  return {point - state.position->vector(i),
          bodies.is_wall(j) ? Vec3<double>::Zero() : Vec3<double>(point - second_position(contact))};
}

inline Vec3<double> World::by_box(const Vec3<double>& apart) const {
  Vec3<double> out = Vec3<double>::Zero();
  for (int k = 0; k < 3; ++k)
    if (const double side = state.box_sides->vector(0)[k]; side > 0)
      out[k] = state.box_rates->vector(0)[k] / side * apart[k];
  return out;
}

inline Vec3<double> World::second_velocity(std::size_t contact) const {
  const auto [i, j] = contacts.pairs[contact];
  const Vec3<double> velocity = state.velocity->vector(j);
  if (!bodies.is_wall(j)) {
    if (contacts.image == nullptr) return velocity;
    return velocity + by_box(second_position(contact) - state.position->vector(i));
  }
  if (bodies.wall_spin[j - bodies.count].isZero(0)) return velocity;
  return velocity +
         bodies.wall_spin[j - bodies.count].cross(contacts.point->vector(contact) - state.position->vector(j));
}

inline Vec3<double> World::relative_velocity(std::size_t contact, const Levers& levers) const {
  const auto [i, j] = contacts.pairs[contact];
  const Vec3<double> spin1 = state.angular_velocity->vector(i), spin2 = state.angular_velocity->vector(j);
  return second_velocity(contact) - state.velocity->vector(i) + spin2.cross(levers.r2) - spin1.cross(levers.r1);
}

inline double World::normal_velocity(std::size_t contact) const {
  const auto [i, j] = contacts.pairs[contact];
  const double shift = (second_velocity(contact) - state.velocity->vector(i)).dot(contacts.normal->vector(contact));
  if (!has_turning()) return shift;
  return shift + (state.angular_velocity->vector(j).dot(contacts.arm2->vector(contact)) -
                  state.angular_velocity->vector(i).dot(contacts.arm1->vector(contact)));
}

inline double World::normal_acceleration(std::size_t contact) const {
  const auto [i, j] = contacts.pairs[contact];
  const Vec3<double> shift =
      bodies.inverse_mass[j] * state.force->vector(j) - bodies.inverse_mass[i] * state.force->vector(i);
  const double along = shift.dot(contacts.normal->vector(contact));
  if (!has_turning()) return along;
  return along + (state.torque->vector(j).dot(contacts.yield2->vector(contact)) -
                  state.torque->vector(i).dot(contacts.yield1->vector(contact)));
}

inline Action World::along_normal(std::size_t contact, double size) const {
  const Vec3<double> force = size * contacts.normal->vector(contact);
  if (contacts.arm1 == nullptr) return {force, Vec3<double>::Zero(), Vec3<double>::Zero()};
  return {force, size * contacts.arm1->vector(contact), size * contacts.arm2->vector(contact)};
}

inline Vec3<double> World::relative_turn(std::size_t contact) const {
  const auto [i, j] = contacts.pairs[contact];
  return state.angular_velocity->vector(j) - state.angular_velocity->vector(i);
}

inline Vec3<double> World::yield(std::uint32_t body, const Vec3<double>& torque) const {
  const Vec3<double>& inverse_inertia = bodies.inverse_inertia[body];
  if (inverse_inertia.isZero(0)) return Vec3<double>::Zero();
  return angular_velocity(state.orientation_of(body), torque, inverse_inertia);
}

inline void World::act(std::size_t contact, const Action& action) {
  const auto [i, j] = contacts.pairs[contact];
  state.force->vector(i) -= action.force;
  state.force->vector(j) += action.force;
  if (contacts.force != nullptr) contacts.force->vector(contact) += action.force;
  if (state.torque == nullptr) return;
  state.torque->vector(i) -= action.moment1;
  state.torque->vector(j) += action.moment2;
}

}  // namespace plumb::scene
