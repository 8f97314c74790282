// A part of a scene whose bodies another engine moves: contacts and their forces as in a scene, and nothing that moves. An engine
// that spreads its bodies over processes (solver/lammps) has one part in each: the bodies there, and their neighbours.
//
//   Part part({effects, walls, time_step, accuracy});
//   part.renew(bodies, pairs);                     whenever its list of neighbours is new; set_history() of those that it knew
//   part.place(i, position, velocity, ..);         each step, after the drift, velocities at the middle of the step
//   part.press(time, time_step);                   forces of contacts: world().state.force, .torque
//   part.close();                                  once all other forces are there: those of bodies, and the dashpots
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "solver/scene/body/world.hpp"
#include "solver/scene/contact/narrow_phase.hpp"
#include "solver/scene/plan.hpp"

namespace plumb::scene {

/// A material, and how many bodies in all parts are of it: rigid ones that cannot meet need no law.
struct PartMaterial {
  Material material;
  std::size_t movable = 0, fixed = 0;
};

struct PartSettings {
  Effects effects;  ///< all but conduction, and at least one elastic law, here or in the materials
  std::vector<Wall> walls;
  double time_step = 1;
  double accuracy = 1e-3;                 ///< as Run::accuracy
  std::vector<PartMaterial> materials{};  ///< none: all is of one
  std::vector<MaterialPair> material_pairs{};
};

class Part {
 public:
  /// Throws SceneError for what is illegal, or has no place in a part.
  explicit Part(const PartSettings& settings);
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  /// Other bodies, of which place() has to tell where they are, and the pairs that may touch: sorted, body 1 < body 2, walls counted on
  /// after the bodies, each pair as often as body 2 has places. No contact has a history.
  void renew(std::span<const SceneBody> bodies, std::vector<std::array<std::uint32_t, 2>> pairs);

  /// Quaternion (w, x, y, z), unit; momentum in world axes.
  void place(std::size_t body, const Vec3<double>& position, const Vec3<double>& velocity,
             const std::array<double, 4>& quaternion, const Vec3<double>& angular_momentum);

  /// At `time`, to which `time_step` has led: 0 at the start.
  void press(double time, double time_step);
  /// Forces and torques of all bodies of the part being those of all that acts but this.
  void close();
  [[nodiscard]] bool has_closing() const { return !closing_.empty(); }

  /// From the next press() on, or not: world().contacts.force.
  void keep_contact_forces(bool does) { world_.contacts.force = does ? contact_forces_ : nullptr; }

  /// What the effects store in those contacts that `counts` takes.
  [[nodiscard]] double energy(const std::function<bool(std::size_t contact)>& counts);
  /// The same of each contact.
  [[nodiscard]] std::vector<double> energies();

  /// Numbers that a contact remembers.
  [[nodiscard]] std::size_t history_width() const { return width_; }
  /// Their names, for who keeps them longer than the part lives.
  [[nodiscard]] std::string history_names() const;
  /// Whether any of them is another than a new contact's.
  [[nodiscard]] bool has_history(std::size_t contact) const;
  void history(std::size_t contact, std::span<double> out) const;
  void set_history(std::size_t contact, std::span<const double> values);

  [[nodiscard]] World& world() { return world_; }
  [[nodiscard]] const World& world() const { return world_; }
  /// Bodies so far apart are contacts: cohesion's.
  [[nodiscard]] double range() const { return plan_.needs.range; }
  [[nodiscard]] const Totals& totals() const { return totals_; }

 private:
  [[nodiscard]] double stored_energy() const;

  Scene probe_;
  Plan plan_;
  World world_;
  std::vector<Pass> movers_, contacts_, closing_;
  std::vector<Column*> kept_;
  Column* contact_forces_ = nullptr;
  std::size_t width_ = 0;
  Totals totals_;
};

}  // namespace plumb::scene
