// What the effects of a contact are between two materials: given for the pair, else one material's own, else mixed of both.
//
//   hertz    1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 (Johnson 1985, eq. 4.23); rigid: 1/E = 0
//   linear   springs in series, 2/k = 1/k1 + 1/k2; rigid: 1/k = 0
//   others   the geometric mean of each field, as LAMMPS's pair_style granular does
#pragma once

#include <string>
#include <vector>

#include "solver/scene/scene.hpp"

namespace plumb::scene {

/// Row by row, a row a material. Empty where the scene names none: its effects are those of every contact.
struct PairEffects {
  std::size_t materials = 0;
  std::vector<Effects> of;
  std::vector<char>
      meets;  ///< whether a body of the one that can move may meet the other; what does not has no effects

  [[nodiscard]] std::size_t at(std::size_t first, std::size_t second) const { return first * materials + second; }
  [[nodiscard]] bool has_any() const;
};

/// Of all pairs that can meet. Throws SceneError where two have no elastic law together.
[[nodiscard]] PairEffects pair_effects(const Scene& scene);

/// The scene's, and what only some pairs have; of a cohesion the longest range.
[[nodiscard]] Effects effects_of_all(const Scene& scene, const PairEffects& pairs);

/// The pair that the scene gives; nullptr where it gives none.
[[nodiscard]] const MaterialPair* given_pair(const Scene& scene, std::size_t first, std::size_t second);

/// "glass and steel"
[[nodiscard]] std::string names_of_pair(const Scene& scene, std::size_t first, std::size_t second);

}  // namespace plumb::scene
