/* plumb's C API: the contact of two superellipsoids, or of any two convex shapes, by their common normal.
 *
 *     plumb_pair pair = {{{{1, 1, 0.5}, {2, 2}, {0, 0, 0}, {1, 0, 0, 0}}, {{1, 1, 0.5}, {2, 2}, {0, 0, 0.9}, {1, 0, 0, 0}}}};
 *     plumb_contact contact;
 *     if (plumb_solve(&pair, NULL, NULL, &contact, NULL) == PLUMB_OK && contact.status == PLUMB_CONVERGED) ..
 *
 * Types     plumb_body, plumb_pair, plumb_contact, enum plumb_status and enum plumb_verdict: plumb_solver.h
 * Shapes    plumb_solve is of superellipsoids; plumb_solve_convex of boxes, cylinders, hulls of points and others, too
 * Frames    world frame throughout; a body's quaternion takes body axes to world axes
 * Units     lengths in the caller's own unit, angles in radians
 * Signs     overlap > 0: the bodies penetrate by that length; < 0: they are -overlap apart; the normal points from body 1 to body 2
 * Validity  a number that was not asked for, or could not be found, is NaN - never a zero
 * Errors    functions return enum plumb_error and write no answer unless it is PLUMB_OK. A pair that cannot be solved is an answer
 *           (contact.status), not an error. Nothing is thrown, printed or kept but a plumb_hull; all functions may be called from any
 *           number of threads
 * Modes     any floating-point mode of the caller (rounding, subnormal numbers as zero, traps) gives the same bits, and is put back
 * Link      cc main.c $(pkg-config --cflags --libs plumb); plumb_certify alone is in another library: pkg-config plumb-certify
 * ABI       structs grow at their end only, those with `size` without a new soname
 */
#ifndef PLUMB_H
#define PLUMB_H

#include <stddef.h>

#include "plumb_solver.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What is exported from the library. */
#if defined(__GNUC__)
#define PLUMB_API __attribute__((visibility("default")))
#else
#define PLUMB_API
#endif

/* Of a union without a name, which C has since 2011. */
#if defined(__GNUC__)
#define PLUMB_ANONYMOUS __extension__
#else
#define PLUMB_ANONYMOUS
#endif

/* What a function returns. */
enum plumb_error {
  PLUMB_OK = 0,
  PLUMB_ERROR_ARGUMENT = 1, /* a pointer that must not be null is, or a number is out of its range */
  PLUMB_ERROR_METHOD = 2,   /* there is no such method, or not for this function */
  PLUMB_ERROR_MEMORY = 3,   /* plumb_certify and plumb_hull_create alone, as the next */
  PLUMB_ERROR_INTERNAL = 4  /* a library under it failed */
};

/* "0.1.0": of the library; a string that is never freed, as all that these functions return. */
PLUMB_API const char* plumb_version(void);
/* What went wrong, in words; "" for PLUMB_OK and for no error. */
PLUMB_API const char* plumb_error_text(int error);
PLUMB_API const char* plumb_status_name(int status);   /* "converged", ..; "" for no status */
PLUMB_API const char* plumb_verdict_name(int verdict); /* "overlapping", ..; "" for no verdict */
/* The name of method `index`, NULL beyond the last; `auto` is among them. */
PLUMB_API const char* plumb_method_name(size_t index);

/* What is wrong with a pair that is answered PLUMB_INVALID_INPUT: "bodies[1].shape.superellipsoid.semi_axes[0]: must be finite and
 * above 0", cut to `size` bytes with the closing zero; "" when it is legal. */
PLUMB_API int plumb_describe_input(const plumb_pair* pair, char* text, size_t size);

/* What is paid for. Nothing at all is a yes or no: the verdict, which may end at the first proof of it. */
enum plumb_want {
  PLUMB_WANT_OVERLAP = 1,
  PLUMB_WANT_NORMAL = 2,
  PLUMB_WANT_POINTS = 4,
  PLUMB_WANT_CURVATURE = 8, /* into plumb_details; by `auto` alone, as derivatives */
  PLUMB_WANT_DERIVATIVES = 16,
  PLUMB_WANT_PATCH = 32,
  PLUMB_WANT_CONTACT = 7 /* overlap, normal and points */
};

