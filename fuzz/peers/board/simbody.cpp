// Simbody's tracker of two smooth convex surfaces, the one that its contact subsystem gives to a pair of ellipsoids: portal
// refinement, then Newton on its own six equations. Surfaces without a prior contact, as on a first step.
#include <simmath/internal/Contact.h>
#include <simmath/internal/ContactGeometry.h>
#include <simmath/internal/ContactTracker.h>
#include <simmath/internal/common.h>

#include <string>

#include "solver/plumb_adapter.hpp"

namespace plumb::board {
namespace {

using namespace SimTK;  // its macros and operators are made for that

const char* version() {
  static const std::string text = [] {
    int major = 0, minor = 0, build = 0;
    SimTK_version_simmath(&major, &minor, &build);
    return std::to_string(major) + "." + std::to_string(minor) + (build == 0 ? "" : "." + std::to_string(build));
  }();
  return text.c_str();
}

void claim(plumb_abilities& abilities) {
  abilities.name = "simbody";
  abilities.version = version();
  abilities.licence = "Apache-2.0";
  abilities.shapes = PLUMB_ELLIPSOIDS;
  abilities.apart = PLUMB_APART_VERDICT;
  abilities.tolerance = SignificantReal;  // what its Newton is asked for
}

Vec3 to_simbody(const adapter::Vector& v) {
  return {v[0], v[1], v[2]};
}

adapter::Vector from_simbody(const Vec3& v) {
  return {v[0], v[1], v[2]};
}

Transform simbody_pose(const adapter::Body& body) {
  const adapter::Matrix& m = body.axes;
  const Mat33 axes(m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2]);
  return {Rotation(axes, true), to_simbody(body.centre)};
}

void solve(const adapter::Frame& frame, plumb_contact& contact) {
  const ContactGeometry::Ellipsoid surface1(to_simbody(frame.bodies[0].semi_axes));
  const ContactGeometry::Ellipsoid surface2(to_simbody(frame.bodies[1].semi_axes));
  const Transform pose1 = simbody_pose(frame.bodies[0]), pose2 = simbody_pose(frame.bodies[1]);
  const auto type = ContactGeometry::Ellipsoid::classTypeId();
  const ContactTracker::ConvexImplicitPair tracker(type, type);
  const UntrackedContact before(ContactSurfaceIndex(0), ContactSurfaceIndex(1));
  Contact found;
  contact.status = PLUMB_STALLED;
  if (!tracker.trackContact(before, pose1, surface1, pose2, surface2, 0, found)) return;
  if (found.isEmpty() || !EllipticalPointContact::isInstance(found)) {
    adapter::Frame::write_separated(contact);
    return;
  }
  // The surfaces' points lie half the depth up and down the normal (Contact.h).
  const auto& patch = EllipticalPointContact::getAs(found);
  const Transform in_frame = pose1 * patch.getContactFrame();
  const Vec3& normal = in_frame.z();
  const Vec3 half = normal * (patch.getDepth() / 2);
  frame.write(
      {patch.getDepth(), from_simbody(normal), from_simbody(in_frame.p() + half), from_simbody(in_frame.p() - half)},
      contact);
}

}  // namespace
}  // namespace plumb::board

PLUMB_ADAPTER(plumb::board::claim, plumb::board::solve)
