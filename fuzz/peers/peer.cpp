#include "fuzz/peers/peer.hpp"

#include <algorithm>
#include <cmath>

int plumb_solver_version(void) {
  return PLUMB_SOLVER_VERSION;
}

namespace plumb::peers {
namespace {

Vec3<double> vector_of(const double (&v)[3]) {
  return {v[0], v[1], v[2]};
}

Body body_of(const plumb_body& body) {
  const double(&q)[4] = body.quaternion_wxyz;
  return {{vector_of(body.semi_axes), body.exponents[0], body.exponents[1]},
          vector_of(body.position),
          {q[0], q[1], q[2], q[3]}};
}

void copy(const Vec3<double>& v, double (&out)[3]) {
  std::copy_n(v.data(), 3, out);
}

bool is_finite(const Found& found) {
  return std::isfinite(found.overlap) && found.normal.allFinite() && found.point1.allFinite() &&
         found.point2.allFinite();
}

}  // namespace

Pair pair_of(const plumb_pair& pair) {
  return {body_of(pair.bodies[0]), body_of(pair.bodies[1])};
}

void write(const Found& found, const PlacedPair<double>& placed, const Pair& pair, plumb_contact& contact) {
  contact.status = is_finite(found) ? PLUMB_CONVERGED : PLUMB_NOT_FINITE;
  if (contact.status != PLUMB_CONVERGED) return;
  contact.verdict = found.overlap > 0 ? PLUMB_OVERLAPPING : PLUMB_SEPARATED;
  contact.overlap = placed.to_world_length(found.overlap);
  copy(found.normal, contact.normal);
  copy(placed.to_world_point(found.point1, pair), contact.points[0]);
  copy(placed.to_world_point(found.point2, pair), contact.points[1]);
  copy(placed.to_world_point((found.point1 + found.point2) / 2, pair), contact.contact_point);
}

}  // namespace plumb::peers
