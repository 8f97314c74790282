// Bullet's GJK-EPA solver alone, from the line of centres, the first guess of its own wrapper: penetration, and where there is
// none the distance.
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>

#include "fuzz/peers/board/bullet.hpp"

namespace plumb::board {
namespace {

// EPA_ACCURACY of btGjkEpa2.cpp, a length.
constexpr double kTolerance = sizeof(btScalar) == sizeof(double) ? 1e-12 : 1e-4;

void claim(plumb_abilities& abilities) {
  claim_bullet(abilities);
  abilities.tolerance = kTolerance;
}

void solve(const adapter::Frame& frame, plumb_contact& contact) {
  const BulletShape shape1(frame.bodies[0]), shape2(frame.bodies[1]);
  const btTransform pose1 = bullet_pose(frame.bodies[0]), pose2 = bullet_pose(frame.bodies[1]);
  // It works in body 1's axes: its first guess and its normal are there, its points are not.
  const btVector3 line = (pose2.getOrigin() - pose1.getOrigin()).safeNormalize();
  const btVector3 guess = pose1.getBasis().transpose() * line;
  btGjkEpaSolver2::sResults found;
  contact.status = PLUMB_STALLED;
  if (btGjkEpaSolver2::Penetration(&shape1, pose1, &shape2, pose2, guess, found) ||
      btGjkEpaSolver2::Distance(&shape1, pose1, &shape2, pose2, guess, found)) {
    const btVector3 normal = pose1.getBasis() * found.normal;
    write_bullet(frame, found.distance, normal, found.witnesses[0], found.witnesses[1], contact);
  }
}

}  // namespace
}  // namespace plumb::board

PLUMB_ADAPTER(plumb::board::claim, plumb::board::solve)
