// What opens the page and its gallery: which failure, and which failures first, at which accuracy.
import assert from "node:assert/strict";
import { test } from "node:test";
import { LOOKS } from "./support/fixture-methods.mjs";
import { load } from "./support/modules.mjs";

globalThis.matchMedia = () => ({ matches: false, addEventListener() {} });
const { byInterest, grouped, meetMethods, simplestOf } = await load(
  "methods.ts",
  "sections/answer_words.ts",
  "sections/gallery_order.ts",
);
const EMPTY = { runs: [], comparisons: [], precision: null, stability: null, study: null, fem: null };
meetMethods({ ...EMPTY, methods: LOOKS });

const SPHERE = { shape: { superellipsoid: { semi_axes: [1, 1, 1] } }, position: [0, 0, 0] };

function failureOf(method, finding, angle_error_deg, other = {}) {
  const { bodies = [SPHERE, SPHERE], ...rest } = other;
  const answer = { status: "converged", normal: [1, 0, 0], points: null, angle_error_deg };
  const reference = { normal: [0, 0, 1], points: [[0, 0, 0], [0, 0, 1]] }; // prettier-ignore
  return { method, finding, own: method === "auto", kept: "only", count: 1, case: { bodies }, answer, reference, right_from: null, ...rest }; // prettier-ignore
}

const opens = (failures) => simplestOf({ failures });

test("a misaligned common normal whose arrows part opens the page, also where others are simpler", () => {
  const seen = failureOf("original_cn", "misaligned", 23, {
    bodies: [{ ...SPHERE, position: [0.1234, 2, 3] }, SPHERE],
  });
  const others = [
    failureOf("geometric_potential", "missed_contact", 180),
    failureOf("geometric_potential", "misaligned", 30),
    failureOf("auto", "wrong_branch", 120),
    failureOf("auto", "misaligned", 0.3),
    failureOf("corrected_cn", "wrong_branch", 40),
    failureOf("new_cn", "misaligned", 24, {
      answer: { status: "max_iterations", normal: [1, 0, 0], angle_error_deg: 24 },
    }),
  ];
  assert.equal(opens([...others, seen]), seen);
  assert.equal(opens([seen, ...others]), seen);
});

test("of two such the own opens the page, then the shrunk, then the one of fewer digits", () => {
  const long = { bodies: [{ ...SPHERE, position: [0.123456789, 0, 0] }, SPHERE] };
  const [own, short] = [failureOf("auto", "misaligned", 6, long), failureOf("new_cn", "misaligned", 50)];
  assert.equal(opens([short, own]), own);
  const shrunk = failureOf("new_cn", "misaligned", 50, {
    ...long,
    shrunk: failureOf("new_cn", "misaligned", 70, long),
  });
  assert.equal(opens([short, shrunk]), shrunk);
  assert.equal(opens([failureOf("new_cn", "misaligned", 50, long), short]), short);
});

test("without such a failure another opens the page, and none that is rounding", () => {
  const branch = failureOf("corrected_cn", "wrong_branch", 40);
  const missed = failureOf("geometric_potential", "missed_contact", 180);
  const small = failureOf("new_cn", "misaligned", 0.2);
  const rounding = failureOf("auto", "misaligned", 1e-9);
  assert.equal(opens([small, missed, branch, rounding]), branch);
  assert.equal(opens([small, missed, rounding]), missed);
  assert.equal(opens([small, rounding]), small);
  assert.equal(opens([rounding]), null);
  assert.equal(opens([]), null);
});

const total = (method, fine, coarse) => ({
  method,
  right: { rounding: { share: fine }, "1deg": { share: coarse } },
});

test("the gallery begins with own failures, then with who is least often right at the required accuracy", () => {
  const totals = [total("new_cn", 0.1, 0.9), total("original_cn", 0.5, 0.2), total("auto", 1, 1)];
  const [often, seldom] = [500, 3].map((count) => failureOf("new_cn", "misaligned", 7, { count }));
  const original = failureOf("original_cn", "misaligned", 7, { count: 40 });
  const own = failureOf("auto", "misaligned", 7);
  const foreign = failureOf("solver:mine", "misaligned", 7, { own: true });
  const all = [seldom, original, often, foreign, own];
  assert.deepEqual(byInterest(all, totals, "rounding"), [own, foreign, often, original, seldom]);
  assert.deepEqual(byInterest(all, totals, "1deg"), [own, foreign, original, often, seldom]);
});

test("what is right at the required accuracy stands apart, as refusals do", () => {
  const fine = failureOf("new_cn", "misaligned", 1e-5, { right_from: "0.01deg" });
  const wrong = failureOf("new_cn", "misaligned", 9);
  const refusal = failureOf("new_cn", "nonconverged", 9);
  const shrunk = failureOf("new_cn", "misaligned", 1e-5, { right_from: "1e-6rad", shrunk: wrong });
  const all = [fine, wrong, refusal, shrunk];
  for (const level of ["rounding", "1e-6rad"])
    assert.deepEqual(grouped(all, level), { wrong: [fine, wrong, shrunk], refused: [refusal], right: [] });
  for (const level of ["0.01deg", "1deg"])
    assert.deepEqual(grouped(all, level), { wrong: [wrong, shrunk], refused: [refusal], right: [fine] });
});
