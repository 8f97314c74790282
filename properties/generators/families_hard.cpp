#include "properties/generators/families_hard.hpp"

#include <array>

namespace plumb {
namespace {

constexpr double kUlp = std::numeric_limits<double>::epsilon();
constexpr double kLeast = std::numeric_limits<double>::denorm_min();

constexpr std::array kTouching{1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-15, 1e-16};
constexpr std::array kDepth{0.3, 0.5, 0.7, 0.9, 0.97, 0.99};
constexpr std::array kCentres{1e-2, 1e-4, 1e-8, 1e-12, 1e-16, 1e-100, 1e-300, kLeast, 0.0};
constexpr std::array kInside{3.5, 10.0, 30.0, 1e2, 1e4, 1e6};
constexpr std::array kApart{1.0, 1e1, 1e2, 1e4, 1e6, 1e9};
constexpr std::array kShallow{5e-2, 2e-2, 1e-2, 1e-3, 3e-4, 1e-6, 1e-9, 1e-12};
constexpr std::array kAspect{10.0, 30.0, 100.0, 300.0, 1e3, 3e3, 1e4};
constexpr std::array kSlender{2.0, 5.0, 10.0, 20.0, 50.0, 100.0};
constexpr std::array kSizes{1e2, 1e3, 1e4, 1e5, 1e6};
constexpr std::array kRoundness{1e-3, 1e-6, 1e-9, 1e-12, 1e-14, 1e-15, kUlp, 0.0};
constexpr std::array kNearOne{1.5, 1.4, 1.3, 1.2, 1.15, 1.1};
constexpr std::array kNearTwo{1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 2 * kUlp};
constexpr std::array kLarge{8.0, 12.0, 20.0, 30.0, 40.0, 50.0};
constexpr std::array kZero{1e-2, 1e-4, 1e-8, 1e-12, 1e-16, 1e-100, 1e-300, 0.0};
constexpr std::array kTilt{1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-16, 0.0};
constexpr std::array kParallel{0.5, 0.1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10};
constexpr std::array kOffset{1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, kUlp, 0.0};
constexpr std::array kUnits{1e-3, 1e3, 1e-6, 1e6, 1e-9, 1e9, 1e-12, 1e12};
constexpr std::array kSmallUnits{1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6};
constexpr std::array kOrigin{10.0, 1e3, 1e5, 1e7, 1e9};
constexpr std::array kHuge{1e100, 1e150, 1e200, 1e250, 1e300, 1e307};
constexpr std::array kSubnormal{1e-100, 1e-200, 1e-300, 1e-308, 1e-312, 1e-316, 1e-319};
constexpr std::array kSubnormalOffset{1e-20, 1e-100, 1e-300, 1e-310, 1e-320, kLeast};
constexpr std::array kLengths{1e-1, 1e1, 1e-100, 1e100, 1e-300, 1e300, 1e-310, 1e-318};

constexpr std::array kTable = std::to_array<HardGenerator>({
    {"near_touching_overlapping", "overlap_ratio", kTouching, hard::near_touching_overlapping},
    {"near_touching_separated", "gap_ratio", kTouching, hard::near_touching_separated},
    {"deep_overlap", "overlap_ratio", kDepth, hard::deep_overlap},
    {"nearly_concentric", "centre_distance", kCentres, hard::nearly_concentric},
    {"one_inside_other", "size_ratio", kInside, hard::one_inside_other},
    {"far_apart", "gap_ratio", kApart, hard::far_apart},
    {"shallow_spheroids", "overlap_ratio", kShallow, hard::shallow_spheroids},
    {"needle", "aspect", kAspect, hard::needle},
    {"disc", "aspect", kAspect, hard::disc},
    {"needle_against_disc", "aspect", kAspect, hard::needle_against_disc},
    {"deep_slender", "aspect", kSlender, hard::deep_slender},
    {"size_ratio", "size_ratio", kSizes, hard::size_ratio},
    {"near_spheres", "deviation", kRoundness, hard::near_spheres},
    {"exponent_near_one", "exponent", kNearOne, hard::exponent_near_one},
    {"exponent_near_two", "deviation", kNearTwo, hard::exponent_near_two},
    {"exponent_large", "exponent", kLarge, hard::exponent_large},
    {"zero_coordinate", "coordinate", kZero, hard::zero_coordinate},
    {"across_a_face", "exponent", kLarge, hard::across_a_face},
    {"face_face", "tilt", kTilt, hard::face_face},
    {"edge_face", "tilt", kTilt, hard::edge_face},
    {"edge_edge", "tilt", kTilt, hard::edge_edge},
    {"corner_face", "tilt", kTilt, hard::corner_face},
    {"equal_parallel", "overlap_ratio", kParallel, hard::equal_parallel},
    {"coaxial", "offset", kOffset, hard::coaxial},
    {"right_angles", "offset", kOffset, hard::right_angles},
    {"tie", "broken_by", kOffset, hard::tie},
    {"length_unit", "unit", kUnits, hard::length_unit},
    {"unit_of_faces", "unit", kSmallUnits, hard::unit_of_faces},
    {"far_from_origin", "origin_distance", kOrigin, hard::far_from_origin},
    {"huge_numbers", "unit", kHuge, hard::huge_numbers},
    {"subnormal_numbers", "unit", kSubnormal, hard::subnormal_numbers},
    {"subnormal_offset", "offset", kSubnormalOffset, hard::subnormal_offset},
    {"quaternion_length", "length", kLengths, hard::quaternion_length},
});

}  // namespace

std::span<const HardGenerator> hard_generator_table() {
  return kTable;
}

}  // namespace plumb
