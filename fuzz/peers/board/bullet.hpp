// What the adapters of Bullet share: its convex shape with our support points, at margin 0, and its poses. board.cmake builds
// each against Bullet's library of double (BT_USE_DOUBLE_PRECISION) and that of float, and says the name.
#pragma once

#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>

#include "solver/plumb_adapter.hpp"

namespace plumb::board {

inline adapter::Vector from_bullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

inline btVector3 to_bullet(const adapter::Vector& v) {
  return {static_cast<btScalar>(v[0]), static_cast<btScalar>(v[1]), static_cast<btScalar>(v[2])};
}

/// In its body's axes.
class BulletShape final : public btConvexInternalShape {
 public:
  explicit BulletShape(const adapter::Body& body) : body_(body) {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
    m_collisionMargin = 0;
  }
  [[nodiscard]] btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override {
    return to_bullet(body_.support_in_body(from_bullet(direction)).point);
  }
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* points,
                                                         int count) const override {
    for (int i = 0; i < count; ++i) points[i] = localGetSupportingVertexWithoutMargin(directions[i]);
  }
  void calculateLocalInertia(btScalar, btVector3& inertia) const override { inertia.setZero(); }
  [[nodiscard]] const char* getName() const override { return "Superellipsoid"; }

 private:
  const adapter::Body& body_;
};

inline btTransform bullet_pose(const adapter::Body& body) {
  const adapter::Matrix& m = body.axes;
  btMatrix3x3 axes;
  for (int row = 0; row < 3; ++row) axes[row] = to_bullet(m[static_cast<std::size_t>(row)]);
  return btTransform(axes, to_bullet(body.centre));
}

inline void claim_bullet(plumb_abilities& abilities) {
  abilities.name = BOARD_NAME;
  static_assert(BT_BULLET_VERSION == 324, "the version in words");
  abilities.version = "3.24";
  abilities.licence = "Zlib";
}

/// Bullet's normals point from body 2 to body 1.
inline void write_bullet(const adapter::Frame& frame, double distance, const btVector3& normal, const btVector3& point1,
                         const btVector3& point2, plumb_contact& contact) {
  frame.write({-distance, from_bullet(-normal), from_bullet(point1), from_bullet(point2)}, contact);
}

}  // namespace plumb::board
