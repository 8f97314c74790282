// `auto` behind the C door, plumb_solver.h.
#pragma once

#include "solver/c/door.hpp"
#include "solver/method/automatic.hpp"
#include "solver/pose.hpp"
#include "solver/shape/chart.hpp"
#include "solver/standard_arithmetic.hpp"

namespace plumb::door {

/// plumb_solver_solve of `auto`.
inline int solve(const plumb_pair& pair, plumb_contact& contact) {
  contact = c_contact(automatic<double>(pair_of(pair), {}, nullptr));
  return 0;
}

/// The chart's direction (body axes) of a point that was a body's contact before it moved.
[[nodiscard]] inline Vec3<double> chart_at(const Body& body, const double (&point)[3]) {
  const Vec3<double> x = rotation<double>(body.quaternion).transpose() * (Vec3<double>::Map(point) - body.position);
  return chart_of_point<double>(body.shape, x).w;
}

/// plumb_solver_solve_warm: the door hands over no charts, so that a warm start is from where the last points are now.
inline int solve_warm(const plumb_pair& pair, const plumb_contact& last, plumb_contact& contact) {
  const StandardArithmetic mode;
  const Pair bodies = pair_of(pair);
  Contact<double> before;
  before.chart1 = chart_at(bodies.body1, last.points[0]);
  before.chart2 = chart_at(bodies.body2, last.points[1]);
  contact = c_contact(automatic<double>(bodies, {}, &before));
  return 0;
}

}  // namespace plumb::door
