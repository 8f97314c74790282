// Bytes -> small scene -> the laws that hold to the bit. A scene that breaks one is kept in PLUMB_FUZZ_OUT (target_settings.hpp),
// ready for plumb scene.
#include <fmt/format.h>

#include <array>

#include "corpus/scene/scene_file.hpp"
#include "fuzz/layouts/decode_scene.hpp"
#include "fuzz/targets/target.hpp"
#include "fuzz/targets/target_settings.hpp"
#include "properties/laws/motion/scene.hpp"

namespace plumb {
namespace {

/// Of the first law that is broken.
std::string find_broken(const scene::SceneRecipe& recipe) {
  const std::string forced =
      recipe.forced.empty() ? "" : find_neutral_change(recipe.scene, recipe.scene, recipe.forced);
  if (!forced.empty()) return "neutral: " + forced;
  const std::string snapshot = find_snapshot_change(recipe.scene, recipe.snapshot_step);
  if (!snapshot.empty()) return "snapshot: " + snapshot;
  const std::string force = find_force_without_opposite(recipe.scene);
  if (!force.empty()) return "third law: " + force;
  const std::string lost = find_lost_body(recipe.scene);
  return lost.empty() ? "" : "lost: " + lost;
}

}  // namespace

Outcome examine(std::span<const std::uint8_t> bytes) {
  const scene::SceneRecipe recipe = scene::decode_scene(bytes);
  const std::string broken = find_broken(recipe);
  if (broken.empty())
    return {false, fmt::format("none with {} bodies, {} forced on", recipe.scene.bodies.size(),
                               recipe.forced.empty() ? "nothing" : recipe.forced)};
  keep_fuzzed(broken.substr(0, broken.find(':')) + "--fuzzed.json", scene::format_scene({recipe.scene, {}, {}}) + "\n");
  return {true, broken};
}

}  // namespace plumb
