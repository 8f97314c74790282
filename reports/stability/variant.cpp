// `auto` behind the C door, in one compilation, contact.cpp and all: what variants.cmake builds with other compilers and options.
#include "solver/contact.cpp"
#include "solver/least_squares_impl.hpp"
#include "solver/method/automatic_impl.hpp"
#include "solver/plumb_solver.h"
#include "solver/pose_impl.hpp"

namespace plumb {

PLUMB_INSTANTIATE_POSE(double)
PLUMB_INSTANTIATE_LEAST_SQUARES(double)

namespace {

Body body_of(const plumb_body& from) {
  Body out;
  out.shape.semi_axes = Vec3<double>::Map(from.semi_axes);
  out.shape.n1 = from.exponents[0];
  out.shape.n2 = from.exponents[1];
  out.position = Vec3<double>::Map(from.position);
  std::copy_n(from.quaternion_wxyz, 4, out.quaternion.begin());
  return out;
}

}  // namespace
}  // namespace plumb

// The values of Status and Verdict are those of the C door.
static_assert(static_cast<int>(plumb::Status::invalid_input) == PLUMB_INVALID_INPUT);
static_assert(static_cast<int>(plumb::Verdict::separated) == PLUMB_SEPARATED);

extern "C" int plumb_solver_version() {
  return PLUMB_SOLVER_VERSION;
}

extern "C" int plumb_solver_solve(const plumb_pair* pair, plumb_contact* contact) {
  using plumb::Vec3;
  const plumb::Contact<double> found =
      plumb::automatic<double>({plumb::body_of(pair->bodies[0]), plumb::body_of(pair->bodies[1])}, {}, nullptr);
  contact->status = static_cast<int>(found.status);
  contact->verdict = static_cast<int>(found.verdict);
  contact->overlap = found.overlap;
  Vec3<double>::Map(contact->normal) = found.normal;
  Vec3<double>::Map(contact->points[0]) = found.point1;
  Vec3<double>::Map(contact->points[1]) = found.point2;
  Vec3<double>::Map(contact->contact_point) = found.contact_point;
  contact->iterations = found.iterations;
  contact->evaluations = found.evaluations;
  return 0;
}
