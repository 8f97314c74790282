// peer_fcl: FCL's signed distance of two ellipsoids, its own GJK and EPA over libccd's data structures.
//
// fcl::distance() would run the copy of these templates in Debian's libfcl, which has its assertions on: one pair that fails
// them ends the whole process. Called below it, they are compiled here and without (CMakeLists.txt).
#include <fcl/config.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include <cmath>
#include <exception>
#include <memory>

#include "fuzz/peers/peer.hpp"

namespace plumb::peers {
namespace {

using Ellipsoid = fcl::detail::GJKInitializer<double, fcl::Ellipsoidd>;

// At the pair's size in [1, 2): a length by which a step must better the distance or the depth. FCL's own default.
constexpr double kTolerance = 1e-6;
constexpr unsigned kIterationLimit = 1000;

bool is_ellipsoid(const Superellipsoid<double>& shape) {
  return shape.n1 == 2 && shape.n2 == 2;
}

struct Delete {
  void operator()(void* object) const { Ellipsoid::deleteGJKObject(object); }
};

/// FCL's object, and how often its support function was called.
struct Counted {
  std::unique_ptr<void, Delete> object;
  int& calls;
};

Counted counted(const PlacedBody<double>& body, int& calls) {
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  pose.linear() = body.rotation;
  pose.translation() = body.centre;
  return {std::unique_ptr<void, Delete>(Ellipsoid::createGJKObject(fcl::Ellipsoidd(body.shape.semi_axes), pose)),
          calls};
}

void find_support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Counted& body = *static_cast<const Counted*>(object);
  ++body.calls;
  Ellipsoid::getSupportFunction()(body.object.get(), direction, point);
}

/// > 0: apart.
struct SignedDistance {
  double length;
  Vec3<double> point1, point2;
};

SignedDistance signed_distance(const PlacedPair<double>& placed, int& calls) {
  Counted body1 = counted(placed.body1, calls), body2 = counted(placed.body2, calls);
  SignedDistance out{};
  fcl::detail::GJKDistanceImpl<double>(&body1, find_support, &body2, find_support, kIterationLimit, kTolerance,
                                       fcl::detail::libccd_extension::ccdGJKSignedDist, &out.length, &out.point1,
                                       &out.point2);
  return out;
}

// FCL gives no normal: it is the line between the points. Where FCL fails it answers the distance -1 and points at the origin.
void write_distance(const SignedDistance& found, const PlacedPair<double>& placed, const Pair& pair,
                    plumb_contact& contact) {
  const double length = (found.point2 - found.point1).norm();
  const bool fits = length > 0 && std::abs(std::abs(found.length) - length) <= kTolerance;
  contact.status = PLUMB_STALLED;
  if (!fits) return;
  const double sign = found.length < 0 ? -1 : 1;
  write({-found.length, (found.point2 - found.point1) * (sign / length), found.point1, found.point2}, placed, pair,
        contact);
}

}  // namespace
}  // namespace plumb::peers

void plumb_solver_abilities(plumb_abilities* abilities) {
  abilities->name = "fcl";
  abilities->version = FCL_VERSION;
  abilities->licence = "BSD-3-Clause";
  abilities->shapes = PLUMB_ELLIPSOIDS;
  abilities->tolerance = plumb::peers::kTolerance;
}

int plumb_solver_solve(const plumb_pair* input, plumb_contact* contact) {
  using namespace plumb;
  const Pair pair = door::pair_of(*input);
  if (!peers::is_ellipsoid(pair.body1.shape) || !peers::is_ellipsoid(pair.body2.shape)) return 1;
  const auto placed = place<double>(pair);
  contact->evaluations = 0;
  try {
    peers::write_distance(peers::signed_distance(placed, contact->evaluations), placed, pair, *contact);
  } catch (const std::exception&) {  // FCL's word for a polytope that does not hold together
    contact->status = PLUMB_STALLED;
  }
  return 0;
}
