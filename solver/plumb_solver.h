/* The C door: what a foreign solver implements so that plumb can exercise and judge it.
 *
 * Build a shared library that exports plumb_solver_version and plumb_solver_solve; then
 *     plumb solve CASE --solver ./libmine.so
 *     plumb campaign --family all --cases 1000 --seed 1 --solver ./libmine.so --out DIR
 * (without --method the library alone is judged; fuzz/example/ has one of a page). It is judged by what it says that it
 * answers (plumb_solver_abilities); one that does not say is taken for a common-normal solver that answers everything.
 *
 * The library runs in processes of its own, one for each thread of plumb's, and is called from one thread there. What ends
 * the process is the finding `crash`, no answer after --solver-limit seconds of its processor time is `slow`, memory that
 * grows from call to call is a leak. What it prints is not shown; the last lines before a crash are in the finding's detail.
 *
 * Lengths in the caller's unit, world frame, rotation = quaternion / |quaternion| takes body axes to world axes.
 * With PLUMB_CONVERGED fill overlap, normal and points (a NaN there counts as not_finite); contact_point may be NaN.
 * Otherwise leave NaN what you do not have. More than 2000 `evaluations` are the finding `slow`; 0 where you do not count.
 */
#ifndef PLUMB_SOLVER_H
#define PLUMB_SOLVER_H

#ifdef __cplusplus
extern "C" {
#endif

/* Of this header: what plumb_solver_version returns. A library of version 1 is taken as well: it says nothing of its abilities. */
#define PLUMB_SOLVER_VERSION 2

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

/* What a solver answers. plumb does not ask for what is not claimed, and does not count it. */
enum plumb_shapes { PLUMB_SUPERELLIPSOIDS = 0, PLUMB_ELLIPSOIDS = 1, PLUMB_SPHERES = 2 };
/* Of bodies apart: their distance; that they are apart, and nothing else (PLUMB_SEPARATED, with any status); nothing. */
enum plumb_apart { PLUMB_APART_DISTANCE = 0, PLUMB_APART_VERDICT = 1, PLUMB_APART_NONE = 2 };
/* One on each body; one between them, in contact_point; none. */
enum plumb_points { PLUMB_POINTS_TWO = 0, PLUMB_POINTS_MIDWAY = 1, PLUMB_POINTS_NONE = 2 };
/* Which contact it looks for. */
enum plumb_problem {
  PLUMB_COMMON_NORMAL = 0, /* normals opposite, the line through the points along them, lowest overlap */
  PLUMB_DEEPEST_POINTS =
      1,           /* geometric potential: the point of each surface that lies deepest in the other's potential */
  PLUMB_MIDWAY = 2 /* geometric potential: both potentials equal, their gradients opposite */
};

/* Comes filled with the claims of a solver that answers everything; overwrite what is otherwise. */
typedef struct plumb_abilities {
  unsigned size;       /* of the struct as plumb has it: a later one grows at its end */
  int shapes;          /* enum plumb_shapes */
  double exponents[2]; /* of superellipsoids: the least and the greatest that it takes */
  int apart;           /* enum plumb_apart */
  int points;          /* enum plumb_points */
  int normal;          /* 0: it has none */
  int problem;         /* enum plumb_problem */
  double tolerance;    /* its own, relative to the larger body's size; 0: as far as rounding lets it. Shown beside the
                        * results; what is asked for is --accuracy's */
  const char* name;    /* letters, digits and . _ + -; null: that of the file. All strings stay where they are. */
  const char* version; /* null: not said, as the next */
  const char* licence;
} plumb_abilities;

/* Optional: says what the solver answers. */
void plumb_solver_abilities(plumb_abilities* abilities);

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
