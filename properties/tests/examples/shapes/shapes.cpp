// A rounded brick that lies askew on a pyramid.
#include <cstdio>
#include <plumb/method/convex.hpp>
#include <plumb/shape/hull.hpp>
#include <vector>

int main() {
  const std::vector<plumb::Vec3<double>> corners{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
  plumb::ConvexPair pair;
  pair.body1.shape = plumb::make_polyhedron(corners);
  pair.body2.shape = plumb::Box{{0.5, 0.25, 0.125}};
  pair.body2.swept_radius = 0.125;
  pair.body2.position = {0, 0, 1.125};
  pair.body2.quaternion = {1, 0.125, 0, 0};

  const plumb::Contact<double> contact = plumb::solve_convex(pair, {}, nullptr);
  if (contact.status != plumb::Status::converged) return 1;
  std::printf("overlap %.6f\n", contact.overlap);
  std::printf("normal %.6f %.6f %.6f\n", contact.normal[0], contact.normal[1], contact.normal[2]);
}