/* What proved that a contact's last answer is the lowest, kept beside its context: a proof for the next step mostly needs nothing else. One
 * to a contact, all zero at first; numbers to be kept and copied, not to be read. What was changed in them is taken for nothing. */
typedef struct plumb_witnesses {
  double state[48];
} plumb_witnesses;

/* How a pair is solved; PLUMB_OPTIONS is where to start from. */
typedef struct plumb_options {
  size_t size;         /* sizeof(plumb_options) */
  const char* method;  /* NULL: "auto" */
  unsigned want;       /* of enum plumb_want */
  int iteration_limit; /* of each local solve, > 0 */
  double tolerance; /* residual, relative to the pair's size, at which a method may stop; 0: all that rounding allows */
  double motion[3]; /* of body 2 relative to body 1, any unit and length, for method first_touch; 0, 0, 0: not known */
  double patch_tolerance;     /* relative error at which a patch may stop, > 0 */
  plumb_witnesses* witnesses; /* of this contact, for plumb_solve by `auto` with a context; NULL: none */
} plumb_options;

/* What a null pointer to options stands for, and where to start from: plumb_options options = PLUMB_OPTIONS; */
#define PLUMB_OPTIONS {sizeof(plumb_options), NULL, PLUMB_WANT_CONTACT, 100, 0, {0, 0, 0}, 1e-3, NULL}

/* Where a contact's last solve ended, for the next one to start from when the bodies have moved a little: numbers to be kept and
 * copied, not to be read. All zero: not solved yet. The answer is the same to rounding, cold or warm. */
typedef struct plumb_context {
  double state[16];
} plumb_context;

/* The part that two overlapping bodies have in common: no number of it but the axes jumps, whatever the contact's point and normal do. Of bodies
 * apart volume and area are 0 and the rest NaN; other shapes than superellipsoids have none: NaN. a: the area vector of body 1's surface inside body 2. */
typedef struct plumb_patch {
  double volume;            /* V, length^3 */
  double area;              /* |a| */
  double normal[3];         /* a/|a|, from body 1 to body 2; dV = -a . dx, body 2 shifted by dx. NaN where a is 0 */
  double centre[3];         /* of the volume */
  double area_moment[3];    /* dV = -. dw, body 2 turned by dw about the centre; length^3 */
  double second_moments[3]; /* principal, about the centre, divided by V: length^2, the largest first */
  double axes[3][3]; /* theirs: unit, right-handed, the third from body 1 to body 2; any where two moments are equal */
  double points[4][3]; /* a quarter of the weight each: together the centre and the second moments of the patch */
  double error;        /* estimate of the largest relative error; above patch_tolerance where that was not reached */
} plumb_patch;

/* NaN where it was not wanted; body 1's first. Matrices by rows. */
typedef struct plumb_details {
  size_t size;        /* sizeof(plumb_details), set by the caller */
  const char* method; /* the method that answered; "" for PLUMB_INVALID_INPUT */
  double radii[2][2]; /* of principal curvature at the surface point: length, infinite on a flat, 0 on an edge */
  double directions[2][2][3];    /* of these curvatures: unit, tangent */
  double overlap_by_shift[2][3]; /* d overlap = . dx, the body shifted by dx */
  double
      overlap_by_turn[2]
                     [3]; /* d overlap = . dw, the body turned by the rotation vector dw about its position; length */
  double normal_by_shift
      [2][3]
      [3]; /* d normal = . dx, 1 / length; NaN, as the next, where it has none: on a ring of normals, face on face */
  double normal_by_turn[2][3][3]; /* d normal = . dw */
  plumb_patch patch;
} plumb_details;

/* Bytes of the caller's stack that are enough for plumb_solve and both batches, whatever the pairs and the method: of a release
 * build by g++ for x86-64, which tests hold to them. */
#define PLUMB_STACK_SOLVE (64 * 1024)
/* The same for plumb_solve_convex and plumb_solve_convex_details. */
#define PLUMB_STACK_CONVEX (96 * 1024)
/* The same for plumb_certify. */
#define PLUMB_STACK_CERTIFY (192 * 1024)

/* Solves a pair. options, context and details may be NULL: the options above, a cold start, nothing more than the contact. */
PLUMB_API int plumb_solve(const plumb_pair* pair, const plumb_options* options, plumb_context* context,
                          plumb_contact* contact, plumb_details* details);

