#include "fuzz/peers/libccd.hpp"

#include <limits>

#include "fuzz/peers/peer.hpp"
#include "solver/shape/superellipsoid.hpp"

namespace plumb::peers {
namespace {

// At the pair's size in [1, 2). EPA ends when the depth times its gain, or the squared distance of the next point from the
// face, is below it: the depth is good to about 1e-6, the normal to the root of that over the curvature.
constexpr double kTolerance = 1e-12;
// An iteration asks each body once. EPA has no limit of its own: one pair of 50 000 superquadrics grew its polytope for ever.
constexpr int kIterationLimit = 1000;

struct Convex {
  const PlacedBody<double>& body;
  int& calls;  // of both bodies
};

ccd_vec3_t to_ccd(const Vec3<double>& v) {
  return {{v[0], v[1], v[2]}};
}

Vec3<double> from_ccd(const ccd_vec3_t& v) {
  return {v.v[0], v.v[1], v.v[2]};
}

// Past the limit every support point is the origin: the Minkowski difference then seems to end where the search stands, and
// GJK, EPA and MPR return what they have.
void find_support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Convex& convex = *static_cast<const Convex*>(object);
  *point = to_ccd(Vec3<double>::Zero());
  if (++convex.calls > 2 * kIterationLimit) return;
  const Vec3<double> u = convex.body.to_body_direction(from_ccd(*direction));
  if (!(u.squaredNorm() > 0)) return;
  *point = to_ccd(convex.body.to_pair(support_point<double>(convex.body.shape, u).gradient));
}

void find_centre(const void* object, ccd_vec3_t* centre) {
  *centre = to_ccd(static_cast<const Convex*>(object)->body.centre);
}

ccd_t settings() {
  ccd_t out;
  CCD_INIT(&out);
  out.support1 = out.support2 = find_support;
  out.center1 = out.center2 = find_centre;
  out.max_iterations = kIterationLimit;
  out.epa_tolerance = out.mpr_tolerance = kTolerance;
  return out;
}

// libccd has no distance: of bodies apart it knows that they are, and no overlap, normal or points.
void write_missing(int code, plumb_contact& contact) {
  contact.status = PLUMB_STALLED;
  if (code == -1) contact.verdict = PLUMB_SEPARATED;
}

}  // namespace

void claim_libccd(const char* name, plumb_abilities& abilities) {
  abilities.name = name;
  abilities.version = PLUMB_LIBCCD_VERSION;
  abilities.licence = "BSD-3-Clause";
  abilities.apart = PLUMB_APART_VERDICT;
  abilities.points = PLUMB_POINTS_MIDWAY;
  abilities.tolerance = kTolerance;
}

int solve_with_libccd(const plumb_pair& input, Penetration penetration, plumb_contact& contact) {
  const Pair pair = door::pair_of(input);
  const auto placed = place<double>(pair);
  const Convex body1{placed.body1, contact.evaluations}, body2{placed.body2, contact.evaluations};
  contact.evaluations = 0;
  double depth = std::numeric_limits<double>::quiet_NaN();
  ccd_vec3_t direction = to_ccd(not_valid<double>()), position = direction;
  const ccd_t ccd = settings();
  const int code = penetration(&body1, &body2, &ccd, &depth, &direction, &position);
  const Vec3<double> n = from_ccd(direction), middle = from_ccd(position);
  if (code == 0)
    write({depth, n, middle + n * (depth / 2), middle - n * (depth / 2)}, placed, pair, contact);
  else
    write_missing(code, contact);
  if (contact.evaluations > 2 * kIterationLimit) contact.status = PLUMB_ITERATION_LIMIT;
  return 0;
}

}  // namespace plumb::peers
