/* The flight recorder: a foreign contact loop calls it with shapes, poses and its OWN answer; it judges the answer in tens of
 * nanoseconds and keeps what is wrong as case files that `plumb replay FOLDER` reads. Nothing but the C library, POSIX and
 * libm; C99 or C++ with the __atomic builtins of gcc and clang. In one source file:
 *
 *     #define PLUMB_RECORDER_IMPLEMENTATION
 *     #include <plumb/plumb_recorder.h>
 *
 * and in the loop
 *
 *     plumb_recorder* recorder = plumb_recorder_open("wrong-contacts", NULL);
 *     ...
 *     plumb_recorder_begin(recorder, &body1, &body2);            optional: a crash or a hang of the next line leaves a case
 *     touching = my_contact(...);
 *     plumb_record(recorder, &body1, &body2, &answer);           0, or the number of what is wrong
 *     ...
 *     plumb_recorder_close(recorder);
 *
 * What it sees     not_finite, false_contact, missed_contact, misaligned, off_surface, overlap_error; wrong_branch where the
 *                  overlap is above the depth along the line of centres. What it says is wrong is wrong: no guess.
 * What it cannot   a common normal that is not the lowest otherwise (wrong_branch); contacts missed where the line of centres
 *                  shows none; without points, which of overlap and normal is off. What it could not decide is counted as not
 *                  judged, and sample_every keeps answers for `plumb replay` to judge in full.
 * What it costs    tens of ns for ellipsoids, a hundred or two for other exponents, where the answer is whole and right; up to
 *                  some microseconds where it is wrong, has no points, or says of close bodies no more than that they do not touch.
 * What it keeps    the first of each bucket (finding, shapes, depth), across all runs and processes that share the folder.
 * Any thread may call plumb_record and plumb_recorder_begin: no lock, no allocation. A null recorder is legal and does nothing.
 * A child of fork() opens one of its own.
 */
#ifndef PLUMB_RECORDER_H
#define PLUMB_RECORDER_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* (|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1 = 1 in body axes; the rotation quaternion / |quaternion| takes them to the world's. */
typedef struct plumb_recorder_body {
  double shape[5]; /* a, b, c > 0; n1, n2 > 1 */
  double pose[7];  /* x, y, z; w, x, y, z of the quaternion, of any non-zero length */
} plumb_recorder_body;

/* World frame, the caller's unit. Without contact each field is judged where it is finite: leave NaN what there is not. */
typedef struct plumb_recorder_answer {
  int touching;        /* 1 or 0 */
  double overlap;      /* > 0: penetration depth; < 0: minus the distance */
  double normal[3];    /* unit, from body 1 to body 2 */
  double points[2][3]; /* on body 1, on body 2: points[0] - points[1] = overlap * normal */
} plumb_recorder_answer;

/* The contract's findings, as far as they can be seen without a reference. */
enum plumb_recorder_finding {
  PLUMB_FOUND_NOTHING,
  PLUMB_FOUND_CRASH,
  PLUMB_FOUND_NOT_FINITE,
  PLUMB_FOUND_FALSE_CONTACT,
  PLUMB_FOUND_MISSED_CONTACT,
  PLUMB_FOUND_WRONG_BRANCH,
  PLUMB_FOUND_MISALIGNED,
  PLUMB_FOUND_OFF_SURFACE,
  PLUMB_FOUND_OVERLAP_ERROR,
  PLUMB_FINDINGS
};

/* Fields that the foreign code never gives; in any other a NaN in a contact is not_finite. */
enum plumb_recorder_lacks { PLUMB_LACKS_OVERLAP = 1, PLUMB_LACKS_NORMAL = 2, PLUMB_LACKS_POINTS = 4 };

/* plumb_recorder_defaults has what to start from. */
typedef struct plumb_recorder_options {
  double tolerance;      /* error that is no news: angles in rad, lengths relative to the larger body; 0: what rounding
                    allows; negative or not finite: the default */
  unsigned lacks;        /* of enum plumb_recorder_lacks, added */
  unsigned max_files;    /* case files that this recorder writes, and as many samples; what is there already is none */
  uint64_t sample_every; /* every so many calls of a thread the answer becomes a file, whatever it is; 0: none */
  int sync;              /* 1: a file outlives a loss of power as well (fsync) */
} plumb_recorder_options;

/* What it has seen so far. */
typedef struct plumb_recorder_counts {
  uint64_t calls, not_judged, wrong; /* the others look right */
  uint64_t findings[PLUMB_FINDINGS];
  uint64_t files, samples, unwritten; /* unwritten: attempts that failed, see plumb_recorder_problem */
} plumb_recorder_counts;

/* One for a loop, or for each folder; opened, closed, and otherwise not looked into. */
typedef struct plumb_recorder plumb_recorder;

/* 1e-6, nothing lacking, 100 files, no samples, no fsync. */
plumb_recorder_options plumb_recorder_defaults(void);
/* Makes the folder where it is not there, and keeps as `crash` what runs that ended inside the foreign solver left in it. Null
 * options: the defaults. A folder that cannot be written, or a name that is empty or another's than a folder's, leaves a recorder that
 * judges and counts; null: no memory. */
plumb_recorder* plumb_recorder_open(const char* folder, const plumb_recorder_options* options);
/* The pair that is solved next on this thread, until plumb_record or the next begin: of what ends the process meanwhile a trace
 * stays, but for exit() and a return from main. One pair for each thread and recorder. Record on every path: a thread that ends
 * with a pair begun leaves it in flight, until another thread needs its place. */
void plumb_recorder_begin(plumb_recorder* recorder, const plumb_recorder_body* body1, const plumb_recorder_body* body2);
/* 0 when nothing looks wrong, otherwise of enum plumb_recorder_finding. */
int plumb_record(plumb_recorder* recorder, const plumb_recorder_body* body1, const plumb_recorder_body* body2,
                 const plumb_recorder_answer* answer);
/* The word of plumb's contract; "none" for 0. */
const char* plumb_recorder_finding_name(int finding);
/* At any time, from any thread. */
plumb_recorder_counts plumb_recorder_counted(const plumb_recorder* recorder);
/* The first thing that went wrong with the folder, "FILE: REASON"; "" when nothing did. */
const char* plumb_recorder_problem(const plumb_recorder* recorder);
/* After the last call of any thread. */
void plumb_recorder_close(plumb_recorder* recorder);
/* What plumb_recorder_open does with traces of runs that have ended, alone: how many there were; -1: the folder is of no use. */
int plumb_recorder_recover(const char* folder);

#ifdef __cplusplus
}
#endif
#endif /* PLUMB_RECORDER_H */

#if defined(PLUMB_RECORDER_IMPLEMENTATION) && !defined(PLUMB_RECORDER_IMPLEMENTED)
#define PLUMB_RECORDER_IMPLEMENTED

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#ifndef O_CLOEXEC /* strict C99 */
#define O_CLOEXEC 0
#endif
#ifndef O_NOFOLLOW
#define O_NOFOLLOW 0
#endif

enum {
  plumb__stripes = 64, /* of counters, so that threads do not share one */
  plumb__slots = 64,   /* of pairs that are being solved */
  plumb__probes = 8,   /* slots where a thread may have its pair */
  plumb__opened = 256, /* recorders that keep traces */
  plumb__classes = 24, /* shape kinds times slenderness */
  plumb__regimes = 6,
  plumb__buckets = PLUMB_FINDINGS * plumb__classes * plumb__regimes,
  plumb__text = 4096,
  plumb__path = 1280
};

typedef struct plumb__slot {
  unsigned state; /* 0 free, 1 claimed, else a pair in flight, and 1 + the number of the thread */
  plumb_recorder_body bodies[2];
  char spare[56];
} plumb__slot;