/* What a shape is; its parameters are told in their order, lengths but for the exponents. Body axes, the origin at the body's position. */
enum plumb_shape_kind {
  PLUMB_SHAPE_SUPERELLIPSOID = 0,      /* semi-axes a, b, c > 0; exponents n1, n2 > 1: as plumb_body */
  PLUMB_SHAPE_CAPSULE = 1,             /* half-length >= 0, radius > 0: about the segment |z| <= half-length */
  PLUMB_SHAPE_CYLINDER = 2,            /* half-length, radius > 0: along z, flat ends */
  PLUMB_SHAPE_CONE = 3,                /* radius, height > 0: centroid at the origin, apex up z */
  PLUMB_SHAPE_FRUSTUM = 4,             /* radius below, radius above >= 0, one of them > 0; height > 0: as the cone */
  PLUMB_SHAPE_BOX = 5,                 /* half-extents along x, y, z > 0 */
  PLUMB_SHAPE_POLYHEDRON = 6,          /* none, but a hull */
  PLUMB_SHAPE_POLY_SUPERELLIPSOID = 7, /* semi-axes to +x, -x, +y, -y, +z, -z > 0; exponents n1, n2 > 1 */
  PLUMB_SHAPE_HALF_SPACE = 8,          /* none: z <= 0 */
  PLUMB_SHAPE_TABLET = 9,              /* half-length >= 0 along z, radius > 0, cap height > 0, at most the radius */
  PLUMB_SHAPE_FOREIGN = 10             /* none, but functions */
};

/* A convex body of the caller's own, by functions of unit directions n and points x in body axes; the origin belongs to it. A function gives
 * the same for the same n, on any thread, and neither throws nor jumps away. What no convex body could give is PLUMB_INVALID_INPUT, what is no
 * finite number PLUMB_NOT_FINITE: plumb_describe_convex_input says what was seen. */
typedef struct plumb_foreign {
  size_t size;      /* sizeof(plumb_foreign) */
  const void* data; /* handed to each function */
  /* Writes the point farthest along n, known to 2e-13 of bounding_radius. */
  void (*support)(const void* data, const double n[3], double x[3]);
  /* NULL, or: writes the derivative of that point by n, by rows; NaN where there is none. Solves take fewer steps. */
  void (*hessian)(const void* data, const double n[3], double h[9]);
  /* NULL, or: writes the ends of a box that is proved to hold a point that is farthest along this very n, which is of about unit length.
   * plumb_certify_convex believes it. */
  void (*enclose)(const void* data, const double n[3], double lower[3], double upper[3]);
  double bounding_radius;  /* > 0: no point is farther from the origin */
  double inscribed_radius; /* >= 0: every point as near to the origin belongs to the body */
} plumb_foreign;

/* The convex hull of points, which may be a polygon, a segment or a point. Any number of bodies and threads may share one. */
typedef struct plumb_hull plumb_hull;

/* The hull of `count` > 0 finite points, x, y and z of each in turn, decided exactly: once, for it takes longer than a solve. NULL where
 * there is none; then *error says why. error may be NULL. */
PLUMB_API plumb_hull* plumb_hull_create(const double* points, size_t count, int* error);
/* Frees it, where no body that is still solved has it; NULL is nothing to free. */
PLUMB_API void plumb_hull_destroy(plumb_hull* hull);

/* A convex shape: {.kind = PLUMB_SHAPE_BOX, .parameters = {0.5, 0.25, 0.125}}. */
typedef struct plumb_shape {
  int kind; /* enum plumb_shape_kind */
  PLUMB_ANONYMOUS union {
    const plumb_hull* hull;       /* a polyhedron's */
    const plumb_foreign* foreign; /* a foreign shape's, for as long as the call lasts */
  }; /* not read of others */
  double parameters[12]; /* those of the kind; the rest is not read */
} plumb_shape;

/* A shape, swept by a sphere, and where it is. */
typedef struct plumb_convex_body {
  plumb_shape shape;
  double swept_radius; /* >= 0: all points within this of the shape belong to the body */
  double position[3];
  double quaternion_wxyz[4]; /* any non-zero length */
} plumb_convex_body;

/* Bodies 1 and 2: these doubles are the exact input. Two half-spaces are not legal. */
typedef struct plumb_convex_pair {
  plumb_convex_body bodies[2];
} plumb_convex_pair;

