// What a spring across a contact keeps where its stiffness changes: while it grows its force, while it falls its stretch. So no approach
// makes energy (Thornton, Cummins & Cleary 2011, Powder Technology 210, 189, after Mindlin & Deresiewicz 1953; LAMMPS's mindlin_rescale/force).
#pragma once

#include <string_view>
#include <utility>

#include "solver/scene/body/world.hpp"

namespace plumb::scene {

class Stiffening {
 public:
  Stiffening() = default;  ///< of a stiffness that never changes
  /// The column holds each contact's stiffness of the step before.
  Stiffening(World& world, std::string_view column, std::string_view owner)
      : before_(&world.columns.add(column, owner, history(1))) {}

  /// The share of its stretch; once a step.
  [[nodiscard]] double kept(std::size_t contact, double stiffness) const {
    if (before_ == nullptr) return 1;
    const double before = std::exchange((*before_)[contact], stiffness);
    return stiffness > before && before > 0 ? before / stiffness : 1;
  }

 private:
  Column* before_ = nullptr;
};

}  // namespace plumb::scene
