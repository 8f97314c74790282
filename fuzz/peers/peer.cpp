#include "fuzz/peers/peer.hpp"

#include <cmath>

int plumb_solver_version(void) {
  return PLUMB_SOLVER_VERSION;
}

namespace plumb::peers {
namespace {

bool is_finite(const Found& found) {
  return std::isfinite(found.overlap) && found.normal.allFinite() && found.point1.allFinite() &&
         found.point2.allFinite();
}

}  // namespace

void write(const Found& found, const PlacedPair<double>& placed, const Pair& pair, plumb_contact& contact) {
  contact.status = is_finite(found) ? PLUMB_CONVERGED : PLUMB_NOT_FINITE;
  if (contact.status != PLUMB_CONVERGED) return;
  contact.verdict = found.overlap > 0 ? PLUMB_OVERLAPPING : PLUMB_SEPARATED;
  contact.overlap = placed.to_world_length(found.overlap);
  Vec3<double>::Map(contact.normal) = found.normal;
  Vec3<double>::Map(contact.points[0]) = placed.to_world_point(found.point1, pair);
  Vec3<double>::Map(contact.points[1]) = placed.to_world_point(found.point2, pair);
  Vec3<double>::Map(contact.contact_point) = placed.to_world_point((found.point1 + found.point2) / 2, pair);
}

}  // namespace plumb::peers
