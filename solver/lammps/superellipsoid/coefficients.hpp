// What pair_coeff of LAMMPS's pair_style granular/superellipsoid says (LAMMPS 30Mar2026 and later), as effects of a scene.
//
//   hooke|hertz K ETA tangential linear_history KT SHARE MU [damping mass_velocity|viscoelastic] [limit_damping] [cutoff C]
//
// hooke         linear.stiffness K
// hertz         K sqrt(R) overlap^(3/2): hertz with E* = 3/4 K, whose patch is an ellipse where LAMMPS's is a circle
// ETA           damping.mass_velocity, or damping.viscoelastic, as where no damping is named
// limit_damping damping.pull 0
// tangential    friction.stiffness KT, friction.normal_share SHARE, friction.coefficient MU
#pragma once

#include <span>
#include <string>

#include "solver/scene/scene.hpp"

namespace plumb::scene {

/// Of two types of atoms. Units as LAMMPS has them.
struct SuperellipsoidCoefficients {
  bool is_hertz = false;
  bool is_by_mass = false;  ///< damping mass_velocity
  bool is_limited = false;  ///< limit_damping
  double stiffness = 0, damping = 0;
  double tangential_stiffness = 0, damping_share = 0, friction = 0;

  [[nodiscard]] bool operator==(const SuperellipsoidCoefficients&) const = default;
};

/// Throws SceneError: the word, and why not.
[[nodiscard]] SuperellipsoidCoefficients parse_superellipsoid_coefficients(std::span<const std::string> words);

/// Geometric means, as LAMMPS mixes them. Throws SceneError where the models are not the same.
[[nodiscard]] SuperellipsoidCoefficients mixed(const SuperellipsoidCoefficients& first,
                                               const SuperellipsoidCoefficients& second);

[[nodiscard]] Effects effects_of(const SuperellipsoidCoefficients& coefficients);

}  // namespace plumb::scene