struct plumb_recorder {
  plumb_recorder_options options;
  struct {
    uint64_t calls, not_judged;
    char spare[112];
  } stripes[plumb__stripes];
  uint64_t counts[plumb__buckets];
  char kept[plumb__buckets];    /* 0 no, 1 being written, 2 yes */
  unsigned files, samples, run; /* run: in the names of its samples */
  uint64_t unwritten, temporaries;
  int has_folder;  /* otherwise nothing is written */
  int has_problem; /* 1: being written, 2: there */
  char problem[plumb__path + 128], folder[1024], flight[plumb__path];
  int flight_file;
  long process;
  plumb__slot* slots;
};

static __thread struct {
  unsigned stripe; /* from 1 */
  unsigned begun;  /* pairs in flight, in whatever recorders */
} plumb__thread;

/* ---- shapes. F = (|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1, gauge = F^(1/n1) ---- */

typedef struct plumb__placed {
  const double* shape;
  const double* centre;
  double axes[3][3]; /* body axes in the world frame, one a row */
} plumb__placed;

typedef struct plumb__pair {
  plumb__placed body[2];
  double apart[3], distance; /* from centre to centre */
  double size, least;        /* the longest and the shortest semi-axis of both */
  double far_out;            /* from the origin */
} plumb__pair;

static double plumb__dot(const double* a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Of a NaN neither says anything; fmin and fmax are calls. */
static double plumb__min(double a, double b) {
  return a < b ? a : b;
}

static double plumb__max(double a, double b) {
  return a > b ? a : b;
}

static double plumb__max3(const double* v) {
  return plumb__max(fabs(v[0]), plumb__max(fabs(v[1]), fabs(v[2])));
}

static void plumb__to_body(const plumb__placed* body, const double* v, double* out) {
  for (int i = 0; i < 3; ++i) out[i] = plumb__dot(body->axes[i], v);
}

static void plumb__place(plumb__placed* body, const plumb_recorder_body* given) {
  double w = given->pose[3], x = given->pose[4], y = given->pose[5], z = given->pose[6];
  double square = w * w + x * x + y * y + z * z;
  if (!(square > 1e-200 && square < 1e200)) { /* out of range, or no number at all */
    const double largest = plumb__max(fabs(w), plumb__max3(&given->pose[4]));
    w /= largest, x /= largest, y /= largest, z /= largest;
    square = w * w + x * x + y * y + z * z;
  }
  const double s = 2 / square;
  const double axes[3][3] = {{1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)},
                             {s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x)},
                             {s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y)}};
  memcpy(body->axes, axes, sizeof axes);
  body->shape = given->shape;
  body->centre = given->pose;
}

static double plumb__least(const double* shape) {
  return plumb__min(shape[0], plumb__min(shape[1], shape[2]));
}

static void plumb__place_pair(plumb__pair* pair, const plumb_recorder_body* body1, const plumb_recorder_body* body2) {
  plumb__place(&pair->body[0], body1);
  plumb__place(&pair->body[1], body2);
  for (int i = 0; i < 3; ++i) pair->apart[i] = body2->pose[i] - body1->pose[i];
  pair->distance = sqrt(plumb__dot(pair->apart, pair->apart));
  pair->size = plumb__max(plumb__max3(body1->shape), plumb__max3(body2->shape));
  pair->least = plumb__min(plumb__least(body1->shape), plumb__least(body2->shape));
  pair->far_out = plumb__max(plumb__max3(body1->pose), plumb__max3(body2->pose));
}

static int plumb__is_round(const double* shape) {
  return shape[3] == 2 && shape[4] == 2;
}

/* F at x in body axes, and its gradient over n1: both from the same powers. */
static double plumb__level(const double* shape, const double* x, double* gradient) {
  const double inverse[3] = {1 / shape[0], 1 / shape[1], 1 / shape[2]};
  const double u[3] = {x[0] * inverse[0], x[1] * inverse[1], x[2] * inverse[2]};
  if (plumb__is_round(shape)) {
    for (int i = 0; i < 3; ++i) gradient[i] = u[i] * inverse[i];
    return plumb__dot(u, u);
  }
  const double n1 = shape[3], n2 = shape[4];
  const double p[3] = {pow(fabs(u[0]), n2), pow(fabs(u[1]), n2), pow(fabs(u[2]), n1)};
  const double flat = p[0] + p[1], round = n1 == n2 ? flat : pow(flat, n1 / n2);
  const double of_flat = flat > 0 ? round / flat : 0;
  gradient[0] = x[0] == 0 ? 0 : of_flat * p[0] / x[0];
  gradient[1] = x[1] == 0 ? 0 : of_flat * p[1] / x[1];
  gradient[2] = x[2] == 0 ? 0 : p[2] / x[2];
  return round + p[2];
}

/* The gauge and its gradient, for points however far out. */
static double plumb__gauge(const double* shape, const double* x, double* gradient) {
  const double u[3] = {x[0] / shape[0], x[1] / shape[1], x[2] / shape[2]}, scale = plumb__max3(u);
  gradient[0] = gradient[1] = gradient[2] = 0;
  if (!(scale > 0)) return scale;
  const double scaled[3] = {x[0] / scale, x[1] / scale, x[2] / scale};
  const double level = plumb__level(shape, scaled, gradient);
  const double root = plumb__is_round(shape) ? sqrt(level) : pow(level, 1 / shape[3]);
  for (int i = 0; i < 3; ++i) gradient[i] *= root / level;
  return scale * root;
}

static void plumb__to_world(const plumb__placed* body, const double* v, double* out) {
  for (int i = 0; i < 3; ++i) out[i] = v[0] * body->axes[0][i] + v[1] * body->axes[1][i] + v[2] * body->axes[2][i];
}

/* The largest x.n over the body, and the x, from its centre: gauge and gradient of the body with reciprocal axes and exponents
 * n/(n-1). */
static double plumb__support(const plumb__placed* body, const double* n, double* point) {
  const double* s = body->shape;
  const double dual[5] = {1 / s[0], 1 / s[1], 1 / s[2], s[3] / (s[3] - 1), s[4] / (s[4] - 1)};
  double u[3], x[3];
  plumb__to_body(body, n, u);
  const double out = plumb__gauge(dual, u, x);
  plumb__to_world(body, x, point);
  return out;
}

/* No less than the support, and no power in it: that of the ellipsoid up to exponents of 2, of the box beyond. */
static double plumb__support_bound(const plumb__placed* body, const double* world) {
  double u[3];
  plumb__to_body(body, world, u);
  for (int i = 0; i < 3; ++i) u[i] *= body->shape[i];
  if (body->shape[3] <= 2 && body->shape[4] <= 2) return sqrt(plumb__dot(u, u));
  return fabs(u[0]) + fabs(u[1]) + fabs(u[2]);
}

/* How deep the bodies are in each other along a unit vector: the lowest over all of them is the overlap. */
static double plumb__depth(const plumb__pair* pair, const double* n) {
  double point[3];
  return plumb__support(&pair->body[0], n, point) + plumb__support(&pair->body[1], n, point) -
         plumb__dot(pair->apart, n);
}

/* ---- judgement: > 0 a finding, 0 looks right, -1 not judged ---- */

typedef struct plumb__allowed {
  double angle, length; /* of a point, which far from the origin is rounded the more */
  double depth;         /* of an overlap */
} plumb__allowed;

static plumb__allowed plumb__allow(const plumb__pair* pair, double tolerance) {
  const double few = 32 * DBL_EPSILON, own = tolerance * pair->size;
  const plumb__allowed out = {tolerance + few, own + few * (pair->size + pair->far_out),
                              own + few * (pair->size + pair->distance)};
  return out;
}

static int plumb__is_finite(const double* v, int count) {
  int is_finite = 1;
  for (int i = 0; i < count; ++i) is_finite &= fabs(v[i]) <= DBL_MAX;
  return is_finite;
}

