// Right answers as an adapter with a mistake hands them back.
#pragma once

#include "properties/doctor/mistakes.hpp"

namespace plumb::doctor {

// Normals.
void normal_reversed(Told& told, const Pair& pair, const Fit& fit);
void normal_in_axes_of_body1(Told& told, const Pair& pair, const Fit& fit);
void normal_in_axes_of_body2(Told& told, const Pair& pair, const Fit& fit);
void normal_times_depth(Told& told, const Pair& pair, const Fit& fit);
void normal_of_any_length(Told& told, const Pair& pair, const Fit& fit);
void normal_along_centres(Told& told, const Pair& pair, const Fit& fit);

// Overlaps and verdicts.
void overlap_negative(Told& told, const Pair& pair, const Fit& fit);
void overlap_negative_and_verdict(Told& told, const Pair& pair, const Fit& fit);
void distance_positive(Told& told, const Pair& pair, const Fit& fit);
void distance_positive_and_verdict(Told& told, const Pair& pair, const Fit& fit);
void overlap_times_factor(Told& told, const Pair& pair, const Fit& fit);
void always_overlapping(Told& told, const Pair& pair, const Fit& fit);
void always_separated(Told& told, const Pair& pair, const Fit& fit);
void verdict_reversed(Told& told, const Pair& pair, const Fit& fit);
void verdict_missing(Told& told, const Pair& pair, const Fit& fit);

// Points.
void points_exchanged(Told& told, const Pair& pair, const Fit& fit);
void bodies_exchanged(Told& told, const Pair& pair, const Fit& fit);
void points_from_body1(Told& told, const Pair& pair, const Fit& fit);
void points_from_bodies(Told& told, const Pair& pair, const Fit& fit);
void points_in_axes_of_body1(Told& told, const Pair& pair, const Fit& fit);
void points_in_own_axes(Told& told, const Pair& pair, const Fit& fit);
void all_in_axes_of_body1(Told& told, const Pair& pair, const Fit& fit);
void point1_twice(Told& told, const Pair& pair, const Fit& fit);
void point2_twice(Told& told, const Pair& pair, const Fit& fit);
void middle_twice(Told& told, const Pair& pair, const Fit& fit);

// Units.
void lengths_times_factor(Told& told, const Pair& pair, const Fit& fit);
void overlap_over_size(Told& told, const Pair& pair, const Fit& fit);
void lengths_over_size(Told& told, const Pair& pair, const Fit& fit);
void lengths_over_size_from_body1(Told& told, const Pair& pair, const Fit& fit);

}  // namespace plumb::doctor
