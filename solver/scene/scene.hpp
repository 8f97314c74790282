// What a scene is: bodies, walls, the effects that it asks for, and how it is run. Plain data, read and written in corpus/.
//
// Units    any consistent set: lengths, masses and times of the caller's own; what follows from them (force = mass length/time^2)
// Frames   world frame; a body's quaternion takes body axes, the axes of its shape, to world axes
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/contact.hpp"
#include "solver/scene/effects.hpp"
#include "solver/scene/material/material.hpp"
#include "solver/scene/wall/wall_shape.hpp"

namespace plumb::scene {

/// A homogeneous body. A fixed one never moves, whatever acts on it.
struct SceneBody {
  Body body;
  double density = 1;                                    ///< mass / length^3
  Vec3<double> velocity = Vec3<double>::Zero();          ///< of the centre
  Vec3<double> angular_velocity = Vec3<double>::Zero();  ///< rad / time, world axes
  bool is_fixed = false;
  std::optional<double> temperature;  ///< for conduction
  std::size_t material = 0;           ///< index in the scene's materials, where it has any
};

/// A plane: the half space that `normal` points away from is solid. Others have a shape about their point.
struct Wall {
  Vec3<double> point = Vec3<double>::Zero();
  Vec3<double> normal = Vec3<double>::UnitZ();  ///< any length but 0; of a plane alone
  std::optional<double> temperature;
  std::size_t material = 0;
  WallShape shape{};
  std::array<double, 4> quaternion{1, 0, 0, 0};  ///< (w, x, y, z), any length but 0: of all but a plane
  /// Whether it has no other shape.
  [[nodiscard]] bool is_plane() const { return std::holds_alternative<PlaneWall>(shape); }
};

/// A box along the axes.
struct Region {
  Vec3<double> low, high;
};

/// What is written down as the run goes. `touching` alone asks which pairs overlap, and nothing about where.
struct Outputs {
  double every = 0;                             ///< time between two; 0: the first and the last state only
  bool every_step = false;                      ///< in the place of a time
  bool touching = false;                        ///< pairs that overlap
  bool contacts = false;                        ///< each contact with point, normal, overlap and force
  bool dump = false;                            ///< LAMMPS text dump
  bool vtk = false;                             ///< VTK files
  bool playback = false;                        ///< for the page
  bool energy = false;                          ///< of each effect and of motion
  bool lives = false;                           ///< of each contact how long, how deep, how strong
  bool bulk = false;                            ///< packing fraction, coordination, stress and more: bulk.hpp
  std::optional<Region> region = std::nullopt;  ///< of `bulk`; none: the smallest that holds all bodies
};

/// How long, how finely, and what is written.
struct Run {
  double duration = 0;              ///< 0: the contacts as they stand, nothing moves
  std::optional<double> time_step;  ///< none: from accuracy and the fastest of the effects
  double accuracy = 1e-3;           ///< (0, 1): of a collision; sets the time step and the solver's tolerance
  Outputs outputs;
};

/// A scene, as its file holds it.
struct Scene {
  std::string name;
  std::vector<SceneBody> bodies;
  std::vector<Wall> walls;
  std::vector<Material> materials;  ///< none: all is of one, and the effects say what it does
  std::vector<MaterialPair> material_pairs;
  Effects effects;
  Run run;
};

/// A scene that asks for what has no meaning: which field, and why.
struct SceneError : std::runtime_error {
  /// `field_path` as in the file: bodies[2].density.
  SceneError(std::string field_path, const std::string& reason)
      : std::runtime_error(reason), field(std::move(field_path)) {}
  std::string field;
};

}  // namespace plumb::scene
