/* A die on a die, its tilt from next to nothing to minus that: the point of contact jumps, the patch does not. */
#include <math.h>
#include <plumb/plumb.h>
#include <stdio.h>

int main(void) {
  plumb_pair dice = {{{{1, 1, 1}, {8, 8}, {0, 0, 0}, {1, 0, 0, 0}}, {{1, 1, 1}, {8, 8}, {0, 0, 1.99}, {1, 0, 0, 0}}}};
  plumb_options options = PLUMB_OPTIONS;
  options.want |= PLUMB_WANT_PATCH;
  plumb_contact contact[2];
  plumb_details details[2] = {{.size = sizeof details[0]}, {.size = sizeof details[1]}};
  for (int i = 0; i < 2; ++i) {
    dice.bodies[1].quaternion_wxyz[2] = i == 0 ? -5e-13 : 5e-13; /* half the tilt, about y */
    int error = plumb_solve(&dice, &options, NULL, &contact[i], &details[i]);
    if (error != PLUMB_OK) return printf("%s\n", plumb_error_text(error)), 2;
    if (contact[i].status != PLUMB_CONVERGED) return printf("no answer: %s\n", plumb_status_name(contact[i].status)), 1;
    if (!(details[i].patch.error < 0.01)) return printf("not as exact as it is wanted here\n"), 1;
  }
  printf("along x the point moves by %.3f, the patch by %.3f\n",
         contact[1].contact_point[0] - contact[0].contact_point[0],
         fabs(details[1].patch.centre[0] - details[0].patch.centre[0]));
  printf("volume %.3f, area %.2f\n", details[1].patch.volume, details[1].patch.area);
  return 0;
}
