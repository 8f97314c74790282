/* A rounded brick that lies askew on a pyramid.
 *   cc shapes.c -o shapes_in_c $(pkg-config --cflags --libs plumb) */
#include <plumb/plumb.h>
#include <stdio.h>

int main(void) {
  const double corners[] = {1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0, 0, 0, 1}; /* x, y, z of each */
  int error;
  plumb_hull* hull = plumb_hull_create(corners, 5, &error);
  if (hull == NULL) return printf("%s\n", plumb_error_text(error)), 2;
  const plumb_convex_pair pair = {{{.shape = {.kind = PLUMB_SHAPE_POLYHEDRON, .hull = hull}, .quaternion_wxyz = {1}},
                                   {.shape = {.kind = PLUMB_SHAPE_BOX, .parameters = {0.5, 0.25, 0.125}},
                                    .swept_radius = 0.125,
                                    .position = {0, 0, 1.125},
                                    .quaternion_wxyz = {1, 0.125, 0, 0}}}};
  plumb_contact contact;
  error = plumb_solve_convex(&pair, NULL, NULL, &contact);
  plumb_hull_destroy(hull);
  if (error != PLUMB_OK) return printf("%s\n", plumb_error_text(error)), 2;
  if (contact.status != PLUMB_CONVERGED) return printf("no answer: %s\n", plumb_status_name(contact.status)), 1;
  printf("overlap %.6f\n", contact.overlap);
  printf("normal %.6f %.6f %.6f\n", contact.normal[0], contact.normal[1], contact.normal[2]);
  return 0;
}
