#include "properties/doctor/mistold.hpp"

#include <cmath>
#include <utility>

#include "solver/pose.hpp"

namespace plumb::doctor {
namespace {

using Vector = Vec3<double>;

/// Each point by its own way, the contact point by body 1's.
template <class Way1, class Way2>
void move_points(Contact<double>& contact, const Way1& way1, const Way2& way2) {
  contact.point1 = way1(contact.point1);
  contact.point2 = way2(contact.point2);
  contact.contact_point = way1(contact.contact_point);
}

template <class Way>
void move_points(Contact<double>& contact, const Way& way) {
  move_points(contact, way, way);
}

Vector in_axes(const Body& body, const Vector& direction) {
  return rotation<double>(body.quaternion).transpose() * direction;
}

void scale_lengths(Told& told, double factor) {
  told.contact.overlap *= factor;
  move_points(told.contact, [&](const Vector& x) { return Vector(factor * x); });
}

Verdict verdict_by_sign(double overlap) {
  return overlap > 0 ? Verdict::overlapping : Verdict::separated;
}

}  // namespace

void normal_reversed(Told& told, const Pair&, const Fit&) {
  told.contact.normal = -told.contact.normal;
}

void normal_in_axes_of_body1(Told& told, const Pair& pair, const Fit&) {
  told.contact.normal = in_axes(pair.body1, told.contact.normal);
}

void normal_in_axes_of_body2(Told& told, const Pair& pair, const Fit&) {
  told.contact.normal = in_axes(pair.body2, told.contact.normal);
}

void normal_times_depth(Told& told, const Pair&, const Fit&) {
  told.contact.normal *= std::abs(told.contact.overlap);
}

void normal_of_any_length(Told& told, const Pair&, const Fit& fit) {
  told.contact.normal *= fit.normal_length;
}

void normal_along_centres(Told& told, const Pair& pair, const Fit&) {
  told.contact.normal = (pair.body2.position - pair.body1.position).normalized();
}

void overlap_negative(Told& told, const Pair&, const Fit&) {
  told.contact.overlap = -told.contact.overlap;
}

void overlap_negative_and_verdict(Told& told, const Pair& pair, const Fit& fit) {
  overlap_negative(told, pair, fit);
  told.contact.verdict = verdict_by_sign(told.contact.overlap);
}

void distance_positive(Told& told, const Pair&, const Fit&) {
  told.contact.overlap = std::abs(told.contact.overlap);
}

void distance_positive_and_verdict(Told& told, const Pair& pair, const Fit& fit) {
  distance_positive(told, pair, fit);
  told.contact.verdict = verdict_by_sign(told.contact.overlap);
}

void overlap_times_factor(Told& told, const Pair&, const Fit& fit) {
  told.contact.overlap *= fit.overlap_factor;
  told.size *= std::abs(fit.overlap_factor);
}

void always_overlapping(Told& told, const Pair&, const Fit&) {
  told.contact.verdict = Verdict::overlapping;
}

void always_separated(Told& told, const Pair&, const Fit&) {
  told.contact.verdict = Verdict::separated;
}

void verdict_reversed(Told& told, const Pair&, const Fit&) {
  told.contact.verdict = told.contact.verdict == Verdict::overlapping ? Verdict::separated : Verdict::overlapping;
}

void verdict_missing(Told& told, const Pair&, const Fit&) {
  told.contact.verdict = Verdict::undecided;
}

void points_exchanged(Told& told, const Pair&, const Fit&) {
  std::swap(told.contact.point1, told.contact.point2);
}

void bodies_exchanged(Told& told, const Pair& pair, const Fit& fit) {
  normal_reversed(told, pair, fit);
  points_exchanged(told, pair, fit);
}

void points_from_body1(Told& told, const Pair& pair, const Fit&) {
  move_points(told.contact, [&](const Vector& x) { return Vector(x - pair.body1.position); });
}

void points_from_bodies(Told& told, const Pair& pair, const Fit&) {
  move_points(
      told.contact, [&](const Vector& x) { return Vector(x - pair.body1.position); },
      [&](const Vector& x) { return Vector(x - pair.body2.position); });
}

void points_in_axes_of_body1(Told& told, const Pair& pair, const Fit&) {
  move_points(told.contact, [&](const Vector& x) { return in_axes(pair.body1, x - pair.body1.position); });
}

void points_in_own_axes(Told& told, const Pair& pair, const Fit&) {
  move_points(
      told.contact, [&](const Vector& x) { return in_axes(pair.body1, x - pair.body1.position); },
      [&](const Vector& x) { return in_axes(pair.body2, x - pair.body2.position); });
}

void all_in_axes_of_body1(Told& told, const Pair& pair, const Fit& fit) {
  normal_in_axes_of_body1(told, pair, fit);
  points_in_axes_of_body1(told, pair, fit);
}

void point1_twice(Told& told, const Pair&, const Fit&) {
  told.contact.point2 = told.contact.point1;
}

void point2_twice(Told& told, const Pair&, const Fit&) {
  told.contact.point1 = told.contact.point2;
}

void middle_twice(Told& told, const Pair&, const Fit&) {
  told.contact.point1 = told.contact.point2 = (told.contact.point1 + told.contact.point2) / 2;
}

void lengths_times_factor(Told& told, const Pair&, const Fit& fit) {
  scale_lengths(told, fit.overlap_factor);
  told.size *= std::abs(fit.overlap_factor);
}

void overlap_over_size(Told& told, const Pair& pair, const Fit&) {
  told.contact.overlap /= size_of(pair);
}

void lengths_over_size(Told& told, const Pair& pair, const Fit&) {
  scale_lengths(told, 1 / size_of(pair));
  told.size = 1;
}

void lengths_over_size_from_body1(Told& told, const Pair& pair, const Fit& fit) {
  points_from_body1(told, pair, fit);
  lengths_over_size(told, pair, fit);
}

}  // namespace plumb::doctor
