// Simbody and nothing of plumb: two ellipsoids that are balls of radius 0.7, both unturned, 0.42 deep, along many directions.
// Prints what its tracker says; exit 1 where the depth is not 0.42.
//
//     g++ -std=c++17 -I/usr/include/simbody simbody.cpp -lSimTKmath -lSimTKcommon
#include <simmath/internal/Contact.h>
#include <simmath/internal/ContactGeometry.h>
#include <simmath/internal/ContactTracker.h>

#include <cstdio>

using namespace SimTK;

int main() {
  const double radius = 0.7, depth = 0.42;
  const ContactGeometry::Ellipsoid ball{Vec3(radius)};
  const auto type = ContactGeometry::Ellipsoid::classTypeId();
  const ContactTracker::ConvexImplicitPair tracker(type, type);
  const UntrackedContact before(ContactSurfaceIndex(0), ContactSurfaceIndex(1));
  int asked = 0, wrong = 0;
  for (int x = -10; x <= 10; x += 3)
    for (int y = -10; y <= 10; y += 3)
      for (int z = -10; z <= 10; z += 3) {
        const UnitVec3 u(x, y, z);
        Contact found;
        const bool tracked =
            tracker.trackContact(before, Transform(), ball, Transform(Vec3(u * (2 * radius - depth))), ball, 0, found);
        ++asked;
        if (!tracked || found.isEmpty() || !EllipticalPointContact::isInstance(found)) continue;
        const auto& patch = EllipticalPointContact::getAs(found);
        if (std::abs(patch.getDepth() - depth) < 1e-6) continue;
        const UnitVec3 n = patch.getContactFrame().z();
        if (++wrong <= 3)
          std::printf("ball 2 along (%.3f, %.3f, %.3f): depth %.4f (0.42), normal (%.3f, %.3f, %.3f)\n", u[0], u[1],
                      u[2], patch.getDepth(), n[0], n[1], n[2]);
      }
  std::printf("of %d: wrong in %d\n", asked, wrong);
  return wrong > 0;
}
