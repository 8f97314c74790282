/* A foreign solver that can do unit spheres and refuses everything else. */
#include <math.h>

#include "solver/plumb_solver.h"

static int is_unit_sphere(const plumb_body* body) {
  for (int i = 0; i < 3; ++i)
    if (body->semi_axes[i] != 1) return 0;
  return body->exponents[0] == 2 && body->exponents[1] == 2;
}

int plumb_solver_version(void) {
  return PLUMB_SOLVER_VERSION;
}

int plumb_solver_solve(const plumb_pair* pair, plumb_contact* contact) {
  const plumb_body* b = pair->bodies;
  if (!is_unit_sphere(&b[0]) || !is_unit_sphere(&b[1])) return 1;
  double distance = 0;
  for (int i = 0; i < 3; ++i) distance = hypot(distance, b[1].position[i] - b[0].position[i]);
  for (int i = 0; i < 3; ++i) {
    contact->normal[i] = (b[1].position[i] - b[0].position[i]) / distance;
    contact->points[0][i] = b[0].position[i] + contact->normal[i];
    contact->points[1][i] = b[1].position[i] - contact->normal[i];
    contact->contact_point[i] = (contact->points[0][i] + contact->points[1][i]) / 2;
  }
  contact->overlap = 2 - distance;
  contact->status = PLUMB_CONVERGED;
  contact->verdict = contact->overlap > 0 ? PLUMB_OVERLAPPING : PLUMB_SEPARATED;
  contact->iterations = 1;
  contact->evaluations = 1;
  return 0;
}
