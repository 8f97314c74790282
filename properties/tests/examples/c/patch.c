/* A die on a die, tilted by next to nothing: the point of contact jumps, the patch does not. */
#include <plumb/plumb.h>
#include <stdio.h>

int main(void) {
  plumb_pair dice = {
      {{{1, 1, 1}, {8, 8}, {0, 0, 0}, {1, 0, 0, 0}}, {{1, 1, 1}, {8, 8}, {0, 0, 1.99}, {1, 0, 0, 0}}}};
  plumb_options options = PLUMB_OPTIONS;
  options.want |= PLUMB_WANT_PATCH;
  for (int side = -1; side <= 1; side += 2) {
    plumb_contact contact;
    plumb_details details = {.size = sizeof details};
    dice.bodies[1].quaternion[2] = side * 0.5e-12; /* half the tilt, about y */
    int error = plumb_solve(&dice, &options, NULL, &contact, &details);
    if (error != PLUMB_OK) return printf("%s\n", plumb_error_text(error)), 2;
    if (contact.status != PLUMB_CONVERGED) return printf("no answer: %s\n", plumb_status_name(contact.status)), 1;
    if (!(details.patch.error < 0.01)) return printf("not as exact as it is wanted here\n"), 1;
    printf("point at x = %.2g, patch at x = %.2g\n", contact.contact_point[0], details.patch.centre[0]);
    printf("  volume %.2g, area %.2g\n", details.patch.volume, details.patch.area);
  }
  return 0;
}
