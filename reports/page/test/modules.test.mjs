// What can be said without a browser: figures in words, axes that leave nothing out, surfaces that are surfaces.
import assert from "node:assert/strict";
import { test } from "node:test";
import { stream } from "./support/fixture.mjs";
import { contactPair } from "./support/fixture-geometry.mjs";
import { load } from "./support/modules.mjs";

test("figures are written as a reader wants them", async () => {
  const { percent, time, number, error, count } = await load("numbers.ts");
  assert.deepEqual([0, 1, 0.9999, 0.594, 0.0375, 0.00031].map(percent), ["0", "100", ">99.9", "59.4", "3.75", "0.031"]);
  assert.deepEqual(
    [350, 12400, 2.5e6].map((ns) => time(ns).replace(/\s/, " ")),
    ["350 ns", "12.4 µs", "2.5 ms"],
  );
  assert.deepEqual(
    [0, 1e-12, 0.25, 1e16, null].map((x) => number(x)),
    ["0", "1e-12", "0.25", "1e16", "—"],
  );
  assert.equal(error(3.4676e-10), "3.5e-10");
  assert.equal(count(1234567).replace(/\s/g, " "), "1 234 567");
});

const SHAPES = [
  [
    [1, 1, 1],
    [2, 2],
  ],
  [
    [1, 2, 1000],
    [2, 2],
  ],
  [
    [0.5, 1, 0.7],
    [50, 50],
  ],
  [
    [0.5, 1, 0.7],
    [50, 2],
  ],
  [
    [1, 0.8, 1.2],
    [1.1, 1.2],
  ],
];

test("every vertex of a mesh lies on its surface", async () => {
  const { wholeMesh } = await load("view3d/mesh.ts");
  const { gauge } = await load("view3d/superellipsoid.ts");
  const turn = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const same = (x) => x;
  for (const [axes, exponents] of SHAPES) {
    const { positions, triangles } = wholeMesh(
      { axes, exponents, turn, centre: [0, 0, 0] },
      { point: same, direction: same },
    );
    for (let i = 0; i < positions.length; i += 3) {
      const { value } = gauge({ axes, exponents }, positions.slice(i, i + 3));
      assert.ok(Math.abs(value - 1) < 1e-5, `${axes} ${exponents}: ${value}`);
    }
    assert.ok(Math.max(...triangles) < positions.length / 3);
  }
});

test("a picture is finite whatever the unit, the place and the proportions", async () => {
  const { geometryOf, focusOf } = await load("view3d/placed.ts");
  const random = stream(7);
  for (const size of [1e-300, 1e-9, 1, 1e17])
    for (const kind of ["ellipsoids", "ellipsoids-needle", "blocky_superquadrics", "pointed_superquadrics"])
      for (const ratio of [1, 1e-4]) {
        const pair = contactPair(random, { kind, size, far: 1e6 * size, ratio, overlapRatio: 1e-6, tilt: 0.3 });
        const geometry = geometryOf({ ...pair, case: { bodies: pair.bodies } });
        for (const zoom of ["bodies", "points", "overlap", ...(geometry.rim ? ["patch"] : [])]) {
          const { centre, radius } = focusOf(geometry, zoom);
          assert.ok([...centre, radius].every(Number.isFinite) && radius > 0, `${kind} ${size} ${zoom}`);
          if (zoom !== "bodies") continue;
          const { points, normals } = geometry.answer;
          for (const k of [0, 1]) {
            const tip = points[k].map((x, i) => x + 0.62 * radius * normals[k][i] - centre[i]);
            assert.ok(
              Math.hypot(...tip) < 0.95 * radius,
              `${kind} ${size}: an arrow of ${Math.hypot(...tip) / radius}`,
            );
          }
        }
      }
});

test("a piece of surface close to the contact meets both points, and shows the gap between them", async () => {
  const { geometryOf, focusOf, anchorOf } = await load("view3d/placed.ts");
  const { pieceMesh } = await load("view3d/mesh.ts");
  const pair = contactPair(stream(3), { kind: "ellipsoids", size: 1, far: 0, ratio: 1, overlapRatio: 1e-6, tilt: 0 });
  const geometry = geometryOf({ ...pair, case: { bodies: pair.bodies } });
  const focus = focusOf(geometry, "overlap");
  const mapping = { point: (x) => x.map((v, i) => (v - focus.centre[i]) / focus.radius), direction: (x) => x };
  const centres = geometry.bodies.map((body, index) => {
    const anchor = anchorOf(geometry, body, index, focus);
    return pieceMesh(body, anchor, 1.5 * focus.radius, mapping).positions.slice(0, 3);
  });
  const gap = Math.hypot(...centres[0].map((x, i) => x - centres[1][i])) * focus.radius * geometry.size;
  assert.ok(Math.abs(gap / pair.reference.overlap - 1) < 1e-3, `${gap} against ${pair.reference.overlap}`);
});

