// The family `hard`: one generator for each special place, in four files by what makes it hard, and the ladder of each: what is
// steered, from easy to the last representable step.
//
// Adding one: a function below, its body in the file that fits, a row in families_hard.cpp.
#pragma once

#include <span>
#include <string_view>

#include "properties/generators/draft.hpp"

namespace plumb {

inline constexpr std::string_view hard_family = "hard";

struct HardGenerator {
  std::string_view name;
  std::string_view knob;          ///< what is steered
  std::span<const double> steps;  ///< its values, the easiest first
  void (*draw)(Stream&, double knob, Draft&);
};
[[nodiscard]] std::span<const HardGenerator> hard_generator_table();

namespace hard {

// families_hard_overlap.cpp: how far the bodies are in or apart
void near_touching_overlapping(Stream&, double overlap_ratio, Draft&);
void near_touching_separated(Stream&, double gap_ratio, Draft&);
void deep_overlap(Stream&, double overlap_ratio, Draft&);
void nearly_concentric(Stream&, double centre_distance, Draft&);
void one_inside_other(Stream&, double size_ratio, Draft&);
void far_apart(Stream&, double gap_ratio, Draft&);
void shallow_spheroids(Stream&, double overlap_ratio, Draft&);

// families_hard_shape.cpp: the shapes
void needle(Stream&, double aspect, Draft&);
void disc(Stream&, double aspect, Draft&);
void needle_against_disc(Stream&, double aspect, Draft&);
void deep_slender(Stream&, double aspect, Draft&);
void size_ratio(Stream&, double ratio, Draft&);
void near_spheres(Stream&, double deviation, Draft&);
void exponent_near_one(Stream&, double exponent, Draft&);
void exponent_near_two(Stream&, double deviation, Draft&);
void exponent_large(Stream&, double exponent, Draft&);
void zero_coordinate(Stream&, double coordinate, Draft&);
void across_a_face(Stream&, double exponent, Draft&);

// families_hard_pose.cpp: faces, edges and corners, symmetry
void face_face(Stream&, double tilt, Draft&);
void edge_face(Stream&, double tilt, Draft&);
void edge_edge(Stream&, double tilt, Draft&);
void corner_face(Stream&, double tilt, Draft&);
void equal_parallel(Stream&, double overlap_ratio, Draft&);
void coaxial(Stream&, double offset, Draft&);
void right_angles(Stream&, double offset, Draft&);
void tie(Stream&, double broken_by, Draft&);

// families_hard_number.cpp: the numbers themselves
void length_unit(Stream&, double unit, Draft&);
void unit_of_faces(Stream&, double unit, Draft&);
void far_from_origin(Stream&, double distance, Draft&);
void huge_numbers(Stream&, double unit, Draft&);
void subnormal_numbers(Stream&, double unit, Draft&);
void subnormal_offset(Stream&, double offset, Draft&);
void quaternion_length(Stream&, double length, Draft&);

}  // namespace hard
}  // namespace plumb
