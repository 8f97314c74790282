// A body against a solid cylinder, cone or box: two convex bodies, which have one contact (method/convex.hpp).
#include "solver/method/convex.hpp"
#include "solver/scene/wall/touches.hpp"

namespace plumb::scene {
namespace {

/// `centre`: of the shape, from the wall's point; half its box about that.
void touch_solid(const Shape& shape, const Vec3<double>& centre, const Vec3<double>& half, const Vec3<double>& middle,
                 const BodyAtWall& body, Touches& out) {
  if (((body.centre - middle).cwiseAbs() - half - body.half_extent()).maxCoeff() >= 0) return;
  const Eigen::Quaterniond& q = body.orientation;
  ConvexPair pair;
  pair.body1.shape = body.shape;
  pair.body1.quaternion = {q.w(), q.x(), q.y(), q.z()};
  pair.body2.shape = shape;
  pair.body2.position = centre - body.centre;
  const Contact<double> contact = solve_convex(pair, Want{}, nullptr);
  if (contact.status != Status::converged) return out.fail();
  if (contact.overlap > -body.range) out.add({contact.overlap, contact.normal, contact.point1});
}

}  // namespace

void touch_outside(const CylinderWall& wall, const BodyAtWall& body, Touches& out) {
  const Vec3<double> none = Vec3<double>::Zero(), half(wall.radius, wall.radius, wall.half_length);
  touch_solid(plumb::Cylinder{wall.half_length, wall.radius}, none, half, none, body, out);
}

void touch_outside(const ConeWall& wall, const BodyAtWall& body, Touches& out) {
  const auto [r, t] = wall.radii;
  const double centroid = wall.height / 4 * ((r * r + 2 * r * t + 3 * t * t) / (r * r + r * t + t * t));
  const double widest = std::max(r, t);
  touch_solid(plumb::Frustum{wall.radii, wall.height}, Vec3<double>(0, 0, centroid),
              Vec3<double>(widest, widest, wall.height / 2), Vec3<double>(0, 0, wall.height / 2), body, out);
}

void touch_outside(const BoxWall& wall, const BodyAtWall& body, Touches& out) {
  const Vec3<double> none = Vec3<double>::Zero();
  touch_solid(plumb::Box{wall.half_extents}, none, wall.half_extents, none, body, out);
}

}  // namespace plumb::scene
