// Motions: sequences of poses of two bodies that a tracker should follow, each through one place where warm starts break.
// A face turns through parallel, a body slides over an edge or rolls through a tie: small steps, and smaller ones there.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "properties/generators/draft.hpp"

namespace plumb {

struct Path {
  std::string_view name;  ///< a file's name as well
  std::string_view summary;
  std::vector<Draft> (*draw)();
};
[[nodiscard]] std::span<const Path> paths();

/// The steps of a path, in their order; the same on any machine with the same math library. Provenance: path, step (from 0),
/// steps, and what is steered.
[[nodiscard]] std::vector<Case> steps_of(const Path& path);
/// Of any motion.
[[nodiscard]] std::vector<Case> steps_of(std::string_view name, const std::vector<Draft>& drafts);

/// As the file that holds them: one case a line.
[[nodiscard]] std::string format_steps(const std::vector<Case>& steps);

/// paths_motions.cpp. `exponent`: n1 and n2 of the blocks.
namespace motion {

[[nodiscard]] std::vector<Draft> face_turn(double exponent);
[[nodiscard]] std::vector<Draft> slide_over_edge(double exponent);
[[nodiscard]] std::vector<Draft> roll_through_tie(double exponent);
[[nodiscard]] std::vector<Draft> slide_through_tie(double exponent);
[[nodiscard]] std::vector<Draft> touch_and_part(double exponent);
[[nodiscard]] std::vector<Draft> through_concentric(double exponent);
/// `distance`: of the centres of two spheroids of semi-axes 0.5, 0.5, 1.
[[nodiscard]] std::vector<Draft> spin_about_axis(double distance);
[[nodiscard]] std::vector<Draft> needle_sweep();
[[nodiscard]] std::vector<Draft> far_jump(double exponent);

}  // namespace motion
}  // namespace plumb
