// Scene files, format plumb/scene-1: the one reader and writer. Format and meaning: corpus/formats/scene.md, scene-1.schema.json.
#pragma once

#include <string>

#include "corpus/json/json_text.hpp"
#include "solver/scene/plan.hpp"

namespace plumb::scene {

struct SceneFile {
  Scene scene;
  Json provenance;  ///< anything; null when absent
  Json extra;       ///< the top-level fields whose names begin with "x_", as an object; null when there are none
};

/// Reads a legal scene from JSON text; `file` names the source in errors. Throws InputFailure.
[[nodiscard]] SceneFile parse_scene(const std::string& text, const std::string& file);
/// From a file, or "-" for standard input. Throws InputFailure.
[[nodiscard]] SceneFile read_scene(const std::string& path);

/// A line a body; position and quaternion only, each number the shortest that reads back the same.
[[nodiscard]] std::string format_scene(const SceneFile& file);

/// As the file holds them.
[[nodiscard]] Json effects_json(const Effects& effects);

/// make_plan(), with what has no meaning as an InputFailure.
[[nodiscard]] Plan plan_scene(const Scene& scene, const PlanOptions& options, const std::string& file);

/// The words of run.outputs.write and what each stands for.
struct OutputWord {
  std::string_view word;
  bool Outputs::* asked;
};
[[nodiscard]] std::span<const OutputWord> output_words();

}  // namespace plumb::scene