static int plumb__has_exponents(const plumb_recorder_body* body) {
  const double n1 = body->shape[3], n2 = body->shape[4];
  return n1 > 1 && n1 <= DBL_MAX && n2 > 1 && n2 <= DBL_MAX;
}

static int plumb__is_legal(const plumb_recorder_body* body) {
  const double *s = body->shape, *q = &body->pose[3];
  return plumb__is_finite(s, 5) && plumb__is_finite(body->pose, 7) && s[0] > 0 && s[1] > 0 && s[2] > 0 &&
         plumb__has_exponents(body) && (q[0] != 0 || q[1] != 0 || q[2] != 0 || q[3] != 0);
}

/* Whether the point is on the body within `length`, and its normal along `sign` times n within `angle`; n unit, all but. Of a point
 * so far out that squares overflow: no. */
static int plumb__fits(const plumb__placed* body, const double* point, const double* n, double sign,
                       const plumb__allowed* allowed) {
  const double from_centre[3] = {point[0] - body->centre[0], point[1] - body->centre[1], point[2] - body->centre[2]};
  double x[3], u[3], g[3];
  plumb__to_body(body, from_centre, x);
  plumb__to_body(body, n, u);
  const double excess = (plumb__level(body->shape, x, g) - 1) / body->shape[3], square = plumb__dot(g, g);
  const double across[3] = {g[1] * u[2] - g[2] * u[1], g[2] * u[0] - g[0] * u[2], g[0] * u[1] - g[1] * u[0]};
  return fabs(excess) <= 1 && excess * excess <= allowed->length * allowed->length * square &&
         sign * plumb__dot(g, u) > 0 && plumb__dot(across, across) <= allowed->angle * allowed->angle * square;
}

/* The quick way: a whole answer that fits. Whatever is no number fails a comparison. */
static int plumb__is_right(const plumb__pair* pair, const plumb_recorder_answer* a, const plumb__allowed* allowed) {
  const double *p1 = a->points[0], *p2 = a->points[1], *n = a->normal;
  if (!(fabs(plumb__dot(n, n) - 1) <= 2 * allowed->angle)) return 0;
  double off[3];
  for (int i = 0; i < 3; ++i) off[i] = p1[i] - p2[i] - a->overlap * n[i];
  if (!(plumb__dot(off, off) <= allowed->length * allowed->length)) return 0;
  if (!plumb__fits(&pair->body[0], p1, n, 1, allowed) || !plumb__fits(&pair->body[1], p2, n, -1, allowed)) return 0;
  if (!a->touching) return a->overlap < 0; /* two planes between the bodies */
  const double* d = pair->apart;           /* not a unit vector: all lengths times the distance */
  const double most =
      plumb__support_bound(&pair->body[0], d) + plumb__support_bound(&pair->body[1], d) - plumb__dot(d, d);
  return a->overlap >= -allowed->depth && a->overlap * pair->distance <= most + allowed->depth * pair->distance;
}

static int plumb__is_apart_at_once(const plumb__pair* pair) {
  const double* d = pair->apart;
  return plumb__support_bound(&pair->body[0], d) + plumb__support_bound(&pair->body[1], d) <
         plumb__dot(d, d) * (1 - 32 * DBL_EPSILON);
}

/* The quick way squares lengths and divides them by each other. */
static int plumb__is_in_range(const plumb__pair* pair) {
  return pair->least > 1e-75 && pair->size < 1e75 && pair->far_out < 1e75;
}

/* What a point shows: its distance from the surface, the normal there, and how far that turns within `half` of the point. */
typedef struct plumb__seen {
  double gap, normal[3], turn;
} plumb__seen;

