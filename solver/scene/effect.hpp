// What an effect is to the plan and to the step loop.
//
// The list of them is effects.hpp. An effect that is not on has no column, no pass and no branch: the loop is a list of passes, and
// only install() adds to it.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "solver/scene/scene.hpp"

namespace plumb::scene {

struct World;

/// What an effect, or an output, needs from the rest.
struct Needs {
  bool contacts = false;                                     ///< which bodies touch, how deep, in which direction
  bool points = false;                                       ///< where
  bool curvature = false;                                    ///< of both surfaces there, as a contact begins
  bool curvature_each_step = false;                          ///< and for as long as it lasts
  bool patch = false;                                        ///< what both bodies have in common: patch.hpp
  bool spin = false;                                         ///< every movable body's angular velocity, also a sphere's
  bool normal_force = false;                                 ///< the column of forces along the normals
  bool contact_force = false;                                ///< all of each contact's, for who reads it
  bool lives = false;                                        ///< of each contact from its first overlap to its last
  bool normal_mass = false;                                  ///< the mass that an impulse along the normal feels
  bool radius = false;                                       ///< of the contact: rolling.hpp
  double range = 0;                                          ///< bodies this far apart count as contacts
  double fastest = std::numeric_limits<double>::infinity();  ///< shortest time in which it does something
};

/// What an effect is in this scene: what it needs, or why it can change nothing (`off`, empty where it can).
struct Role {
  Needs needs;
  std::string off;
  bool is_of_space = false;  ///< there as well where nothing moves
};

/// One effect; the functions of one that is not asked for are never called.
struct Effect {
  std::string_view name;
  bool is_of_pairs;  ///< of materials: each may have its own
  bool (*is_asked)(const Effects& effects);
  /// Gives the scene the neutral one.
  void (*ask)(Effects& effects);
  Role (*role)(const Effects& effects, const Scene& scene);
  /// Adds its columns and passes.
  void (*install)(const Effects& effects, World& world);
};

/// In the order in which they act.
[[nodiscard]] std::span<const Effect> effects();
[[nodiscard]] const Effect* find_effect(std::string_view name);

}  // namespace plumb::scene
