#include "properties/doctor/mistakes.hpp"

#include <fmt/format.h>

#include "properties/doctor/misread.hpp"
#include "properties/doctor/mistold.hpp"

namespace plumb::doctor {
namespace {

constexpr std::string_view kNegative = "The overlap has the wrong sign: above 0 the bodies penetrate by that length, "
                                       "below 0 they are that far apart; multiply it by -1.";
constexpr std::string_view kPositive = "The distance of bodies apart comes above 0: the overlap of bodies apart is "
                                       "minus their distance, and their verdict separated.";
constexpr std::string_view kOneFrame = "Normal and points are in body 1's axes and from its position: turn them by "
                                       "body 1's rotation, and add its position to the points.";
constexpr std::string_view kOnePoint = "Both points are the same: points[0] lies on body 1, points[1] on body 2; if "
                                       "there is one alone, claim PLUMB_POINTS_MIDWAY.";
constexpr std::string_view kUnit =
    "Lengths come back divided by the larger body's longest semi-axis: multiply them by it again.";
constexpr std::string_view kOrder = "The quaternion's numbers are read in another order: plumb's is w, x, y, z with "
                                    "the real part first; many libraries take x, y, z, w.";
constexpr std::string_view kDegrees =
    "Rotations become angles in degrees that are read as radians: convert them, or hand over a quaternion or a matrix.";
constexpr std::string_view kRadians =
    "Rotations become angles in radians that are read as degrees: convert them, or hand over a quaternion or a matrix.";
constexpr std::string_view kAxes =
    "The semi-axes are in another order: a, b, c are along the body's x, y, z, and are not sorted.";

constexpr Mistake kMistakes[] = {
    {"normal_reversed",
     "All normals point from body 2 to body 1: plumb wants them from body 1 to body 2; multiply the normal by -1.",
     nullptr, normal_reversed},
    {"normal_in_body1", "The normal is in body 1's axes: plumb wants world axes; turn it by body 1's rotation.",
     nullptr, normal_in_axes_of_body1},
    {"normal_in_body2", "The normal is in body 2's axes: plumb wants world axes; turn it by body 2's rotation.",
     nullptr, normal_in_axes_of_body2},
    {"normal_length", "The normal comes multiplied by the overlap: it is a unit vector; divide it by its length.",
     nullptr, normal_times_depth},
    {"normal_length", "The normal is {:.3g} long: it is a unit vector; divide it by its length.", nullptr,
     normal_of_any_length, &Fit::normal_length},
    {"normal_along_centres",
     "The normal is the line from body 1's centre to body 2's, which is right for spheres alone: hand back the "
     "contact's.",
     nullptr, normal_along_centres},
    {"always_overlapping", "The verdict is always overlapping: say PLUMB_SEPARATED where the overlap is below 0.",
     nullptr, always_overlapping},
    {"always_separated", "The verdict is always separated: say PLUMB_OVERLAPPING where the overlap is above 0.",
     nullptr, always_separated},
    {"verdict_reversed",
     "The verdict is reversed: PLUMB_OVERLAPPING where the overlap is above 0, PLUMB_SEPARATED where it is below.",
     nullptr, verdict_reversed},
    {"verdict_missing",
     "The verdict is never said: PLUMB_OVERLAPPING where the overlap is above 0, else PLUMB_SEPARATED.", nullptr,
     verdict_missing},
    {"depth_negative", kNegative, nullptr, overlap_negative},
    {"depth_negative", kNegative, nullptr, overlap_negative_and_verdict},
    {"distance_positive", kPositive, nullptr, distance_positive},
    {"distance_positive", kPositive, nullptr, distance_positive_and_verdict},
    {"points_exchanged", "The points are exchanged: points[0] lies on body 1, points[1] on body 2.", nullptr,
     points_exchanged},
    {"bodies_exchanged",
     "Bodies 1 and 2 are exchanged: normals point from body 2 to body 1, and points[0] lies on body 2; exchange them, "
     "and turn the normal.",
     nullptr, bodies_exchanged},
    {"points_from_body1",
     "The points are from body 1's position: plumb wants world coordinates; add body 1's position.", nullptr,
     points_from_body1},
    {"points_from_bodies",
     "Each point is from its own body's position: plumb wants world coordinates; add the body's position.", nullptr,
     points_from_bodies},
    {"points_in_body1",
     "The points are in body 1's axes: plumb wants world coordinates; turn them by body 1's rotation and add its "
     "position.",
     nullptr, points_in_axes_of_body1},
    {"points_in_bodies",
     "Each point is in its own body's axes: plumb wants world coordinates; turn it by the body's rotation and add its "
     "position.",
     nullptr, points_in_own_axes},
    {"all_in_body1", kOneFrame, nullptr, all_in_axes_of_body1},
    {"one_point", kOnePoint, nullptr, point1_twice},
    {"one_point", kOnePoint, nullptr, point2_twice},
    {"one_point", kOnePoint, nullptr, middle_twice},
    {"overlap_factor",
     "Every overlap is {:.3g} times the true one: a radius for a diameter, half an overlap, or another unit of length.",
     nullptr, overlap_times_factor, &Fit::overlap_factor},
    {"lengths_factor", "Overlap and points are {:.3g} times the true ones: they come back in another unit of length.",
     nullptr, lengths_times_factor, &Fit::overlap_factor},
    {"unit_lost", kUnit, nullptr, overlap_over_size},
    {"unit_lost", kUnit, nullptr, lengths_over_size},
    {"unit_lost", kUnit, nullptr, lengths_over_size_from_body1},

    {"quaternion_order", kOrder, xyzw_for_wxyz},
    {"quaternion_order", kOrder, wxyz_for_xyzw},
    {"rotation_inverted",
     "Rotations are inverted: the quaternion takes body axes to the world; conjugate it, or transpose the matrix.",
     conjugated},
    {"rotation_ignored", "The bodies are not turned: their quaternions are not handed on.", not_turned},
    {"rotation_of_body1_twice", "Body 2 is turned as body 1 is: its own quaternion is not handed on.", turned_as_body1},
    {"degrees", kDegrees, degrees_for_radians<Angles::zxz>},
    {"degrees", kDegrees, degrees_for_radians<Angles::zyx>},
    {"degrees", kDegrees, degrees_for_radians<Angles::xyz>},
    {"degrees", kDegrees, degrees_for_radians<Angles::vector>},
    {"radians", kRadians, radians_for_degrees<Angles::zxz>},
    {"radians", kRadians, radians_for_degrees<Angles::zyx>},
    {"radians", kRadians, radians_for_degrees<Angles::xyz>},
    {"radians", kRadians, radians_for_degrees<Angles::vector>},
    {"twice_as_large",
     "The bodies are twice as large as they should be: plumb's semi-axes are half of the full lengths; do not double "
     "them.",
     twice_as_large},
    {"half_as_large",
     "The bodies are half as large as they should be: plumb gives semi-axes, and they are taken for full lengths; "
     "double them.",
     half_as_large},
    {"axes_order", kAxes, axes_in_order<0, 2, 1>},
    {"axes_order", kAxes, axes_in_order<1, 0, 2>},
    {"axes_order", kAxes, axes_in_order<1, 2, 0>},
    {"axes_order", kAxes, axes_in_order<2, 0, 1>},
    {"axes_order", kAxes, axes_in_order<2, 1, 0>},
    {"shape_of_body1_twice", "Body 2 has body 1's shape: its own is not handed on.", shaped_as_body1},
    {"exponents_exchanged",
     "The exponents are exchanged: n1 pairs the xy-radius with z, n2 pairs x with y; hand them over the other way "
     "round.",
     exponents_exchanged},
    {"exponents_inverted",
     "Exponents are taken for their inverses: plumb's n is 2/epsilon of superquadrics by epsilon; hand over 2/n, or n.",
     exponents_inverted},
    {"exponents_ignored",
     "The exponents are ignored, every body is an ellipsoid: hand them on, or claim PLUMB_ELLIPSOIDS.",
     exponents_ignored},
    {"position1_ignored",
     "Body 1 is taken to be at the origin: subtract its position from body 2's, and add it to the points.",
     body1_at_origin},
    {"position2_from_body1",
     "Body 2's position is taken from body 1's: plumb's are both world positions; subtract body 1's.",
     position2_from_body1},
    {"line_not_turned",
     "The line between the centres is not turned into body 1's axes as body 2's rotation is: turn it by the inverse of "
     "body 1's.",
     line_not_turned},
};

}  // namespace

std::span<const Mistake> mistakes() {
  return kMistakes;
}

std::string sentence_of(const Mistake& mistake, const Fit& fit) {
  if (mistake.figure == nullptr) return std::string(mistake.sentence);
  return fmt::format(fmt::runtime(mistake.sentence), fit.*mistake.figure);
}

}  // namespace plumb::doctor