static double plumb__angle(const double* a, const double* b) {
  const double length = sqrt(plumb__dot(a, a) * plumb__dot(b, b));
  const double cross[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  return atan2(sqrt(plumb__dot(cross, cross)) / length, plumb__dot(a, b) / length);
}

static plumb__seen plumb__see(const plumb__placed* body, const double* point, double half) {
  const double from_centre[3] = {point[0] - body->centre[0], point[1] - body->centre[1], point[2] - body->centre[2]};
  plumb__seen seen = {0, {0, 0, 0}, 0};
  double x[3], g[3], at_corner[3];
  plumb__to_body(body, from_centre, x);
  const double value = plumb__gauge(body->shape, x, g), slope = sqrt(plumb__dot(g, g));
  seen.gap = fabs(value - 1) / slope;
  int is_near = 0; /* on a tip the slope says nothing of what is beside it */
  for (int i = 0; i < 8; ++i) {
    const double corner[3] = {x[0] + (i & 1 ? half : -half), x[1] + (i & 2 ? half : -half),
                              x[2] + (i & 4 ? half : -half)};
    is_near |= plumb__gauge(body->shape, corner, at_corner) >= 1;
    seen.turn = plumb__max(seen.turn, plumb__angle(g, at_corner));
  }
  if (value < 1 && is_near) seen.gap = plumb__min(seen.gap, half);
  for (int i = 0; i < 3; ++i) g[i] /= slope;
  plumb__to_world(body, g, seen.normal);
  return seen;
}

static int plumb__has_unit_normal(const plumb_recorder_answer* a, const plumb__allowed* allowed) {
  return fabs(sqrt(plumb__dot(a->normal, a->normal)) - 1) <= allowed->angle;
}

/* Of the points, with the normal and the overlap where they are finite; in the order of the contract. */
static int plumb__judge_points(const plumb__pair* pair, const plumb_recorder_answer* a, const plumb__allowed* allowed) {
  const plumb__seen at1 = plumb__see(&pair->body[0], a->points[0], allowed->length);
  const plumb__seen at2 = plumb__see(&pair->body[1], a->points[1], allowed->length);
  const double *p1 = a->points[0], *p2 = a->points[1], *n = plumb__is_finite(a->normal, 3) ? a->normal : at1.normal;
  const double d[3] = {p1[0] - p2[0], p1[1] - p2[1], p1[2] - p2[2]}, length = sqrt(plumb__dot(d, d));
  const double minus_n[3] = {-n[0], -n[1], -n[2]}, along = plumb__dot(d, n), turn = 2 * plumb__max(at1.turn, at2.turn);
  const double slack = 2 * allowed->length, overlap = plumb__is_finite(&a->overlap, 1) ? a->overlap : along;
  double off_line[3], off[3];
  for (int i = 0; i < 3; ++i) off_line[i] = d[i] - along * n[i], off[i] = d[i] - overlap * n[i];
  const int is_off = !(sqrt(plumb__dot(off, off)) <= slack), is_long = !(fabs(length - fabs(overlap)) <= slack);
  if ((n == a->normal && !plumb__has_unit_normal(a, allowed)) ||
      !(plumb__angle(at1.normal, n) <= allowed->angle + turn) ||
      !(plumb__angle(at2.normal, minus_n) <= allowed->angle + turn) ||
      !(sqrt(plumb__dot(off_line, off_line)) <= slack + length * (allowed->angle + turn)) || (is_off && !is_long))
    return PLUMB_FOUND_MISALIGNED;
  if (!(at1.gap <= allowed->length) || !(at2.gap <= allowed->length)) return PLUMB_FOUND_OFF_SURFACE;
  return is_off ? PLUMB_FOUND_OVERLAP_ERROR : PLUMB_FOUND_NOTHING;
}

/* A plane between the bodies, across the answer's normal. */
static int plumb__shows_gap(const plumb__pair* pair, const double* normal, double floor) {
  const double length = sqrt(plumb__dot(normal, normal));
  const double n[3] = {normal[0] / length, normal[1] / length, normal[2] / length};
  return plumb__depth(pair, n) < -floor;
}

static double plumb__gauge_at(const plumb__placed* body, const double* from_centre) {
  double x[3], gradient[3];
  plumb__to_body(body, from_centre, x);
  return plumb__gauge(body->shape, x, gradient);
}

/* A ball of more than that radius in both bodies, about a point between x1 in body 1 and x2 in body 2, both from centre 1. */
static int plumb__shares_ball(const plumb__pair* pair, const double* x1, const double* x2, double radius) {
  const plumb__placed *body1 = &pair->body[0], *body2 = &pair->body[1];
  const double *d = pair->apart, y1[3] = {x1[0] - d[0], x1[1] - d[1], x1[2] - d[2]},
               y2[3] = {x2[0] - d[0], x2[1] - d[1], x2[2] - d[2]};
  const double own1 = plumb__gauge_at(body1, x1), other1 = plumb__gauge_at(body1, x2);
  const double own2 = plumb__gauge_at(body2, y2), other2 = plumb__gauge_at(body2, y1);
  const double to = other1 <= 1 ? 1 : (1 - own1) / (other1 - own1),
               back = other2 <= 1 ? 1 : (1 - own2) / (other2 - own2);
  const double t = (to + 1 - back) / 2, left1 = 1 - own1 - t * (other1 - own1),
               left2 = 1 - own2 - (1 - t) * (other2 - own2);
  const double within1 = left1 * plumb__least(body1->shape), within2 = left2 * plumb__least(body2->shape);
  return to + back > 1 && within1 + within2 > sqrt(3) * radius;
}

/* How far to go from v along e and f, to the point of their triangle that is nearest to 0; along e alone where it is outside. */
static void plumb__nearest(const double* v, const double* e, const double* f, double* along) {
  const double ee = plumb__dot(e, e), ef = plumb__dot(e, f), ff = plumb__dot(f, f);
  const double ve = -plumb__dot(v, e), vf = -plumb__dot(v, f), scale = ee * ff - ef * ef;
  along[0] = (ve * ff - vf * ef) / scale;
  along[1] = (vf * ee - ve * ef) / scale;
  if (along[0] > 0 && along[1] > 0 && along[0] + along[1] < 1) return;
  along[0] = plumb__min(1, ve / ee);
  along[1] = 0;
}

/* 1: deeper in each other than `deep`; -1: further apart than `apart`; 0: neither in a few steps, which bring a point x1 of body 1
 * and x2 of body 2 nearer to each other (Gilbert's algorithm, with the step before). The first looks along the line of centres. */
static int plumb__verdict(const plumb__pair* pair, double deep, double apart) {
  enum { steps = 24 };
  const double* d = pair->apart;
  double x1[3] = {0, 0, 0}, x2[3] = {d[0], d[1], d[2]}, last1[3] = {0, 0, 0}, last2[3] = {d[0], d[1], d[2]};
  for (int k = 0; k < steps; ++k) {
    const double v[3] = {x2[0] - x1[0], x2[1] - x1[1], x2[2] - x1[2]}, length = sqrt(plumb__dot(v, v));
    double to1[3], to2[3], e[3], f[3], along[2];
    if (!(length > 0)) return plumb__shares_ball(pair, x1, x2, deep);
    const double n[3] = {v[0] / length, v[1] / length, v[2] / length};
    const double reach = plumb__support(&pair->body[0], n, to1) + plumb__support(&pair->body[1], n, to2);
    if (reach - plumb__dot(d, n) < -apart) return -1;
    if (k % 4 == 0 && plumb__shares_ball(pair, x1, x2, deep)) return 1;
    for (int i = 0; i < 3; ++i) {
      to2[i] = d[i] - to2[i];
      e[i] = to2[i] - to1[i] - v[i];
      f[i] = last2[i] - last1[i] - v[i];
    }
    plumb__nearest(v, e, f, along);
    for (int i = 0; i < 3; ++i) {
      x1[i] += along[0] * (to1[i] - x1[i]) + along[1] * (last1[i] - x1[i]);
      x2[i] += along[0] * (to2[i] - x2[i]) + along[1] * (last2[i] - x2[i]);
      last1[i] = to1[i];
      last2[i] = to2[i];
    }
  }
  return plumb__shares_ball(pair, x1, x2, deep);
}

/* No less than the distance of the bodies: that of their surfaces along the line of centres. */
static double plumb__distance_bound(const plumb__pair* pair) {
  const double* d = pair->apart;
  const double reach1 = pair->distance / plumb__gauge_at(&pair->body[0], d);
  const double reach2 = pair->distance / plumb__gauge_at(&pair->body[1], d);
  return plumb__max(0, pair->distance - reach1 - reach2);
}

/* Of an overlap alone: its sign, and a distance that is too long. */
static int plumb__judge_overlap(const plumb__pair* pair, const plumb_recorder_answer* a,
                                const plumb__allowed* allowed) {
  const int is_against = a->touching ? a->overlap < -allowed->depth : a->overlap > allowed->depth;
  const int is_far = a->overlap < -allowed->depth && -a->overlap > plumb__distance_bound(pair) + allowed->depth;
  return is_against || is_far ? PLUMB_FOUND_OVERLAP_ERROR : PLUMB_FOUND_NOTHING;
}

/* Of an answer without points: its own depth. */
static int plumb__judge_normal(const plumb__pair* pair, const plumb_recorder_answer* a, const plumb__allowed* allowed) {
  if (!plumb__is_finite(a->normal, 3)) return plumb__judge_overlap(pair, a, allowed);
  if (!plumb__has_unit_normal(a, allowed)) return PLUMB_FOUND_MISALIGNED;
  if (!plumb__is_finite(&a->overlap, 1)) return PLUMB_FOUND_NOTHING;
  return fabs(plumb__depth(pair, a->normal) - a->overlap) <= allowed->depth ? PLUMB_FOUND_NOTHING
                                                                            : PLUMB_FOUND_OVERLAP_ERROR;
}

/* The depth along the line of centres bounds the lowest. */
static int plumb__is_above_lowest(const plumb__pair* pair, double overlap, const plumb__allowed* allowed) {
  const double* d = pair->apart;
  const double line[3] = {d[0] / pair->distance, d[1] / pair->distance, d[2] / pair->distance};
  return overlap > plumb__depth(pair, line) + allowed->depth;
}

static int plumb__judge_geometry(const plumb__pair* pair, const plumb_recorder_answer* a,
                                 const plumb__allowed* allowed) {
  const int has_points = plumb__is_finite(a->points[0], 6);
  const int found = (has_points ? plumb__judge_points : plumb__judge_normal)(pair, a, allowed);
  if (found != PLUMB_FOUND_NOTHING || !plumb__is_above_lowest(pair, a->overlap, allowed)) return found;
  return has_points ? PLUMB_FOUND_WRONG_BRANCH : PLUMB_FOUND_OVERLAP_ERROR;
}

static int plumb__judge_contact(const plumb__pair* pair, const plumb_recorder_answer* a,
                                const plumb__allowed* allowed) {
  if (plumb__shows_gap(pair, a->normal, allowed->depth)) return PLUMB_FOUND_FALSE_CONTACT;
  const int found = plumb__judge_geometry(pair, a, allowed);
  const int has_some = plumb__is_finite(a->normal, 3) || plumb__is_finite(a->points[0], 6);
  if (found == PLUMB_FOUND_NOTHING && has_some) return found;
  const int verdict = plumb__verdict(pair, 0, allowed->depth);
  if (verdict < 0) return PLUMB_FOUND_FALSE_CONTACT;
  return found == PLUMB_FOUND_NOTHING && verdict == 0 ? -1 : found;
}

static int plumb__judge_apart(const plumb__pair* pair, const plumb_recorder_answer* a, const plumb__allowed* allowed) {
  const double floor = plumb__allow(pair, 0).depth;
  const int verdict = plumb__shows_gap(pair, a->normal, floor) ? -1 : plumb__verdict(pair, allowed->depth, floor);
  if (verdict > 0) return PLUMB_FOUND_MISSED_CONTACT;
  const int found = plumb__judge_geometry(pair, a, allowed);
  return found == PLUMB_FOUND_NOTHING && verdict == 0 ? -1 : found;
}

/* The answer without the fields that the foreign code never gives. */
static plumb_recorder_answer plumb__given(const plumb_recorder_answer* a, unsigned lacks) {
  plumb_recorder_answer out = *a;
  if (lacks & PLUMB_LACKS_OVERLAP) out.overlap = NAN;
  for (int i = 0; i < 3; ++i) {
    if (lacks & PLUMB_LACKS_NORMAL) out.normal[i] = NAN;
    if (lacks & PLUMB_LACKS_POINTS) out.points[0][i] = out.points[1][i] = NAN;
  }
  return out;
}

/* The fields that `lacks` does not name: all of them NaN. */
static int plumb__says_nothing(const plumb_recorder_answer* a, unsigned lacks) {
  const double *n = a->normal, *p = a->points[0], *q = a->points[1];
  return ((lacks & PLUMB_LACKS_OVERLAP) || isnan(a->overlap)) &&
         ((lacks & PLUMB_LACKS_NORMAL) || (isnan(n[0]) && isnan(n[1]) && isnan(n[2]))) &&
         ((lacks & PLUMB_LACKS_POINTS) ||
          (isnan(p[0]) && isnan(p[1]) && isnan(p[2]) && isnan(q[0]) && isnan(q[1]) && isnan(q[2])));
}

/* Fields that are half there, or infinite, or in a contact not there at all though the code gives them. */
static int plumb__is_broken(const plumb_recorder_answer* a, unsigned lacks) {
  const double* values[3] = {&a->overlap, a->normal, a->points[0]};
  const int counts[3] = {1, 3, 6};
  for (int k = 0; k < 3; ++k) {
    int missing = 0;
    if (lacks & (1u << k)) continue;
    for (int i = 0; i < counts[k]; ++i) missing += isnan(values[k][i]) ? 1 : 0;
    if (plumb__is_finite(values[k], counts[k])) continue;
    if (a->touching || missing != counts[k]) return 1;
  }
  return 0;
}

static int plumb__judge(const plumb_recorder_options* options, const plumb_recorder_body* body1,
                        const plumb_recorder_body* body2, const plumb_recorder_answer* a) {
  plumb__pair pair;
  plumb__place_pair(&pair, body1, body2);
  const plumb__allowed allowed = plumb__allow(&pair, options->tolerance), rounding = plumb__allow(&pair, 0);
  /* What else may be illegal is no number in the end, and fits nothing. */
  if (!plumb__is_in_range(&pair) || !plumb__has_exponents(body1) || !plumb__has_exponents(body2)) return -1;
  if (!a->touching && plumb__says_nothing(a, options->lacks) && plumb__is_apart_at_once(&pair))
    return PLUMB_FOUND_NOTHING;
  if (!options->lacks && plumb__is_right(&pair, a, &allowed)) return PLUMB_FOUND_NOTHING;
  if (!plumb__is_legal(body1) || !plumb__is_legal(body2)) return -1;
  const plumb_recorder_answer given = plumb__given(a, options->lacks);
  if (plumb__is_broken(a, options->lacks)) return PLUMB_FOUND_NOT_FINITE;
  int (*const judge)(const plumb__pair*, const plumb_recorder_answer*, const plumb__allowed*) =
      a->touching ? plumb__judge_contact : plumb__judge_apart;
  /* Wrong by the tolerance; which word, by the first that is wrong by rounding, as plumb's laws say it. */
  const int found = judge(&pair, &given, &allowed), named = found > 0 ? judge(&pair, &given, &rounding) : found;
  return named > 0 ? named : found;
}

/* ---- buckets and files ---- */

const char* plumb_recorder_finding_name(int finding) {
  static const char* const names[PLUMB_FINDINGS] = {"none",          "crash",          "not_finite",
                                                    "false_contact", "missed_contact", "wrong_branch",
                                                    "misaligned",    "off_surface",    "overlap_error"};
  return finding >= 0 && finding < PLUMB_FINDINGS ? names[finding] : "unknown";
}

/* The kind of shape in corpus/case/shape_class.hpp's order, times 4; 1 for a needle and 2 for a disc are added by the caller. */
static int plumb__kind(const double* s) {
  const int equal = (s[0] == s[1]) + (s[1] == s[2]) + (s[0] == s[2]);
  if (plumb__is_round(s)) return equal == 3 ? 0 : (equal == 1 ? 4 : 8);
  if (plumb__min(s[3], s[4]) < 2) return 20;
  return plumb__max(s[3], s[4]) <= 4 ? 12 : 16;
}

static int plumb__slenderness(const double* s) {
  const double least = plumb__least(s), most = plumb__max3(s);
  const double middle = plumb__max(plumb__min(s[0], s[1]), plumb__min(plumb__max(s[0], s[1]), s[2]));
  return (most >= 10 * middle ? 1 : 0) | (middle >= 10 * least ? 2 : 0);
}

static int plumb__regime(double ratio) {
  if (isnan(ratio)) return 0;
  if (fabs(ratio) < 1e-9) return 1;
  if (ratio < 0) return 2;
  return ratio < 1e-2 ? 3 : (ratio < 1e-1 ? 4 : 5);
}

static int plumb__bucket(int finding, const plumb_recorder_body* body1, const plumb_recorder_body* body2,
                         double overlap) {
  const int kind1 = plumb__kind(body1->shape), kind2 = plumb__kind(body2->shape);
  const int slender = plumb__slenderness(body1->shape) | plumb__slenderness(body2->shape);
  const int shape = (kind1 > kind2 ? kind1 : kind2) | slender;
  const int regime = plumb__regime(overlap / plumb__min(plumb__max3(body1->shape), plumb__max3(body2->shape)));
  return (finding * plumb__classes + shape) * plumb__regimes + regime;
}

static void plumb__bucket_name(int bucket, char* out, size_t size) {
  static const char* const kinds[6] = {
      "spheres", "spheroids", "ellipsoids", "round_superquadrics", "blocky_superquadrics", "pointed_superquadrics"};
  static const char* const slender[4] = {"", "-needle", "-disc", "-needle-and-disc"};
  static const char* const regimes[plumb__regimes] = {"unknown", "touching", "separated",
                                                      "shallow", "moderate", "deep"};
  const int shape = bucket / plumb__regimes % plumb__classes;
  (void)snprintf(out, size, "%s-%s%s-%s", plumb_recorder_finding_name(bucket / plumb__regimes / plumb__classes),
                 kinds[shape / 4], slender[shape % 4], regimes[bucket % plumb__regimes]);
}

typedef struct plumb__writer {
  char text[plumb__text];
  size_t used;
} plumb__writer;

static void plumb__put(plumb__writer* out, const char* text) {
  const size_t length = strlen(text), room = sizeof out->text - 1 - out->used;
  memcpy(out->text + out->used, text, length < room ? length : room);
  out->used += length < room ? length : room;
  out->text[out->used] = 0;
}

/* The shortest decimal that reads back, with a point whatever the locale writes. */
static void plumb__put_number(plumb__writer* out, double value) {
  char text[64], plain[64];
  size_t used = 0;
  for (int digits = 1; digits <= 17; ++digits) {
    (void)snprintf(text, sizeof text, "%.*g", digits, value);
    if (strtod(text, NULL) == value) break;
  }
  for (const char* c = text; *c; ++c) {
    const int is_plain = (*c >= '0' && *c <= '9') || *c == '-' || *c == '+' || *c == 'e';
    if (is_plain || used == 0 || plain[used - 1] != '.') plain[used++] = is_plain ? *c : '.';
  }
  plain[used] = 0;
  plumb__put(out, plain);
}

static void plumb__put_numbers(plumb__writer* out, const char* before, const double* values, int count,
                               const char* after) {
  plumb__put(out, before);
  for (int i = 0; i < count; ++i) {
    if (i > 0) plumb__put(out, ", ");
    plumb__put_number(out, values[i]);
  }
  plumb__put(out, after);
}

static void plumb__put_body(plumb__writer* out, const plumb_recorder_body* body) {
  plumb__put_numbers(out, "{\"shape\": {\"superellipsoid\": {\"semi_axes\": [", body->shape, 3, "]");
  plumb__put_numbers(out, ", \"exponents\": [", &body->shape[3], 2, "]}}");
  plumb__put_numbers(out, ", \"position\": [", body->pose, 3, "]");
  plumb__put_numbers(out, ", \"orientation\": {\"quaternion_wxyz\": [", &body->pose[3], 4, "]}}");
}

/* The fields of plumb solve; what is no number is left out, as JSON has none for it. */
static void plumb__put_answer(plumb__writer* out, const plumb_recorder_answer* a, int finding) {
  plumb__put(out, "{\"method\": \"recorded\", \"status\": ");
  plumb__put(out, finding == PLUMB_FOUND_NOT_FINITE ? "\"not_finite\"" : "\"converged\"");
  plumb__put(out, a->touching ? ", \"verdict\": \"overlapping\"" : ", \"verdict\": \"separated\"");
  if (plumb__is_finite(&a->overlap, 1)) plumb__put_numbers(out, ", \"overlap\": ", &a->overlap, 1, "");
  if (plumb__is_finite(a->normal, 3)) plumb__put_numbers(out, ", \"normal\": [", a->normal, 3, "]");
  if (plumb__is_finite(a->points[0], 6)) {
    plumb__put_numbers(out, ", \"points\": [[", a->points[0], 3, "]");
    plumb__put_numbers(out, ", [", a->points[1], 3, "]]");
  }
  plumb__put(out, "}");
}

/* A case; without an answer its solver gave none. */
static void plumb__put_case(plumb__writer* out, const char* name, int finding, uint64_t call,
                            const plumb_recorder_options* options, const plumb_recorder_body* const bodies[2],
                            const plumb_recorder_answer* answer) {
  char text[160];
  plumb__put(out, "{\"format\": \"plumb/case-1\", \"name\": \"");
  plumb__put(out, name);
  plumb__put(out, "\",\n \"bodies\": [");
  plumb__put_body(out, bodies[0]);
  plumb__put(out, ",\n            ");
  plumb__put_body(out, bodies[1]);
  plumb__put(out, "],\n \"x_answer\": ");
  if (answer) plumb__put_answer(out, answer, finding);
  if (!answer)
    plumb__put(
        out,
        "{\"method\": \"recorded\", \"x_finding\": \"crash\", \"x_detail\": \"the process ended inside the solver\"}");
  (void)snprintf(text, sizeof text, ",\n \"expect\": {\"finding\": \"%s\"}", plumb_recorder_finding_name(finding));
  if (finding != PLUMB_FOUND_NOTHING) plumb__put(out, text);
  (void)snprintf(text, sizeof text, ",\n \"provenance\": {\"recorder\": 1, \"call\": %llu", (unsigned long long)call);
  plumb__put(out, text);
  plumb__put_numbers(out, ", \"tolerance\": ", &options->tolerance, 1, "}}\n");
}

static const char plumb__is_special[] = "is no regular file";

/* The first problem is kept: a full disk is told once. */
static void plumb__tell(plumb_recorder* recorder, const char* path, const char* reason) {
  int none = 0;
  if (!__atomic_compare_exchange_n(&recorder->has_problem, &none, 1, 0, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) return;
  (void)snprintf(recorder->problem, sizeof recorder->problem, "%s: %s", path, reason);
  __atomic_store_n(&recorder->has_problem, 2, __ATOMIC_RELEASE);
}

/* -1 */
static int plumb__fail_because(plumb_recorder* recorder, const char* path, const char* reason) {
  (void)__atomic_fetch_add(&recorder->unwritten, 1, __ATOMIC_RELAXED);
  plumb__tell(recorder, path, reason);
  return -1;
}

static int plumb__fail(plumb_recorder* recorder, const char* path, int error) {
  return plumb__fail_because(recorder, path, strerror(error));
}

static int plumb__write_all(int file, const char* text, size_t size) {
  while (size > 0) {
    const ssize_t written = write(file, text, size);
    if (written < 0 && errno != EINTR) return 0;
    if (written > 0) text += written, size -= (size_t)written;
  }
  return 1;
}

/* 1: the file has its name; 0: there is another of that name, which stays; -1: neither. Where a file can have one name only, two
 * processes may both have 1. */
static int plumb__name_file(const char* beside, const char* path) {
  if (link(beside, path) == 0) {
    (void)unlink(beside);
    return 1;
  }
  if (errno == EEXIST || access(path, F_OK) == 0) return 0;
  return rename(beside, path) == 0 ? 1 : -1;
}

/* `beside` is where: a name that nobody has. */
static int plumb__open_beside(plumb_recorder* recorder, const char* path, char* beside, size_t size) {
  int file = -1;
  for (int i = 0; i < 1000; ++i) {
    const uint64_t number = __atomic_fetch_add(&recorder->temporaries, 1, __ATOMIC_RELAXED);
    (void)snprintf(beside, size, "%s.%ld.%llu.tmp", path, (long)getpid(), (unsigned long long)number);
    file = open(beside, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0 || errno != EEXIST) break;
  }
  return file;
}

/* 1: written; 0: a file of that name is there already, and is left as it is; -1: failed. By way of a temporary beside it, so that
 * what has the name is whole. */
static int plumb__write_file(plumb_recorder* recorder, const char* name, const plumb__writer* text) {
  char path[plumb__path], beside[plumb__path + 64];
  struct stat status;
  if (!recorder->has_folder) return plumb__fail(recorder, "folder", ENOENT);
  (void)snprintf(path, sizeof path, "%s/%s.json", recorder->folder, name);
  if (stat(path, &status) == 0)
    return S_ISREG(status.st_mode) ? 0 : plumb__fail_because(recorder, path, plumb__is_special);
  const int file = plumb__open_beside(recorder, path, beside, sizeof beside);
  if (file < 0) return plumb__fail(recorder, path, errno);
  const int is_whole = plumb__write_all(file, text->text, text->used) && (!recorder->options.sync || fsync(file) == 0);
  int error = errno;
  const int is_closed = close(file) == 0;
  if (is_whole && !is_closed) error = errno;
  const int named = is_whole && is_closed ? plumb__name_file(beside, path) : -1;
  if (named > 0) return 1;
  if (is_whole && is_closed) error = errno;
  (void)unlink(beside);
  return named < 0 ? plumb__fail(recorder, path, error) : 0;
}

/* One of max_files. */
static int plumb__take(unsigned* taken, unsigned most) {
  unsigned now = __atomic_load_n(taken, __ATOMIC_RELAXED);
  while (now < most)
    if (__atomic_compare_exchange_n(taken, &now, now + 1, 0, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) return 1;
  return 0;
}

/* Counts it, and writes the first of its bucket; after a failure again at the 2nd, 4th, 8th.. Whether the bucket has its file. */
static int plumb__keep(plumb_recorder* recorder, int finding, uint64_t call, const plumb_recorder_body* const bodies[2],
                       const plumb_recorder_answer* answer) {
  const int bucket = plumb__bucket(finding, bodies[0], bodies[1], answer ? answer->overlap : NAN);
  const uint64_t count = __atomic_add_fetch(&recorder->counts[bucket], 1, __ATOMIC_RELAXED);
  char* const kept = &recorder->kept[bucket];
  char name[128], now = __atomic_load_n(kept, __ATOMIC_RELAXED);
  plumb__writer text;
  if ((count & (count - 1)) != 0 || now != 0) return now == 2;
  if (!__atomic_compare_exchange_n(kept, &now, 1, 0, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) return 0;
  int written = -1;
  if (plumb__take(&recorder->files, recorder->options.max_files)) {
    text.used = 0;
    plumb__bucket_name(bucket, name, sizeof name);
    plumb__put_case(&text, name, finding, call, &recorder->options, bodies, answer);
    written = plumb__write_file(recorder, name, &text);
    if (written <= 0) (void)__atomic_fetch_sub(&recorder->files, 1, __ATOMIC_RELAXED);
  }
  __atomic_store_n(kept, written >= 0 ? 2 : 0, __ATOMIC_RELAXED);
  return written >= 0;
}

/* Named by run, thread and call; a run that is another's as well takes the next number. */
static void plumb__sample(plumb_recorder* recorder, uint64_t call, const plumb_recorder_body* const bodies[2],
                          const plumb_recorder_answer* answer) {
  char name[128];
  plumb__writer text;
  int written = 0;
  if (!plumb__is_legal(bodies[0]) || !plumb__is_legal(bodies[1])) return;
  if (!plumb__take(&recorder->samples, recorder->options.max_files)) return;
  for (int i = 0; written == 0 && i < 1000; ++i) {
    const unsigned run = i == 0 ? __atomic_load_n(&recorder->run, __ATOMIC_RELAXED)
                                : __atomic_add_fetch(&recorder->run, 1, __ATOMIC_RELAXED);
    (void)snprintf(name, sizeof name, "sample-%u-%u-%llu", run, plumb__thread.stripe, (unsigned long long)call);
    text.used = 0;
    plumb__put_case(&text, name, PLUMB_FOUND_NOTHING, call, &recorder->options, bodies, answer);
    written = plumb__write_file(recorder, name, &text);
  }
  if (written <= 0) (void)__atomic_fetch_sub(&recorder->samples, 1, __ATOMIC_RELAXED);
}

/* ---- pairs in flight: a file in memory, which the kernel keeps whatever ends the process ---- */

/* Whether nothing is lost without it. */
static int plumb__recover_slot(plumb_recorder* recorder, const plumb__slot* slot) {
  const plumb_recorder_body* const bodies[2] = {&slot->bodies[0], &slot->bodies[1]};
  if (slot->state < 2 || !plumb__is_legal(bodies[0]) || !plumb__is_legal(bodies[1])) return 1;
  return plumb__keep(recorder, PLUMB_FOUND_CRASH, 0, bodies, NULL);
}

/* -1: no file. Of a pipe neither this nor a read would come back. */
static int plumb__open_trace(plumb_recorder* recorder, const char* path) {
  struct stat status;
  const int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW);
  if (file < 0 || (fstat(file, &status) == 0 && S_ISREG(status.st_mode))) return file;
  plumb__tell(recorder, path, plumb__is_special);
  (void)close(file);
  return -1;
}

/* Of a process that has ended: a living one holds the lock. What could not be kept stays for the next to try. */
static void plumb__recover_file(plumb_recorder* recorder, const char* name) {
  char path[plumb__path];
  plumb__slot slot;
  if ((size_t)snprintf(path, sizeof path, "%s/%s", recorder->folder, name) >= sizeof path) return;
  const int file = plumb__open_trace(recorder, path);
  if (file < 0) return;
  if (flock(file, LOCK_EX | LOCK_NB) == 0) {
    int is_kept = 1;
    ssize_t part = (ssize_t)sizeof slot;
    while (part == (ssize_t)sizeof slot) {
      part = read(file, &slot, sizeof slot);
      if (part == (ssize_t)sizeof slot) is_kept &= plumb__recover_slot(recorder, &slot);
    }
    if (is_kept && part >= 0) (void)unlink(path);
  }
  (void)close(file);
}

/* Traces that were left, and the number of this run: after those of the samples that are there. */
static void plumb__look_into(plumb_recorder* recorder) {
  static const char flight[] = "in-flight.", sample[] = "sample-";
  unsigned long last = 0;
  DIR* const folder = opendir(recorder->folder);
  if (!folder) return;
  for (const struct dirent* entry = readdir(folder); entry; entry = readdir(folder)) {
    if (strncmp(entry->d_name, flight, sizeof flight - 1) == 0) plumb__recover_file(recorder, entry->d_name);
    if (strncmp(entry->d_name, sample, sizeof sample - 1) != 0) continue;
    const unsigned long run = strtoul(entry->d_name + sizeof sample - 1, NULL, 10);
    if (run > last && run < UINT32_MAX) last = run;
  }
  recorder->run = (unsigned)last + 1;
  (void)closedir(folder);
}

/* Locked and still there: between the two steps another process may have taken it for one that was left. */
static int plumb__lock_new(const char* path) {
  struct stat status;
  const int file = open(path, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) return -1;
  if (flock(file, LOCK_EX | LOCK_NB) == 0 && fstat(file, &status) == 0 && status.st_nlink == 1) return file;
  (void)close(file);
  errno = EEXIST;
  return -1;
}

static plumb_recorder* plumb__all_opened[plumb__opened];

/* 0: one of the two is not there. */
static int plumb__exchange_opened(plumb_recorder* from, plumb_recorder* to) {
  for (int i = 0; i < plumb__opened; ++i) {
    plumb_recorder* now = from;
    if (__atomic_compare_exchange_n(&plumb__all_opened[i], &now, to, 0, __ATOMIC_ACQ_REL, __ATOMIC_RELAXED)) return 1;
  }
  return 0;
}

/* A child of fork leaves its parent's. */
static void plumb__end_flight(const plumb_recorder* recorder) {
  if (recorder->process == (long)getpid()) (void)unlink(recorder->flight);
}

/* exit() is no crash: what threads have begun goes with the file. */
__attribute__((destructor)) static void plumb__at_exit(void) {
  for (int i = 0; i < plumb__opened; ++i) {
    plumb_recorder* const none = NULL;
    const plumb_recorder* const recorder = __atomic_exchange_n(&plumb__all_opened[i], none, __ATOMIC_ACQ_REL);
    if (recorder) plumb__end_flight(recorder);
  }
}

/* Written, not stretched: a mapped page that the disk has no room for would end the process. */
static plumb__slot* plumb__map_slots(int file) {
  static const char zero[plumb__slots * sizeof(plumb__slot)] = {0};
  if (!plumb__write_all(file, zero, sizeof zero)) return NULL;
  void* const at = mmap(NULL, sizeof zero, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  return at == MAP_FAILED ? NULL : (plumb__slot*)at;
}

static void plumb__unmap_slots(plumb_recorder* recorder) {
  if (recorder->slots) (void)munmap(recorder->slots, sizeof(plumb__slot) * plumb__slots);
  recorder->slots = NULL;
}

static void plumb__open_flight(plumb_recorder* recorder) {
  for (int i = 0; recorder->flight_file < 0 && i < 1000; ++i) {
    (void)snprintf(recorder->flight, sizeof recorder->flight, "%s/in-flight.%ld.%d", recorder->folder, (long)getpid(),
                   i);
    recorder->flight_file = plumb__lock_new(recorder->flight);
    if (recorder->flight_file < 0 && errno != EEXIST) break;
  }
  if (recorder->flight_file < 0) {
    (void)plumb__fail(recorder, recorder->flight, errno);
    return;
  }
  recorder->slots = plumb__map_slots(recorder->flight_file);
  if (recorder->slots && !plumb__exchange_opened(NULL, recorder)) {
    plumb__unmap_slots(recorder);
    errno = EMFILE;
  }
  if (!recorder->slots) (void)plumb__fail(recorder, recorder->flight, errno);
}

static unsigned plumb__stripe(void) {
  static unsigned threads;
  if (plumb__thread.stripe == 0) plumb__thread.stripe = __atomic_add_fetch(&threads, 1, __ATOMIC_RELAXED);
  return plumb__thread.stripe;
}

static plumb__slot* plumb__slot_of(const plumb_recorder* recorder, unsigned thread, unsigned probe) {
  return &recorder->slots[(thread + probe) % plumb__slots];
}

/* The pair of this thread in this recorder, if there is one. */
static void plumb__land(const plumb_recorder* recorder) {
  const unsigned thread = plumb__thread.stripe;
  for (unsigned i = 0; plumb__thread.begun > 0 && recorder->slots && i < plumb__probes; ++i) {
    plumb__slot* const slot = plumb__slot_of(recorder, thread, i);
    unsigned own = thread + 1;
    if (__atomic_load_n(&slot->state, __ATOMIC_RELAXED) != own) continue;
    --plumb__thread.begun;
    /* Another may just have taken it. */
    (void)__atomic_compare_exchange_n(&slot->state, &own, 0, 0, __ATOMIC_RELEASE, __ATOMIC_RELAXED);
    return;
  }
}

static int plumb__take_slot(plumb__slot* slot, unsigned was) {
  return __atomic_compare_exchange_n(&slot->state, &was, 1, 0, __ATOMIC_ACQUIRE, __ATOMIC_RELAXED);
}

/* A free slot; where there is none, the first: its thread has ended, or does without. NULL: another is about to take that. */
static plumb__slot* plumb__claim(const plumb_recorder* recorder, unsigned thread) {
  for (unsigned i = 0; i < plumb__probes; ++i) {
    plumb__slot* const slot = plumb__slot_of(recorder, thread, i);
    if (__atomic_load_n(&slot->state, __ATOMIC_RELAXED) == 0 && plumb__take_slot(slot, 0)) return slot;
  }
  plumb__slot* const first = plumb__slot_of(recorder, thread, 0);
  const unsigned now = __atomic_load_n(&first->state, __ATOMIC_RELAXED);
  return now != 1 && plumb__take_slot(first, now) ? first : NULL;
}

void plumb_recorder_begin(plumb_recorder* recorder, const plumb_recorder_body* body1,
                          const plumb_recorder_body* body2) {
  if (!recorder || !recorder->slots) return;
  plumb__land(recorder);
  const unsigned thread = plumb__stripe();
  plumb__slot* const slot = plumb__claim(recorder, thread);
  if (!slot) return;
  slot->bodies[0] = *body1;
  slot->bodies[1] = *body2;
  __atomic_store_n(&slot->state, thread + 1, __ATOMIC_RELEASE);
  ++plumb__thread.begun;
}

/* ---- the rest of the door ---- */

int plumb_record(plumb_recorder* recorder, const plumb_recorder_body* body1, const plumb_recorder_body* body2,
                 const plumb_recorder_answer* answer) {
  if (!recorder) return PLUMB_FOUND_NOTHING;
  plumb__land(recorder);
  const unsigned stripe = plumb__stripe() % plumb__stripes;
  const uint64_t call = __atomic_add_fetch(&recorder->stripes[stripe].calls, 1, __ATOMIC_RELAXED);
  const uint64_t every = recorder->options.sample_every;
  const plumb_recorder_body* const bodies[2] = {body1, body2};
  const int found = plumb__judge(&recorder->options, body1, body2, answer);
  if (found > 0) (void)plumb__keep(recorder, found, call, bodies, answer);
  if (found < 0) (void)__atomic_add_fetch(&recorder->stripes[stripe].not_judged, 1, __ATOMIC_RELAXED);
  if (every > 0 && call % every == 0) plumb__sample(recorder, call, bodies, answer);
  return found > 0 ? found : PLUMB_FOUND_NOTHING;
}

plumb_recorder_options plumb_recorder_defaults(void) {
  const plumb_recorder_options out = {1e-6, 0, 100, 0, 0};
  return out;
}

/* Made where it is not there. 0: there is none, and that is told. */
static int plumb__make_folder(plumb_recorder* recorder, const char* folder) {
  struct stat status;
  if (!folder || !*folder) return plumb__fail_because(recorder, "folder", "no name was given") >= 0;
  if (strlen(folder) >= sizeof recorder->folder) return plumb__fail(recorder, "folder", ENAMETOOLONG) >= 0;
  memcpy(recorder->folder, folder, strlen(folder) + 1);
  if (mkdir(folder, 0777) != 0 && errno != EEXIST) return plumb__fail(recorder, folder, errno) >= 0;
  if (stat(folder, &status) != 0) return plumb__fail(recorder, folder, errno) >= 0;
  return S_ISDIR(status.st_mode) || plumb__fail(recorder, folder, ENOTDIR) >= 0;
}

static plumb_recorder* plumb__open(const char* folder, const plumb_recorder_options* options) {
  plumb_recorder* const recorder = (plumb_recorder*)calloc(1, sizeof(plumb_recorder));
  if (!recorder) return NULL;
  recorder->options = options ? *options : plumb_recorder_defaults();
  if (!(recorder->options.tolerance >= 0 && recorder->options.tolerance <= DBL_MAX))
    recorder->options.tolerance = plumb_recorder_defaults().tolerance;
  recorder->flight_file = -1;
  recorder->process = (long)getpid();
  recorder->has_folder = plumb__make_folder(recorder, folder);
  if (recorder->has_folder) plumb__look_into(recorder);
  return recorder;
}

plumb_recorder* plumb_recorder_open(const char* folder, const plumb_recorder_options* options) {
  plumb_recorder* const recorder = plumb__open(folder, options);
  if (recorder && recorder->has_folder) plumb__open_flight(recorder);
  return recorder;
}

int plumb_recorder_recover(const char* folder) {
  plumb_recorder* const recorder = plumb__open(folder, NULL);
  const int is_of_use = recorder && recorder->unwritten == 0;
  const int crashes = is_of_use ? (int)plumb_recorder_counted(recorder).findings[PLUMB_FOUND_CRASH] : -1;
  plumb_recorder_close(recorder);
  return crashes;
}

plumb_recorder_counts plumb_recorder_counted(const plumb_recorder* recorder) {
  plumb_recorder_counts out;
  memset(&out, 0, sizeof out);
  if (!recorder) return out;
  for (int i = 0; i < plumb__stripes; ++i) {
    out.calls += __atomic_load_n(&recorder->stripes[i].calls, __ATOMIC_RELAXED);
    out.not_judged += __atomic_load_n(&recorder->stripes[i].not_judged, __ATOMIC_RELAXED);
  }
  for (int i = 0; i < plumb__buckets; ++i)
    out.findings[i / plumb__regimes / plumb__classes] += __atomic_load_n(&recorder->counts[i], __ATOMIC_RELAXED);
  for (int i = PLUMB_FOUND_NOT_FINITE; i < PLUMB_FINDINGS; ++i) out.wrong += out.findings[i];
  out.files = __atomic_load_n(&recorder->files, __ATOMIC_RELAXED);
  out.samples = __atomic_load_n(&recorder->samples, __ATOMIC_RELAXED);
  out.unwritten = __atomic_load_n(&recorder->unwritten, __ATOMIC_RELAXED);
  return out;
}

const char* plumb_recorder_problem(const plumb_recorder* recorder) {
  return recorder && __atomic_load_n(&recorder->has_problem, __ATOMIC_ACQUIRE) == 2 ? recorder->problem : "";
}

void plumb_recorder_close(plumb_recorder* recorder) {
  if (!recorder) return;
  if (recorder->slots && !plumb__exchange_opened(recorder, NULL)) return; /* the process ends, and that has it */
  plumb__unmap_slots(recorder);
  if (recorder->flight_file >= 0) {
    plumb__end_flight(recorder);
    (void)close(recorder->flight_file);
  }
  free(recorder);
}

#endif /* PLUMB_RECORDER_IMPLEMENTATION */
