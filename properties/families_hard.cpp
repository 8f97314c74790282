#include "properties/families_hard.hpp"

#include <array>

namespace plumb {
namespace {

constexpr std::array kTable = std::to_array<HardGenerator>({
    {"near_touching_overlapping", hard::near_touching_overlapping},
    {"near_touching_separated", hard::near_touching_separated},
    {"deep_overlap", hard::deep_overlap},
    {"nearly_concentric", hard::nearly_concentric},
    {"concentric", hard::concentric},
    {"one_inside_other", hard::one_inside_other},
    {"far_apart", hard::far_apart},
    {"needle", hard::needle},
    {"disc", hard::disc},
    {"needle_against_disc", hard::needle_against_disc},
    {"size_ratio", hard::size_ratio},
    {"near_spheres", hard::near_spheres},
    {"exponent_near_one", hard::exponent_near_one},
    {"exponent_near_two", hard::exponent_near_two},
    {"exponent_large", hard::exponent_large},
    {"zero_coordinate", hard::zero_coordinate},
    {"face_face", hard::face_face},
    {"edge_face", hard::edge_face},
    {"edge_edge", hard::edge_edge},
    {"corner_face", hard::corner_face},
    {"equal_parallel", hard::equal_parallel},
    {"coaxial", hard::coaxial},
    {"right_angles", hard::right_angles},
    {"tie", hard::tie},
    {"nearly_tie", hard::nearly_tie},
    {"length_unit", hard::length_unit},
    {"far_from_origin", hard::far_from_origin},
    {"huge_numbers", hard::huge_numbers},
    {"subnormal_numbers", hard::subnormal_numbers},
    {"subnormal_offset", hard::subnormal_offset},
    {"quaternion_length", hard::quaternion_length},
});

}  // namespace

std::span<const HardGenerator> hard_generator_table() {
  return kTable;
}

}  // namespace plumb
