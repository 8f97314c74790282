/* A solver of one's own behind solver/plumb_solver.h: each body is replaced by the sphere about it. Fast, closed form, and right
 * for spheres alone; the campaign says how wrong it is elsewhere, and shows the simplest pair.
 *
 *     cc -shared -fPIC -I PLUMB bounding_spheres.c -o libspheres.so -lm          (PLUMB: the folder that holds solver/)
 *     plumb campaign --solver ./libspheres.so --family ellipsoid --cases 1000 --seed 1 --out DIR
 */
#include <math.h>

#include "solver/plumb_solver.h"

/* Of an ellipsoid; with exponents above 2 the box about the body. */
static double radius_about(const plumb_body* body) {
  const double* a = body->semi_axes;
  if (body->exponents[0] > 2 || body->exponents[1] > 2) return hypot(hypot(a[0], a[1]), a[2]);
  return fmax(fmax(a[0], a[1]), a[2]);
}

int plumb_solver_version(void) {
  return PLUMB_SOLVER_VERSION;
}

int plumb_solver_solve(const plumb_pair* pair, plumb_contact* contact) {
  const plumb_body *one = &pair->bodies[0], *two = &pair->bodies[1];
  const double r1 = radius_about(one), r2 = radius_about(two);
  double line[3], distance = 0;
  for (int i = 0; i < 3; ++i) {
    line[i] = two->position[i] - one->position[i];
    distance = hypot(distance, line[i]);
  }
  if (distance == 0) return 1; /* refused: no direction is better than another */
  for (int i = 0; i < 3; ++i) {
    contact->normal[i] = line[i] / distance;
    contact->points[0][i] = one->position[i] + r1 * contact->normal[i];
    contact->points[1][i] = two->position[i] - r2 * contact->normal[i];
    contact->contact_point[i] = (contact->points[0][i] + contact->points[1][i]) / 2;
  }
  contact->overlap = r1 + r2 - distance;
  contact->verdict = contact->overlap > 0 ? PLUMB_OVERLAPPING : PLUMB_SEPARATED;
  contact->status = PLUMB_CONVERGED;
  contact->iterations = 0;
  contact->evaluations = 1;
  return 0;
}
