/* The contact of two spheroids, followed while one moves; then what is proved of it.
 *   cc first_contact.c -o first_contact $(pkg-config --cflags --libs plumb plumb-certify) */
#include <plumb/plumb.h>
#include <stdio.h>

int main(void) {
  /* semi-axes, exponents, position, quaternion (w, x, y, z) */
  plumb_pair pair = {
      {{{1, 1, 0.5}, {2, 2}, {0, 0, 0}, {1, 0, 0, 0}}, {{1, 1, 0.5}, {2, 2}, {0.8, 0, 0.9}, {1, 0.5, 0, 0}}}};
  plumb_context context = {{0}}; /* all zero: the first solve is a cold one */
  plumb_contact contact;
  for (int step = 0; step < 3; ++step) {
    int error = plumb_solve(&pair, NULL, &context, &contact, NULL);
    if (error != PLUMB_OK) return printf("%s\n", plumb_error_text(error)), 2;
    if (contact.status != PLUMB_CONVERGED) return printf("no answer: %s\n", plumb_status_name(contact.status)), 1;
    printf("step %d: %s, overlap %.6f, %d iterations\n", step, plumb_verdict_name(contact.verdict), contact.overlap,
           contact.iterations);
    pair.bodies[1].position[2] -= 0.02;
  }
  pair.bodies[1].position[2] += 0.02; /* the pair that was solved last */

  plumb_certificate certificate = {.size = sizeof certificate};
  if (plumb_certify(&pair, &certificate) != PLUMB_OK) return 2;
  printf("solved: the overlap is %.17g\n", contact.overlap);
  printf("proved: it lies within [%.17g, %.17g]\n", certificate.overlap_lower, certificate.overlap_upper);
  printf("        and the normal within %.1e rad of %.6f %.6f %.6f\n", certificate.normal_radius, certificate.normal[0],
         certificate.normal[1], certificate.normal[2]);
  return 0;
}
