// bounding_spheres.c once more, in C++ over solver/plumb_adapter.hpp: each body is replaced by the sphere about it. The helper
// reads the pair, refuses what is no pair, and writes the answer; what is left is the solver.
//
//     c++ -std=c++17 -shared -fPIC -I PLUMB bounding_spheres.cpp -o libspheres.so      (PLUMB: the folder that holds solver/)
//     plumb campaign --solver ./libspheres.so --family ellipsoid --cases 1000 --seed 1 --out DIR
#include "solver/plumb_adapter.hpp"

namespace {

using namespace plumb::adapter;

void claim(plumb_abilities& abilities) {
  abilities.name = "bounding-spheres";
  abilities.licence = "BSD-3-Clause";
}

// Of an ellipsoid; with exponents above 2 the box about the body.
double radius_about(const Body& body) {
  const Vector& a = body.semi_axes;
  return body.n1 > 2 || body.n2 > 2 ? std::sqrt(dot(a, a)) : std::max({a[0], a[1], a[2]});
}

void solve(const Frame& frame, plumb_contact& contact) {
  const Vector& line = frame.bodies[1].centre;  // body 1 is at the origin
  const Vector normal = normalised(line);       // of coincident centres NaN, and so the answer `not_finite`
  const double radius1 = radius_about(frame.bodies[0]), radius2 = radius_about(frame.bodies[1]);
  frame.write({radius1 + radius2 - dot(line, normal), normal, radius1 * normal, line - radius2 * normal}, contact);
}

}  // namespace

PLUMB_ADAPTER(claim, solve)
