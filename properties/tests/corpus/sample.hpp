// A legal case as text, and the same with one thing changed.
#pragma once

#include <string>

namespace plumb {

inline std::string sample_case() {
  return R"({"format": "plumb/case-1", "name": "sample", "bodies": [)"
         R"({"shape": {"superellipsoid": {"semi_axes": [1, 1, 1]}}, "position": [0, 0, 0],)"
         R"( "orientation": {"quaternion_wxyz": [1, 0, 0, 0]}},)"
         R"( {"shape": {"superellipsoid": {"semi_axes": [1, 1, 1], "exponents": [2, 2]}}, "position": [1.5, 0, 0],)"
         R"( "orientation": {"euler_zxz": [0, 0.5, 0]}}]})";
}

/// The last occurrence is replaced: body 2's where both have it.
inline std::string sample_with(const std::string& old_text, const std::string& new_text) {
  std::string text = sample_case();
  return text.replace(text.rfind(old_text), old_text.size(), new_text);
}

/// With one more field at the end.
inline std::string sample_plus(const std::string& field) {
  const std::string text = sample_case();
  return text.substr(0, text.size() - 1) + ", " + field + "}";
}

inline std::string placed_sample(const std::string& placement) {
  std::string text = sample_plus(R"("placement": )" + placement);
  const std::string position = R"( "position": [1.5, 0, 0],)";
  return text.erase(text.find(position), position.size());
}

}  // namespace plumb
