// The named scenes, used by tests, benchmarks and reports alike. corpus/scenes/ holds each as a file.
#pragma once

#include <span>
#include <string_view>

#include "solver/scene/scene.hpp"

namespace plumb::scene {

/// A row of the list: a name of `plumb scenes` and what makes it.
struct NamedScene {
  std::string_view name;
  std::string_view summary;  ///< one line
  int bodies;                ///< as in the file; 0: the number is fixed
  /// Deterministic; `bodies` as asked for where it may be chosen.
  Scene (*make)(int bodies);
};

/// All of them.
[[nodiscard]] std::span<const NamedScene> named_scenes();
/// nullptr when there is none.
[[nodiscard]] const NamedScene* find_named_scene(std::string_view name);

}  // namespace plumb::scene
