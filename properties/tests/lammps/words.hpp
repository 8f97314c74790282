// Arguments of a script's commands, and how they are refused.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "solver/scene/scene.hpp"

namespace plumb::scene {

[[nodiscard]] inline std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> out;
  for (std::string word; in >> word;) out.push_back(word);
  return out;
}

/// "FIELD: REASON", or "none".
template <class Parse>
[[nodiscard]] std::string refusal_by(const Parse& parse, const std::string& text) {
  try {
    (void)parse(words_of(text));
  } catch (const SceneError& error) {
    return error.field + ": " + error.what();
  }
  return "none";
}

}  // namespace plumb::scene
