// The arguments of pair_style plumb/cn and its pair_coeff: effects as a scene file names them, "friction.coefficient 0.3".
#pragma once

#include <span>
#include <string>

#include "solver/scene/scene.hpp"

namespace plumb::scene {

struct PairArguments {
  Effects effects;
  double accuracy = 1e-3;  ///< Run::accuracy: sets the solver's tolerance
};

/// NAME.FIELD and its number (three of a vector), or "accuracy" and a number. Throws SceneError: the argument, and why not.
[[nodiscard]] PairArguments parse_pair_arguments(std::span<const std::string> words);

/// What reads back as the same. Gravity and moving walls are left out: they are fixes of their own.
[[nodiscard]] std::string pair_arguments_text(const PairArguments& arguments);

/// What pair_coeff says: of one type its material, of two what holds between them.
struct MaterialArguments {
  Effects effects;
  bool is_rigid = false;
};

/// NAME.FIELD and its number, of effects that materials mix, or "rigid yes". Throws SceneError.
[[nodiscard]] MaterialArguments parse_material_arguments(std::span<const std::string> words);

/// What reads back as the same, a space before each word.
[[nodiscard]] std::string material_arguments_text(const MaterialArguments& arguments);

/// The number that all of a word is. Throws SceneError with the name of what it is for.
[[nodiscard]] double number_of(const std::string& name, const std::string& word);

}  // namespace plumb::scene
