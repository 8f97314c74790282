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
         R"( "write": ["touching", "contacts", "dump", "vtk", "playback", "energy", "lives", "bulk"]}}})";
}

/// The first occurrence is replaced.
inline std::string sample_scene_with(const std::string& old_text, const std::string& new_text) {
  std::string text = sample_scene();
  return text.replace(text.find(old_text), old_text.size(), new_text);
}

/// Whose bulk is of a region.
inline std::string sample_scene_with_region(const std::string& low, const std::string& high) {
  return sample_scene_with(R"("bulk"])", R"("bulk"], "region": {"low": )" + low + R"(, "high": )" + high + "}");
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

/// Bodies of glass on a rigid floor.
inline std::string sample_with_materials() {
  std::string text = sample_scene_of(R"({"gravity": {"acceleration": [0, 0, -10]}, "damping": {"restitution": 0.5}})");
  const auto put = [&](const std::string& before, const std::string& more) { text.insert(text.find(before), more); };
  put(R"("bodies")",
      R"("materials": {"glass": {"density": 3, "linear": {"stiffness": 10000}, "friction": {"coefficient": 0.4}},)"
      R"( "floor": {"rigid": true}, "pairs": [{"between": ["floor", "glass"], "friction": {"coefficient": 0.2}}]}, )");
  std::size_t at = 0;
  while ((at = text.find(R"("position")", at)) != std::string::npos) {
    const std::string material = R"("material": "glass", )";
    text.insert(at, material);
    at += material.size() + 1;
  }
  put(R"("point")", R"("material": "floor", )");
  return text;
}

/// With a wall of every shape after the plane.
inline std::string sample_with_walls() {
  return sample_scene_with(
      R"("normal": [0, 0, 1]}])",
      R"("normal": [0, 0, 1]},)"
      R"( {"mesh": {"triangles": [[[0, 0, -5], [1, 0, -5], [0, 1, -5]]], "smooth_deg": 10}, "position": [0, 0, 1],)"
      R"( "orientation": {"quaternion_wxyz": [2, 0, 0, 1]}, "temperature": 3},)"
      R"( {"cylinder": {"radius": 9, "half_length": 8, "side": "inside", "ends": ["closed", "bare"]}},)"
      R"( {"cone": {"radii": [8, 9], "height": 20, "ends": "open"}, "position": [0, 0, -1]},)"
      R"( {"cone": {"radii": [1, 0], "height": 2, "side": "outside"}, "position": [7, 0, 0]},)"
      R"( {"box": {"half_extents": [9, 9, 9]}}, {"box": {"half_extents": [1, 1, 1], "side": "outside"}, "position": [-7, 0, 0]}])");
}

/// The same with the first occurrence replaced.
inline std::string sample_with_materials_with(const std::string& old_text, const std::string& new_text) {
  std::string text = sample_with_materials();
  return text.replace(text.find(old_text), old_text.size(), new_text);
}

}  // namespace plumb::scene
