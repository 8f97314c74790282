// Bullet's pair detector as its convex-convex algorithm sets it up: GJK over the Voronoi simplex, and where the bodies overlap
// the EPA solver.
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "fuzz/peers/board/bullet.hpp"

namespace plumb::board {
namespace {

// REL_ERROR2 of btGjkPairDetector.cpp, of the squared distance.
constexpr double kTolerance = sizeof(btScalar) == sizeof(double) ? 1e-12 : 1e-6;

void claim(plumb_abilities& abilities) {
  claim_bullet(abilities);
  abilities.tolerance = kTolerance;
}

struct Found : btDiscreteCollisionDetectorInterface::Result {
  bool any = false;
  btVector3 normal, point2;
  btScalar distance = 0;

  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3& normal_, const btVector3& point2_, btScalar distance_) override {
    any = true;
    normal = normal_;
    point2 = point2_;
    distance = distance_;
  }
};

void solve(const adapter::Frame& frame, plumb_contact& contact) {
  const BulletShape shape1(frame.bodies[0]), shape2(frame.bodies[1]);
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btGjkPairDetector detector(&shape1, &shape2, &simplex, &depth);
  btDiscreteCollisionDetectorInterface::ClosestPointInput input;
  input.m_transformA = bullet_pose(frame.bodies[0]);
  input.m_transformB = bullet_pose(frame.bodies[1]);
  Found found;
  detector.getClosestPoints(input, found, nullptr);
  contact.iterations = detector.m_curIter;
  contact.status = PLUMB_STALLED;
  if (found.any)
    write_bullet(frame, found.distance, found.normal, found.point2 + found.distance * found.normal, found.point2,
                 contact);
}

}  // namespace
}  // namespace plumb::board

PLUMB_ADAPTER(plumb::board::claim, plumb::board::solve)
