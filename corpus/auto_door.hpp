// `auto` behind the C door, in one compilation, contact.cpp and all: what libraries that hold it built otherwise share
// (reports/stability/variants.cmake: other compilers and options; fuzz/bugs: with a mistake in it).
#pragma once

#include "solver/contact.cpp"
#include "solver/least_squares_impl.hpp"
#include "solver/method/automatic_impl.hpp"
#include "solver/plumb_solver.h"
#include "solver/pose_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_POSE(double)
PLUMB_INSTANTIATE_LEAST_SQUARES(double)

namespace door {

// The values of Status and Verdict are those of the C door.
static_assert(static_cast<int>(Status::invalid_input) == PLUMB_INVALID_INPUT);
static_assert(static_cast<int>(Verdict::separated) == PLUMB_SEPARATED);

[[nodiscard]] inline Body body_of(const plumb_body& from) {
  Body out;
  out.shape.semi_axes = Vec3<double>::Map(from.semi_axes);
  out.shape.n1 = from.exponents[0];
  out.shape.n2 = from.exponents[1];
  out.position = Vec3<double>::Map(from.position);
  std::copy_n(from.quaternion_wxyz, 4, out.quaternion.begin());
  return out;
}

inline void write(const Contact<double>& found, plumb_contact& contact) {
  contact.status = static_cast<int>(found.status);
  contact.verdict = static_cast<int>(found.verdict);
  contact.overlap = found.overlap;
  Vec3<double>::Map(contact.normal) = found.normal;
  Vec3<double>::Map(contact.points[0]) = found.point1;
  Vec3<double>::Map(contact.points[1]) = found.point2;
  Vec3<double>::Map(contact.contact_point) = found.contact_point;
  contact.iterations = found.iterations;
  contact.evaluations = found.evaluations;
}

/// plumb_solver_solve of `auto`.
inline int solve(const plumb_pair& pair, plumb_contact& contact) {
  write(automatic<double>({body_of(pair.bodies[0]), body_of(pair.bodies[1])}, {}, nullptr), contact);
  return 0;
}

/// The chart's direction (body axes) of a point that was a body's contact before it moved.
[[nodiscard]] inline Vec3<double> chart_at(const Body& body, const double (&point)[3]) {
  const Vec3<double> x = rotation<double>(body.quaternion).transpose() * (Vec3<double>::Map(point) - body.position);
  return chart_of_point<double>(body.shape, x).w;
}

/// plumb_solver_solve_warm: the door hands over no charts, so that a warm start is from where the last points are now.
inline int solve_warm(const plumb_pair& pair, const plumb_contact& last, plumb_contact& contact) {
  const Pair bodies{body_of(pair.bodies[0]), body_of(pair.bodies[1])};
  Contact<double> before;
  before.chart1 = chart_at(bodies.body1, last.points[0]);
  before.chart2 = chart_at(bodies.body2, last.points[1]);
  write(automatic<double>(bodies, {}, &before), contact);
  return 0;
}

}  // namespace door
}  // namespace plumb
