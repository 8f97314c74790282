/* A contact loop with the flight recorder in it: cc main.c -lm
 *
 * The contact is naive: where the line of centres leaves the bodies. Right for spheres, wrong for ellipsoids. */
#define PLUMB_RECORDER_IMPLEMENTATION
#include <math.h>
#include <plumb/plumb_recorder.h>
#include <stdio.h>

typedef plumb_recorder_body Body;
typedef plumb_recorder_answer Answer;

/* From the centre to the surface along a unit vector; the bodies are not turned. */
static double reach(const Body* body, const double line[3]) {
  const double* s = body->shape;
  return 1 / sqrt(pow(line[0] / s[0], 2) + pow(line[1] / s[1], 2) + pow(line[2] / s[2], 2));
}

static Answer naive_contact(const Body* body1, const Body* body2) {
  Answer answer = {0, NAN, {NAN, NAN, NAN}, {{NAN, NAN, NAN}, {NAN, NAN, NAN}}};
  const double *c1 = body1->pose, *c2 = body2->pose;
  const double distance = sqrt(pow(c2[0] - c1[0], 2) + pow(c2[1] - c1[1], 2) + pow(c2[2] - c1[2], 2));
  const double line[3] = {(c2[0] - c1[0]) / distance, (c2[1] - c1[1]) / distance, (c2[2] - c1[2]) / distance};
  const double overlap = reach(body1, line) + reach(body2, line) - distance;
  if (overlap <= 0) return answer;
  answer.touching = 1;
  answer.overlap = overlap;
  for (int i = 0; i < 3; ++i) {
    answer.normal[i] = line[i];
    answer.points[0][i] = c1[i] + reach(body1, line) * line[i];
    answer.points[1][i] = c2[i] - reach(body2, line) * line[i];
  }
  return answer;
}

int main(void) {
  const double shapes[2][5] = {{1, 1, 1, 2, 2}, {1.2, 1, 0.8, 2, 2}}; /* a, b, c, n1, n2 */
  plumb_recorder* recorder = plumb_recorder_open("wrong-contacts", NULL);
  for (int step = 0; step < 1000; ++step) {
    Body body1 = {{1, 1, 1, 2, 2}, {0, 0, 0, 1, 0, 0, 0}};
    Body body2 = {{0, 0, 0, 0, 0}, {4 - 0.008 * step, 1.1, 0.6, 1, 0, 0, 0}}; /* x, y, z, quaternion */
    for (int i = 0; i < 5; ++i) body2.shape[i] = shapes[step % 2][i];
    plumb_recorder_begin(recorder, &body1, &body2);
    const Answer answer = naive_contact(&body1, &body2);
    plumb_record(recorder, &body1, &body2, &answer);
  }
  const plumb_recorder_counts counts = plumb_recorder_counted(recorder);
  printf("%d of %d answers are wrong, %d files\n", (int)counts.wrong, (int)counts.calls, (int)counts.files);
  for (int finding = 1; finding < PLUMB_FINDINGS; ++finding)
    if (counts.findings[finding] > 0)
      printf("  %-14s %d\n", plumb_recorder_finding_name(finding), (int)counts.findings[finding]);
  if (*plumb_recorder_problem(recorder)) printf("%s\n", plumb_recorder_problem(recorder));
  plumb_recorder_close(recorder);
  return 0;
}
