// Bullet and nothing of plumb: two balls of radius 0.7 with their exact support points, 0.42 deep, the first turned (which
// changes nothing of a ball). Prints what the pair detector says; exit 1 where normal or point is off by a hundredth.
//
//     g++ -DBT_USE_DOUBLE_PRECISION -I/usr/include/bullet bullet.cpp -lBulletCollision-float64 -lLinearMath-float64
#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <cstdio>

namespace {

struct Ball final : btConvexInternalShape {
  explicit Ball(btScalar radius_) : radius(radius_) {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
    m_collisionMargin = 0;
  }
  [[nodiscard]] btVector3 localGetSupportingVertexWithoutMargin(const btVector3& u) const override {
    return u.length2() > 0 ? btVector3(radius / u.length() * u) : btVector3(0, 0, 0);
  }
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* u, btVector3* x, int count) const override {
    for (int i = 0; i < count; ++i) x[i] = localGetSupportingVertexWithoutMargin(u[i]);
  }
  void calculateLocalInertia(btScalar, btVector3& inertia) const override { inertia.setZero(); }
  [[nodiscard]] const char* getName() const override { return "Ball"; }

  btScalar radius;
};

constexpr btScalar kRadius = 0.7, kDepth = 0.42;

/// Prints it, too.
bool is_wrong(const btVector3& u, btScalar distance, const btVector3& normal_to_1, const btVector3& point2) {
  const btVector3 expected = u * (kRadius - kDepth);
  const bool wrong = (normal_to_1 + u).length() > 0.01 || (point2 - expected).length() > 0.01;
  if (wrong)
    std::printf("ball 2 along (%.3f, %.3f, %.3f): depth %.4f (0.42), normal (%.3f, %.3f, %.3f) from 1 to 2, point on 2 "
                "(%.3f, %.3f, %.3f) for (%.3f, %.3f, %.3f)\n",
                u.x(), u.y(), u.z(), -distance, -normal_to_1.x(), -normal_to_1.y(), -normal_to_1.z(), point2.x(),
                point2.y(), point2.z(), expected.x(), expected.y(), expected.z());
  return wrong;
}

bool ask_detector(const Ball& ball, const btTransform& pose1, const btTransform& pose2, const btVector3& u) {
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btGjkPairDetector detector(&ball, &ball, &simplex, &depth);
  btDiscreteCollisionDetectorInterface::ClosestPointInput input;
  input.m_transformA = pose1;
  input.m_transformB = pose2;
  struct Result : btStorageResult {
    void setShapeIdentifiersA(int, int) override {}
    void setShapeIdentifiersB(int, int) override {}
  } found;
  detector.getClosestPoints(input, found, nullptr);
  return is_wrong(u, found.m_distance, found.m_normalOnSurfaceB, found.m_closestPointInB);
}

}  // namespace

int main() {
  const Ball ball(kRadius);
  int wrong = 0, asked = 0;
  for (int x = -10; x <= 10; x += 3)
    for (int y = -10; y <= 10; y += 3)
      for (int z = -10; z <= 10; z += 3) {
        const btVector3 u = btVector3(btScalar(x), btScalar(y), btScalar(z)).normalized();
        const btTransform pose1(btQuaternion(btScalar(0.5), btScalar(0.5), btScalar(0.5), btScalar(0.5)));
        const btTransform pose2(btQuaternion::getIdentity(), u * (2 * kRadius - kDepth));
        ++asked;
        wrong += ask_detector(ball, pose1, pose2, u) ? 1 : 0;
      }
  std::printf("of %d: wrong in %d\n", asked, wrong);
  return wrong > 0 ? 1 : 0;
}
