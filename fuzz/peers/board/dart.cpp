// DART's collision of two ellipsoid shapes by its FCL detector in the mode PRIMITIVE, which gives one contact. Its default
// takes meshes for ellipsoids, and gives contacts of their triangles, of which none is the pair's.
#include <dart/collision/CollisionObject.hpp>
#include <dart/collision/fcl/FCLCollisionDetector.hpp>
#include <dart/config.hpp>
#include <dart/dynamics/EllipsoidShape.hpp>
#include <dart/dynamics/SimpleFrame.hpp>

#include <memory>

#include "solver/plumb_adapter.hpp"

namespace plumb::board {
namespace {

void claim(plumb_abilities& abilities) {
  abilities.name = "dart-fcl";
  abilities.version = DART_VERSION;
  abilities.licence = "BSD-2-Clause";
  abilities.shapes = PLUMB_ELLIPSOIDS;
  abilities.apart = PLUMB_APART_VERDICT;
  abilities.points = PLUMB_POINTS_MIDWAY;
  abilities.tolerance = 1e-6;  // FCL's own, which DART leaves as it is
}

std::shared_ptr<dart::dynamics::SimpleFrame> placed(const adapter::Body& body) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(body.axes[0].data());
  pose.translation() = Eigen::Map<const Eigen::Vector3d>(body.centre.data());
  auto out = std::make_shared<dart::dynamics::SimpleFrame>(dart::dynamics::Frame::World(), "body", pose);
  const Eigen::Vector3d diameters = 2 * Eigen::Map<const Eigen::Vector3d>(body.semi_axes.data());
  out->setShape(std::make_shared<dart::dynamics::EllipsoidShape>(diameters));
  return out;
}

std::shared_ptr<dart::collision::FCLCollisionDetector> make_detector() {
  using dart::collision::FCLCollisionDetector;
  auto out = FCLCollisionDetector::create();
  out->setPrimitiveShapeType(FCLCollisionDetector::PRIMITIVE);
  out->setContactPointComputationMethod(FCLCollisionDetector::DART);
  return out;
}

void solve(const adapter::Frame& frame, plumb_contact& contact) {
  static const auto detector = make_detector();
  const auto body1 = placed(frame.bodies[0]), body2 = placed(frame.bodies[1]);
  const auto group1 = detector->createCollisionGroup(body1.get()), group2 = detector->createCollisionGroup(body2.get());
  dart::collision::CollisionResult result;
  if (!group1->collide(group2.get(), dart::collision::CollisionOption(), &result)) {
    adapter::Frame::write_separated(contact);
    return;
  }
  contact.status = PLUMB_STALLED;
  if (result.getNumContacts() == 0) return;
  // From body 2 to body 1.
  const dart::collision::Contact& found = result.getContact(0);
  const double sign = found.collisionObject1->getShapeFrame() == body1.get() ? -1 : 1;
  const Eigen::Vector3d n = sign * found.normal;
  frame.write_midway(found.penetrationDepth, {n[0], n[1], n[2]}, {found.point[0], found.point[1], found.point[2]},
                     contact);
}

}  // namespace
}  // namespace plumb::board

PLUMB_ADAPTER(plumb::board::claim, plumb::board::solve)
