/* A shape of one's own, the sum of two ellipsoids: solved, judged by what is proved, and fuzzed.
 *   cc foreign.c -o foreign $(pkg-config --cflags --libs plumb plumb-certify) -lm */
#include <float.h>
#include <math.h>
#include <plumb/plumb.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct {
  double axes[2][3];
} two_ellipsoids;

/* x = A^2 n / |A n| + B^2 n / |B n|, and its derivative where `h` is not NULL. */
static void sum(const two_ellipsoids* both, const double n[3], double x[3], double h[9]) {
  for (int k = 0; k < 2; ++k) {
    const double* a = both->axes[k];
    const double q = sqrt(a[0] * a[0] * n[0] * n[0] + a[1] * a[1] * n[1] * n[1] + a[2] * a[2] * n[2] * n[2]);
    const double e[3] = {a[0] * a[0] * n[0] / q, a[1] * a[1] * n[1] / q, a[2] * a[2] * n[2] / q};
    for (int i = 0; i < 3; ++i) x[i] = e[i] + (k == 0 ? 0 : x[i]);
    for (int i = 0; h != NULL && i < 9; ++i)
      h[i] = ((i % 4 == 0 ? a[i / 3] * a[i / 3] : 0) - e[i / 3] * e[i % 3]) / q + (k == 0 ? 0 : h[i]);
  }
}
static void support(const void* data, const double n[3], double x[3]) {
  sum(data, n, x, NULL);
}
static void hessian(const void* data, const double n[3], double h[9]) {
  sum(data, n, (double[3]){0}, h);
}
/* Two terms of one sign, each with less than 8 roundings. */
static void enclose(const void* data, const double n[3], double lower[3], double upper[3]) {
  sum(data, n, upper, NULL);
  for (int i = 0; i < 3; ++i) {
    const double off = 8 * DBL_EPSILON * fabs(upper[i]) + DBL_MIN;
    lower[i] = upper[i] - off;
    upper[i] += off;
  }
}
/* Whether an answer is within what is proved. */
static int is_right(const plumb_convex_pair* pair, plumb_contact* contact) {
  plumb_certificate proved = {.size = sizeof proved};
  if (plumb_solve_convex(pair, NULL, NULL, contact) != PLUMB_OK || contact->status != PLUMB_CONVERGED) return 0;
  if (plumb_certify_convex(pair, contact->normal, &proved) != PLUMB_OK || proved.global != PLUMB_PROVED) return 0;
  return contact->overlap > proved.overlap_lower - 1e-12 && contact->overlap < proved.overlap_upper + 1e-12;
}
static double drawn(void) {
  return 2.0 * rand() / RAND_MAX - 1;
}

int main(void) {
  const two_ellipsoids both = {{{1, 0.25, 0.25}, {0.25, 0.5, 0.125}}};
  const plumb_foreign shape = {sizeof shape, &both, support, hessian, enclose, 1.5, 0.375};
  const plumb_convex_body own = {.shape = {.kind = PLUMB_SHAPE_FOREIGN, .foreign = &shape}, .quaternion_wxyz = {1}};
  const plumb_convex_body box = {.shape = {.kind = PLUMB_SHAPE_BOX, .parameters = {0.5, 0.5, 0.75}}};
  int right = 0;
  for (int i = 0; i < 200; ++i) {
    plumb_contact contact;
    plumb_convex_pair pair = {{own, i % 2 == 0 ? own : box}};
    for (int k = 0; k < 3; ++k) pair.bodies[1].position[k] = i == 0 ? 0.75 * k : 1.5 * drawn();
    for (int k = 0; k < 4; ++k) pair.bodies[1].quaternion_wxyz[k] = i == 0 ? k == 3 : drawn();
    right += is_right(&pair, &contact);
    if (i == 0)
      printf("overlap %.6f, p1 %.6f %.6f %.6f\n", contact.overlap, contact.points[0][0], contact.points[0][1],
             contact.points[0][2]);
  }
  return printf("%d of 200 pairs are right\n", right), 0;
}
