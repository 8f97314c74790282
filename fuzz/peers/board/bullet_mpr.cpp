// Bullet's Minkowski portal refinement, a template over its convex objects. Its own arithmetic is in float in either library.
#include <cfloat>
#include <cstdio>

#include "fuzz/peers/board/bullet.hpp"
#include <BulletCollision/NarrowPhaseCollision/btMprPenetration.h>

namespace plumb::board {
namespace {

void claim(plumb_abilities& abilities) {
  claim_bullet(abilities);
  abilities.apart = PLUMB_APART_VERDICT;
  abilities.tolerance = BT_MPR_TOLERANCE;
}

/// What the template asks of a body.
struct Convex {
  const BulletShape& shape;
  btTransform pose;

  [[nodiscard]] btVector3 getObjectCenterInWorld() const { return pose.getOrigin(); }
  [[nodiscard]] const btTransform& getWorldTransform() const { return pose; }
  [[nodiscard]] btVector3 getLocalSupportWithMargin(const btVector3& direction) const {
    return shape.localGetSupportingVertexWithoutMargin(direction);
  }
};

void solve(const adapter::Frame& frame, plumb_contact& contact) {
  const BulletShape shape1(frame.bodies[0]), shape2(frame.bodies[1]);
  const Convex body1{shape1, bullet_pose(frame.bodies[0])}, body2{shape2, bullet_pose(frame.bodies[1])};
  btMprDistanceInfo found;
  if (btComputeMprPenetration(body1, body2, btMprCollisionDescription(), &found) == 0)
    write_bullet(frame, found.m_distance, found.m_normalBtoA, found.m_pointOnA, found.m_pointOnB, contact);
  else
    adapter::Frame::write_separated(contact);
}

}  // namespace
}  // namespace plumb::board

PLUMB_ADAPTER(plumb::board::claim, plumb::board::solve)
