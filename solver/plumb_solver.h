/* The C door: what a foreign solver implements so that plumb can exercise and judge it.
 *
 * Build a shared library that exports plumb_solver_version and plumb_solver_solve; then
 *     plumb solve CASE --solver ./libmine.so
 *     plumb campaign --family all --cases 1000 --seed 1 --solver ./libmine.so --out DIR
 * (without --method the library alone is judged; fuzz/example/ has one of a page). It is judged as a common-normal solver;
 * the answers of one that solves another problem go through `plumb check` with "method": "geometric_potential_midway" or
 * "geometric_potential".
 *
 * The library runs in processes of its own, one for each thread of plumb's, and is called from one thread there. What ends
 * the process is the finding `crash`, no answer after --solver-limit seconds of its processor time is `slow`, memory that
 * grows from call to call is a leak. What it prints is not shown; the last lines before a crash are in the finding's detail.
 *
 * Lengths in the caller's unit, world frame, rotation = quaternion / |quaternion| takes body axes to world axes.
 * With PLUMB_CONVERGED fill overlap, normal and points (a NaN there counts as not_finite); contact_point may be NaN.
 * Otherwise leave NaN what you do not have.
 */
#ifndef PLUMB_SOLVER_H
#define PLUMB_SOLVER_H

#ifdef __cplusplus
extern "C" {
#endif

/* Of this header: what plumb_solver_version returns. */
#define PLUMB_SOLVER_VERSION 1

/* (|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1 = 1 */
typedef struct plumb_body {
  double semi_axes[3]; /* a, b, c > 0 */
  double exponents[2]; /* n1, n2 > 1 */
  double position[3];
  double quaternion_wxyz[4]; /* any non-zero length */
} plumb_body;

/* Bodies 1 and 2: these doubles are the exact input. */
typedef struct plumb_pair {
  plumb_body bodies[2];
} plumb_pair;

/* Which inequality ended a solve; only PLUMB_CONVERGED vouches for an answer. */
enum plumb_status {
  PLUMB_CONVERGED = 0,
  PLUMB_ITERATION_LIMIT = 1,
  PLUMB_STALLED = 2,
  PLUMB_SINGULAR = 3,
  PLUMB_NOT_FINITE = 4,
  PLUMB_INVALID_INPUT = 5
};

/* Undecided: the overlap is 0 to within rounding, or there is no answer. */
enum plumb_verdict { PLUMB_UNDECIDED = 0, PLUMB_OVERLAPPING = 1, PLUMB_SEPARATED = 2 };

/* An answer; world frame, the caller's unit, NaN where there is none. */
typedef struct plumb_contact {
  int status;          /* enum plumb_status */
  int verdict;         /* enum plumb_verdict */
  double overlap;      /* > 0: penetration depth; < 0: minus the distance */
  double normal[3];    /* unit, from body 1 to body 2 */
  double points[2][3]; /* on body 1, on body 2 */
  double contact_point[3];
  int iterations;
  int evaluations;
} plumb_contact;

/* Returns PLUMB_SOLVER_VERSION of the header that the library was built with. */
int plumb_solver_version(void);

/* Returns 0, or non-zero when it refuses the pair (legal; it counts as nonconverged). */
int plumb_solver_solve(const plumb_pair* pair, plumb_contact* contact);

/* Optional: the same for a pair that was a little elsewhere a step before, where its contact was `last` (`plumb path`,
 * `plumb solve --warm`). Without it every call is a cold one. */
int plumb_solver_solve_warm(const plumb_pair* pair, const plumb_contact* last, plumb_contact* contact);

#ifdef __cplusplus
}
#endif

#endif