test("an axis has a floor for 0 and a gutter for no value, and neither without need", async () => {
  globalThis.matchMedia = () => ({ matches: false, addEventListener() {} });
  const { logScale } = await load("log_scale.ts");
  const scale = logScale([1e-12, 1e-3, 0, null]);
  assert.ok(scale.place(0) < 1e-12 && scale.place(null) > 1e-3);
  assert.ok(Math.log10(scale.place(null)) < scale.range[1] && Math.log10(scale.place(0)) > scale.range[0]);
  const plain = logScale([1e-12, 1e-3]);
  assert.deepEqual([plain.floor, plain.gutter], [null, null]);
});

test("names of certificates do not overprint, the first come is named, and none leaves the panel", async () => {
  const { placedNames } = await load("sections/certificate_labels.ts");
  const named = (text, ...pixel) => ({ text, pixel, colour: "#000000", at: [0, 0] });
  const crowd = Array.from({ length: 30 }, (_, i) => named("+ residual", 200 + 3 * i, -100 - 2 * i));
  const all = [named("+ bounds", 395, -50), ...crowd];
  const names = placedNames(all, 400);
  assert.equal(names[0].named, all[0]);
  assert.ok(names.length > 3 && names.length < all.length);
  const boxes = names.map(({ box }) => box);
  for (const [i, a] of boxes.entries()) {
    assert.ok(a.left >= 0 && a.right <= 400);
    for (const b of boxes.slice(i + 1))
      assert.ok(a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top);
  }
});

const LADDER = { name: "tie", knob: "broken_by", steps: [1e-2, 1e-8, 0] };
const ladderRow = (judged, wrong, lost) => {
  const failing = wrong.findIndex((n, step) => n + lost[step] > 0);
  return {
    method: "new_cn",
    answers: [9, 9, 9],
    judged,
    wrong,
    lost,
    findings: { misaligned: wrong, nonconverged: lost },
    lets_go: failing < 0 ? null : failing + 1,
  };
};

test("a ladder says where a method lets go, and what of it is known", async () => {
  const { describeStep, firstFinding, holdsOn, stepName, wholePercent } = await load(
    "sections/ladders/ladder_words.ts",
  );
  const row = ladderRow([8, 200, 0], [0, 1, 0], [0, 20, 0]);
  assert.equal(stepName(LADDER, 2), "1e-8 (step 2 of 3)");
  assert.equal(firstFinding(row), "nonconverged");
  assert.equal(
    describeStep(LADDER, row, 1),
    "new_cn, broken_by 1e-8 (step 2 of 3): of 200 judged answers 0.5 % wrong, 10.0 % lost (nonconverged 20, misaligned 1)",
  );
  assert.equal(describeStep(LADDER, row, 2), "new_cn, broken_by 0 (step 3 of 3): 9 answers, none judged");
  assert.equal(holdsOn(ladderRow([1, 1, 1], [0, 0, 0], [0, 0, 0])), "all 3 steps");
  assert.equal(holdsOn(ladderRow([1, 0, 1], [0, 0, 0], [0, 0, 0])), "2 of 3 steps judged");
  assert.deepEqual(
    [
      [0, 9],
      [1, 900],
      [899, 900],
      [1, 3],
      [9, 9],
    ].map(([part, of]) => wholePercent(part, of)),
    ["0", "<1", ">99", "33", "100"],
  );
});

test("ladders are ordered by how far a method gets", async () => {
  const { heldPart } = await load("sections/ladders/ladder_words.ts");
  const of = (row) => heldPart({ ...LADDER, methods: [row] }, "new_cn");
  const first = of(ladderRow([1, 1, 1], [1, 1, 1], [0, 0, 0]));
  const last = of(ladderRow([1, 1, 1], [0, 0, 1], [0, 0, 0]));
  const none = of(ladderRow([1, 1, 1], [0, 0, 0], [0, 0, 0]));
  assert.ok(first < last && last < none);
});
