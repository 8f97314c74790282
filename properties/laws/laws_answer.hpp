// The laws on one answer by itself, against the reference: see laws.hpp for the list.
#pragma once

#include "properties/laws/laws.hpp"

namespace plumb::law {

/// The certified solution that the answer is held against: of several that tie within rounding, the nearest.
[[nodiscard]] const Solution& nearest(const Evidence& e);

/// Overlap, normal and both points are numbers.
[[nodiscard]] bool is_whole(const Contact<double>& answer);

[[nodiscard]] bool has_points(const Evidence& e);

/// What the points say of the surfaces and the normals there: three laws from one look, for who asks for all of them.
struct PointFindings {
  Finding opposite, collinear, surface;
};
[[nodiscard]] PointFindings points_show(const Evidence& e);

[[nodiscard]] Finding answers_are_finite(const Evidence& e);
[[nodiscard]] Finding converges(const Evidence& e);
[[nodiscard]] Finding verdict_is_right(const Evidence& e);
[[nodiscard]] Finding has_the_lowest_overlap(const Evidence& e);
[[nodiscard]] Finding normals_are_opposite(const Evidence& e);
[[nodiscard]] Finding points_lie_on_the_normal(const Evidence& e);
[[nodiscard]] Finding agrees_with_itself(const Evidence& e);
[[nodiscard]] Finding normal_agrees(const Evidence& e);
[[nodiscard]] Finding points_are_on_surfaces(const Evidence& e);
[[nodiscard]] Finding overlap_agrees(const Evidence& e);
[[nodiscard]] Finding points_agree(const Evidence& e);
[[nodiscard]] Finding contact_point_is_between(const Evidence& e);
[[nodiscard]] Finding evaluations_are_few(const Evidence& e);

}  // namespace plumb::law
