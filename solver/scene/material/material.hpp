// What bodies and walls are made of: what a material has of itself, and what two of them have together.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "solver/scene/effects.hpp"

namespace plumb::scene {

/// Its effects are those that mix (parameter.hpp); one that it has not is as the scene's effects say.
struct Material {
  std::string name;
  std::optional<double> density;  ///< of bodies that have none of their own
  bool is_rigid = false;          ///< what it touches takes all of the overlap
  Effects effects;
};

/// What holds between two materials, in the place of what mixing their own would give.
struct MaterialPair {
  std::array<std::size_t, 2> between{};  ///< indices in the scene's materials
  Effects effects;
};

}  // namespace plumb::scene