/* As plumb_describe_input: "bodies[1].shape.box.half_extents[0]: must be finite and above 0". */
PLUMB_API int plumb_describe_convex_input(const plumb_convex_pair* pair, char* text, size_t size);

/* Solves a pair of any shapes by `auto`. An unknown kind, and a polyhedron without a hull, are PLUMB_INVALID_INPUT. Two
 * superellipsoids, neither of them swept, get the same bits as from plumb_solve. Of options the wants of a contact, the iteration limit
 * and the tolerance. options and context may be NULL. */
PLUMB_API int plumb_solve_convex(const plumb_convex_pair* pair, const plumb_options* options, plumb_context* context,
                                 plumb_contact* contact);

/* The same with curvature and derivatives, where they are wanted and there are some; the patch is NaN. details may be NULL. */
PLUMB_API int plumb_solve_convex_details(const plumb_convex_pair* pair, const plumb_options* options,
                                         plumb_context* context, plumb_contact* contact, plumb_details* details);

/* One body of each of n pairs: entry i of each array is of pair i. */
typedef struct plumb_body_arrays {
  const double* semi_axes[3];
  const double* exponents[2]; /* both NULL: 2 for all, ellipsoids */
  const double* position[3];
  const double* quaternion_wxyz[4];
} plumb_body_arrays;

/* Where the answers of n pairs go, as in plumb_contact; NULL: not wanted, which costs nothing. NaN where the status is not
 * PLUMB_CONVERGED. No array may overlap another, of these or of the input's. */
typedef struct plumb_contact_arrays {
  int* status;
  int* verdict;
  double* overlap;
  double* normal[3];
  double* points[2][3];
  double* contact_point[3];
  int* iterations;
  int* evaluations;
} plumb_contact_arrays;

/* Solves n pairs by `auto`, cold, several side by side in vector registers: each answer depends on its own pair alone. The same
 * bits as plumb_solve's for ellipsoids, the same to rounding for other exponents. Of options the iteration limit and the tolerance.
 * Many threads: a range of the arrays each. */
PLUMB_API int plumb_solve_batch(size_t n, const plumb_body_arrays bodies[2], const plumb_options* options,
                                const plumb_contact_arrays* contacts);

/* The same from where each pair's last solve ended: contexts[i] is pair i's, as plumb_solve's. NULL: cold starts. */
PLUMB_API int plumb_solve_batch_warm(size_t n, const plumb_body_arrays bodies[2], const plumb_options* options,
                                     plumb_context* contexts, const plumb_contact_arrays* contacts);

/* Of what a certificate says. */
enum plumb_claim { PLUMB_OPEN = 0, PLUMB_PROVED = 1, PLUMB_DISPROVED = 2 };

/* What is proved of a pair's contact, by interval arithmetic from its doubles on. Bounds are rounded outwards. */
typedef struct plumb_certificate {
  size_t size;                         /* sizeof(plumb_certificate), set by the caller */
  int verdict;                         /* enum plumb_verdict; PLUMB_UNDECIDED only where 0 lies within the bounds */
  int global;                          /* enum plumb_claim: no direction has a lower overlap than the bounds say */
  int unique;                          /* enum plumb_claim: no other common normal has as low an overlap */
  double overlap_lower, overlap_upper; /* the true overlap lies between them */
  double normal[3];                    /* NaN, as the points, where no common normal is proved */
  double normal_radius;                /* the true normal lies within this of `normal`; rad */
  double points[2][3];
  double points_radius; /* and each true point within this of its own; length */
  double condition_overlap, condition_normal,
      condition_points; /* by how much a relative change of the input can grow */
  const char* open;     /* plumb_certify_convex: what is not proved, in words; NULL of plumb_certify */
} plumb_certificate;

/* Certifies the contact of lowest overlap. Milliseconds: a judge, not a solver. */
PLUMB_API int plumb_certify(const plumb_pair* pair, plumb_certificate* certificate);

/* Certifies the lowest overlap of any shapes: bounds and verdict, and what is open. `normal`: that of an answer, or any guess, which makes
 * the bounds closer; NULL: none. Normal and points are not proved. */
PLUMB_API int plumb_certify_convex(const plumb_convex_pair* pair, const double normal[3],
                                   plumb_certificate* certificate);

#ifdef __cplusplus
}
#endif

#endif
