// `auto` behind the C door with the fault that the environment variable PLUMB_PLANTED names; without one it is right.
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "solver/c/auto_door.hpp"

namespace {

using plumb::Vec3;

std::string_view fault() {
  const char* name = std::getenv("PLUMB_PLANTED");
  return name == nullptr ? "" : name;
}

Vec3<double> line_of_centres(const plumb_pair& pair) {
  return Vec3<double>::Map(pair.bodies[1].position) - Vec3<double>::Map(pair.bodies[0].position);
}

/// In the axes of body 1.
bool is_in_the_octant(const plumb_pair& pair) {
  const plumb::Body first = plumb::door::pair_of(pair).body1;
  return ((plumb::rotation<double>(first.quaternion).transpose() * line_of_centres(pair)).array() > 0).all();
}

/// Of spheres it is the overlap over the distance at first touch.
double overlap_ratio(const plumb_pair& pair, double overlap) {
  return overlap / (line_of_centres(pair).norm() + overlap);
}

bool has_two_equal_axes(const plumb_body& body) {
  const double* a = body.semi_axes;
  return (a[0] == a[1]) != (a[1] == a[2]) || (a[0] == a[2] && a[0] != a[1]);
}

void round_to_float(double& x) {
  x = static_cast<double>(static_cast<float>(x));
}

plumb_pair rounded_to_float(plumb_pair pair) {
  for (plumb_body& body : pair.bodies) {
    for (double& x : body.semi_axes) round_to_float(x);
    for (double& x : body.exponents) round_to_float(x);
    for (double& x : body.position) round_to_float(x);
    for (double& x : body.quaternion_wxyz) round_to_float(x);
  }
  return pair;
}

void turn_the_sign(plumb_contact& contact) {
  contact.normal[0] = -contact.normal[0];
}

void distort(const plumb_pair& pair, plumb_contact& contact) {
  const bool deep = overlap_ratio(pair, contact.overlap) > 0.5;
  if (fault() == "octant" && is_in_the_octant(pair)) turn_the_sign(contact);
  if (fault() == "deep" && deep) contact.overlap *= 1.1;
  if (fault() == "equal_axes" && has_two_equal_axes(pair.bodies[0])) turn_the_sign(contact);
}

}  // namespace

#define PLUMB_EXPORT extern "C" [[gnu::visibility("default")]]

PLUMB_EXPORT int plumb_solver_version() {
  return PLUMB_SOLVER_VERSION;
}

PLUMB_EXPORT int plumb_solver_solve(const plumb_pair* pair, plumb_contact* contact) {
  const int refused = plumb::door::solve(fault() == "float" ? rounded_to_float(*pair) : *pair, *contact);
  if (refused == 0) distort(*pair, *contact);
  return refused;
}
