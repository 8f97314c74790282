// A legal scene as text, and the same with one thing changed.
#pragma once

#include <string>

#include "corpus/scene/scene_file.hpp"

namespace plumb::scene {

/// Three bodies of three kinds fall on a wall and on each other.
inline std::string sample_scene() {
  return R"({"format": "plumb/scene-1", "name": "sample", "bodies": [)"
         R"({"shape": {"superellipsoid": {"semi_axes": [1, 1, 1], "exponents": [4, 4]}}, "position": [0, 0, 1.3],)"
         R"( "orientation": {"euler_zxz_deg": [10, 20, 30]}},)"
         R"( {"shape": {"superellipsoid": {"semi_axes": [1, 0.8, 0.6]}}, "position": [0.3, 0.2, 3.2],)"
         R"( "orientation": {"quaternion_wxyz": [1, 2, 0, 0]}, "velocity": [0, 0, -1]},)"
         R"( {"shape": {"superellipsoid": {"semi_axes": [0.5, 0.5, 0.5]}}, "position": [0.1, 0, 4.6],)"
         R"( "orientation": {"quaternion_wxyz": [1, 0, 0, 0]}, "density": 2, "angular_velocity": [0, 1, 0]}],)"
         R"( "walls": [{"point": [0, 0, 0], "normal": [0, 0, 1]}],)"
         R"( "effects": {"gravity": {"acceleration": [0, 0, -10]}, "linear": {"stiffness": 10000},)"
         R"( "damping": {"restitution": 0.5}, "friction": {"coefficient": 0.4}},)"
         R"( "run": {"duration": 0.5, "accuracy": 0.001, "outputs": {"every": 0.05,)"
         R"( "write": ["touching", "contacts", "dump", "vtk", "playback", "energy"]}}})";
}

/// The first occurrence is replaced.
inline std::string sample_scene_with(const std::string& old_text, const std::string& new_text) {
  std::string text = sample_scene();
  return text.replace(text.find(old_text), old_text.size(), new_text);
}

/// With one more field at the end.
inline std::string sample_scene_plus(const std::string& field) {
  const std::string text = sample_scene();
  return text.substr(0, text.size() - 1) + ", " + field + "}";
}

/// With these effects and no others.
inline std::string sample_scene_of(const std::string& effects) {
  std::string text = sample_scene();
  const std::size_t begin = text.find(R"("effects": )"), end = text.find(R"(, "run")");
  return text.replace(begin, end - begin, R"("effects": )" + effects);
}

}  // namespace plumb::scene
