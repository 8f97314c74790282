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

// The library may write any integer; what is no status vouches for nothing.
[[nodiscard]] inline Status status_of(int status) {
  switch (status) {
    case PLUMB_CONVERGED: return Status::converged;
    case PLUMB_ITERATION_LIMIT: return Status::iteration_limit;
    case PLUMB_SINGULAR: return Status::singular;
    case PLUMB_NOT_FINITE: return Status::not_finite;
    case PLUMB_INVALID_INPUT: return Status::invalid_input;
    default: return Status::stalled;
  }
}

[[nodiscard]] inline Verdict verdict_of(int verdict) {
  if (verdict == PLUMB_OVERLAPPING) return Verdict::overlapping;
  return verdict == PLUMB_SEPARATED ? Verdict::separated : Verdict::undecided;
}

[[nodiscard]] inline Contact<double> contact_of(const plumb_contact& answer) {
  Contact<double> out;
  out.status = status_of(answer.status);
  out.verdict = verdict_of(answer.verdict);
  out.overlap = answer.overlap;
  out.normal = Vec3<double>::Map(answer.normal);
  out.point1 = Vec3<double>::Map(answer.points[0]);
  out.point2 = Vec3<double>::Map(answer.points[1]);
  out.contact_point = Vec3<double>::Map(answer.contact_point);
  out.iterations = answer.iterations;
  out.evaluations = answer.evaluations;
  return out;
}

}  // namespace plumb::door
