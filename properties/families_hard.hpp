// The family `hard`: one generator for each special place, in four files by what makes it hard.
//
// Adding one: a function below, its body in the file that fits, a row in families_hard.cpp.
#pragma once

#include <span>
#include <string_view>

#include "properties/draft.hpp"

namespace plumb {

struct HardGenerator {
  std::string_view name;
  void (*draw)(Stream&, Draft&);
};
[[nodiscard]] std::span<const HardGenerator> hard_generator_table();

namespace hard {

// families_hard_overlap.cpp: how far the bodies are in or apart
void near_touching_overlapping(Stream&, Draft&);
void near_touching_separated(Stream&, Draft&);
void deep_overlap(Stream&, Draft&);
void nearly_concentric(Stream&, Draft&);
void concentric(Stream&, Draft&);
void one_inside_other(Stream&, Draft&);
void far_apart(Stream&, Draft&);

// families_hard_shape.cpp: the shapes
void needle(Stream&, Draft&);
void disc(Stream&, Draft&);
void needle_against_disc(Stream&, Draft&);
void size_ratio(Stream&, Draft&);
void near_spheres(Stream&, Draft&);
void exponent_near_one(Stream&, Draft&);
void exponent_near_two(Stream&, Draft&);
void exponent_large(Stream&, Draft&);
void zero_coordinate(Stream&, Draft&);

// families_hard_pose.cpp: faces, edges and corners, symmetry
void face_face(Stream&, Draft&);
void edge_face(Stream&, Draft&);
void edge_edge(Stream&, Draft&);
void corner_face(Stream&, Draft&);
void equal_parallel(Stream&, Draft&);
void coaxial(Stream&, Draft&);
void right_angles(Stream&, Draft&);
void tie(Stream&, Draft&);
void nearly_tie(Stream&, Draft&);

// families_hard_number.cpp: the numbers themselves
void length_unit(Stream&, Draft&);
void far_from_origin(Stream&, Draft&);
void huge_numbers(Stream&, Draft&);
void subnormal_numbers(Stream&, Draft&);
void subnormal_offset(Stream&, Draft&);
void quaternion_length(Stream&, Draft&);

}  // namespace hard
}  // namespace plumb
