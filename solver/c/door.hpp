// The structs of plumb_solver.h and those of contact.hpp, each from the other: what the C API, the foreign solvers and the libraries
// that hold `auto` behind the C door share.
#pragma once

#include <algorithm>

#include "solver/contact.hpp"
#include "solver/plumb_solver.h"

namespace plumb::door {

static_assert(static_cast<int>(Status::converged) == PLUMB_CONVERGED);
static_assert(static_cast<int>(Status::iteration_limit) == PLUMB_ITERATION_LIMIT);
static_assert(static_cast<int>(Status::stalled) == PLUMB_STALLED);
static_assert(static_cast<int>(Status::singular) == PLUMB_SINGULAR);
static_assert(static_cast<int>(Status::not_finite) == PLUMB_NOT_FINITE);
static_assert(static_cast<int>(Status::invalid_input) == PLUMB_INVALID_INPUT);
static_assert(static_cast<int>(Verdict::undecided) == PLUMB_UNDECIDED);
static_assert(static_cast<int>(Verdict::overlapping) == PLUMB_OVERLAPPING);
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

/// The door has no motion.
[[nodiscard]] inline Pair pair_of(const plumb_pair& from) {
  return {body_of(from.bodies[0]), body_of(from.bodies[1])};
}

[[nodiscard]] inline plumb_body c_body(const Body& from) {
  plumb_body out{};
  Vec3<double>::Map(out.semi_axes) = from.shape.semi_axes;
  out.exponents[0] = from.shape.n1;
  out.exponents[1] = from.shape.n2;
  Vec3<double>::Map(out.position) = from.position;
  std::copy_n(from.quaternion.begin(), 4, out.quaternion_wxyz);
  return out;
}

[[nodiscard]] inline plumb_pair c_pair(const Pair& from) {
  return {{c_body(from.body1), c_body(from.body2)}};
}

[[nodiscard]] inline plumb_contact c_contact(const Contact<double>& from) {
  plumb_contact out{};
  out.status = static_cast<int>(from.status);
  out.verdict = static_cast<int>(from.verdict);
  out.overlap = from.overlap;
  Vec3<double>::Map(out.normal) = from.normal;
  Vec3<double>::Map(out.points[0]) = from.point1;
  Vec3<double>::Map(out.points[1]) = from.point2;
  Vec3<double>::Map(out.contact_point) = from.contact_point;
  out.iterations = from.iterations;
  out.evaluations = from.evaluations;
  return out;
}

}  // namespace plumb::door
