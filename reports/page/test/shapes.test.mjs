// Failures of any shapes: support points against closed forms, meshes against supports, and cards in Chromium.
import assert from "node:assert/strict";
import { test } from "node:test";
import { bring } from "./support/browser.mjs";
import { makeReport, stream } from "./support/fixture.mjs";
import { failureOfShapes, failuresOfShapes, SHAPES, swept } from "./support/fixture-shapes.mjs";
import { load } from "./support/modules.mjs";
import { withPage } from "./support/tab.mjs";

const { edgesOf, facesOf, focusOf, formMesh, formOf, geometryOf, picture, sizeOf } = await load(
  "view3d/corners.ts",
  "view3d/form_mesh.ts",
  "view3d/placed.ts",
  "view3d/scene.ts",
  "view3d/support.ts",
);

const unit = (a) => a.map((x) => x / Math.hypot(...a));
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);

function near(found, wanted, name) {
  for (const [i, x] of wanted.entries()) assert.ok(Math.abs(found[i] - x) < 1e-12, `${name}: ${found} for ${wanted}`);
}

/** Radius of the tablet's caps: radius^2 / (2 cap_height) + cap_height / 2. */
const CAP = 1 / 0.5 + 0.125;

/** Shape, direction, its farthest point. */
const SUPPORTS = [
  [SHAPES.box, [1, -1, 2], [1, -2, 3]],
  [SHAPES.capsule, [0, 0.6, 0.8], [0, 0.3, 2.4]],
  [SHAPES.capsule, [0, 0.6, -0.8], [0, 0.3, -2.4]],
  [SHAPES.cylinder, [0.6, 0.8, 1e-3], [0.3, 0.4, 2]],
  [SHAPES.cylinder, [0.6, 0.8, -9], [0.3, 0.4, -2]],
  [SHAPES.cone, [0.1, 0, 1], [0, 0, 1.5]],
  [SHAPES.cone, [-3, 4, -1], [-0.6, 0.8, -0.5]],
  [SHAPES.cone, [-3, 4, 1], [-0.6, 0.8, -0.5]],
  // Its centroid: the bottom is at -h/4 (R^2 + 2 R r + 3 r^2) / (R^2 + R r + r^2).
  [SHAPES.frustum, [1, 0, 1], [0.5, 0, 1 - 2.75 / 7]],
  [SHAPES.frustum, [1, 0, -1], [1, 0, -2.75 / 7]],
  [SHAPES.polyhedron, [1, 2, -3], [1, 1, -1]],
  [SHAPES.superellipsoid, [0, 0, -1], [0, 0, -3]],
  [{ superellipsoid: { semi_axes: [1, 2, 3] } }, [1, 1, 0], [1 / Math.sqrt(5), 4 / Math.sqrt(5), 0]],
  [SHAPES.poly_superellipsoid, [-1, 0, 0], [-2, 0, 0]],
  [SHAPES.poly_superellipsoid, [0, 0, -1], [0, 0, -4]],
  [{ poly_superellipsoid: { semi_axes: [1, 9, 9, 2, 3, 9] } }, [1, -1, 0], [1 / Math.sqrt(5), -4 / Math.sqrt(5), 0]],
  [SHAPES.tablet, [0, 0, 1], [0, 0, 0.75]],
  [SHAPES.tablet, [0, 0.28, -0.96], [0, 0.28 * CAP, -(0.75 - CAP + 0.96 * CAP)]],
  [SHAPES.tablet, [0, 1, 0.1], [0, 1, 0.5]],
  [swept(SHAPES.box, 0.5), [0.48, 0.6, 0.64], [1.24, 2.3, 3.32]],
  [swept(swept(SHAPES.cone, 0.25), 0.5), [0, 0, 1], [0, 0, 2.25]],
];

test("support points are those of the closed forms, in any unit", () => {
  for (const [shape, direction, wanted] of SUPPORTS) {
    const n = unit(direction);
    const name = `${JSON.stringify(shape)} along ${direction}`;
    near(formOf(shape, 1).support(n), wanted, name);
    near(formOf(shape, 4).support(n), formOf(shape, 1).support(n).map((x) => x / 4), name); // prettier-ignore
  }
});

test("the size is the reach, of a superellipsoid its longest axis", () => {
  const sizes = Object.entries(SHAPES).map(([word, shape]) => [word, sizeOf(shape)]);
  const wanted = {
    superellipsoid: 3,
    capsule: 2.5,
    cylinder: Math.hypot(2, 0.5),
    cone: 1.5,
    frustum: Math.hypot(1, 2.75 / 7),
    box: Math.hypot(1, 2, 3),
    polyhedron: Math.sqrt(3),
    half_space: 0,
    tablet: Math.hypot(0.5, 1),
  };
  for (const [word, size] of sizes) if (word in wanted) near([size], [wanted[word]], word);
  near([sizeOf(swept(SHAPES.cone, 0.5))], [2], "swept");
});

const TURN = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]; // prettier-ignore
const AS_IT_IS = { point: (x) => x, direction: (x) => x };
const meshOf = (form) => formMesh({ form, turn: TURN, centre: [0, 0, 0] }, AS_IT_IS);
const points = (flat) => Array.from({ length: flat.length / 3 }, (_, i) => [...flat.slice(3 * i, 3 * i + 3)]);

/** Of the tetrahedra from the origin. */
function volumeOf({ positions, triangles }) {
  const all = points(positions);
  let six = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = triangles.slice(i, i + 3).map((index) => all[index]);
    six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return six / 6;
}

test("a mesh lies in its form, reaches its surface, and looks outwards", () => {
  const random = stream(5);
  const shapes = Object.entries(SHAPES).flatMap(([word, shape]) =>
    word === "half_space" ? [] : [shape, swept(shape, 0.25)],
  );
  for (const shape of shapes) {
    const form = formOf(shape, 1);
    const { positions, normals, lines } = meshOf(form);
    const all = [...points(positions), ...lines.flat()];
    for (let i = 0; i < 50; i++) {
      const n = unit([random() - 0.5, random() - 0.5, random() - 0.5]);
      const height = dot(n, form.support(n));
      const found = Math.max(...all.map((x) => dot(n, x)));
      assert.ok(found < height + 1e-6, `${JSON.stringify(shape)}: ${found - height} outside`);
      assert.ok(found > height - 0.03, `${JSON.stringify(shape)}: ${height - found} inside`);
    }
    if (shape.sphere_swept) continue; // slivers between far corners may look anywhere
    const corners = points(positions);
    for (const [i, n] of points(normals).entries()) assert.ok(dot(n, corners[i]) > -1e-6, JSON.stringify(shape));
  }
});

test("meshes have the volume of their forms", () => {
  const volumes = {
    // Steiner: volume, surface, edges, corners.
    sphere_swept: 48 + 0.25 * 88 + Math.PI * 0.0625 * 12 + (4 / 3) * Math.PI * 0.25 ** 3,
    capsule: Math.PI * 0.25 * (4 + 2 / 3),
    cylinder: Math.PI,
    cone: (Math.PI * 2) / 3,
    frustum: (Math.PI / 3) * 1.75,
    box: 48,
    polyhedron: 8,
    tablet: Math.PI + 2 * ((Math.PI / 6) * 0.25 * (3 + 0.0625)),
  };
  for (const [word, volume] of Object.entries(volumes)) {
    const found = volumeOf(meshOf(formOf(SHAPES[word] ?? swept(SHAPES.box, 0.25), 1)));
    assert.ok(Math.abs(found / volume - 1) < 5e-3, `${word}: ${found} for ${volume}`);
  }
});

test("a hull has its faces and edges, also where it is thin, flat, a segment or a point", () => {
  const cube = SHAPES.polyhedron.polyhedron.points;
  const counted = (corners) => {
    const faces = facesOf(corners);
    return [faces.length, edgesOf(corners, faces).length];
  };
  assert.deepEqual(counted(cube), [6, 12]);
  assert.deepEqual(counted(cube.map(([x, y, z]) => [x, y, 1e-9 * z])), [6, 12]); // prettier-ignore
  assert.deepEqual(counted([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]), [4, 6]); // prettier-ignore
  assert.deepEqual(counted([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]), [1, 4]); // prettier-ignore
  assert.deepEqual(counted([[0, 0, 0], [1, 0, 2]]), [0, 1]); // prettier-ignore
  assert.deepEqual(counted([[1, 2, 3]]), [0, 0]);
});

const ZOOMS = ["bodies", "patch", "points", "overlap"];

test("a failure of each shape is drawn, with its points and without a patch", () => {
  for (const failure of failuresOfShapes()) {
    const geometry = geometryOf(failure);
    const hasPoints = failure.answer.points !== null;
    for (const zoom of ZOOMS) {
      const isSeen = zoom === "bodies" || (hasPoints && zoom !== "patch");
      const focus = focusOf(geometry, zoom);
      assert.equal(focus !== null, isSeen, `${failure.bucket} ${zoom}`);
      const drawn = picture(geometry, zoom, "light");
      assert.equal(drawn !== null, isSeen, `${failure.bucket} ${zoom}`);
      if (!drawn) continue;
      const names = drawn.labels.map(({ text }) => text);
      for (const name of hasPoints ? ["p1", "p2", "normal"] : []) assert.ok(names.includes(name), failure.bucket);
      drawn.scene.traverse(({ geometry: of }) => {
        for (const x of of?.getAttribute("position")?.array ?? []) assert.ok(Number.isFinite(x), failure.bucket);
      });
    }
  }
});

test("a half-space is a square on its plane about the contact, wherever its position is", () => {
  const failure = failureOfShapes(swept(SHAPES.half_space, 0.25), SHAPES.capsule);
  const [wall] = failure.case.bodies;
  const { bodies, size } = geometryOf(failure);
  const normal = bodies[0].turn.map((row) => row[2]);
  const height = dot(normal, wall.position) + 0.25;
  near(bodies[0].centre, normal.map((x) => (x * height) / size), "its middle"); // prettier-ignore
});

test("cards of every shape are shown without a complaint, and without figures that they have not", () => {
  const report = makeReport({ failures: 1 });
  report.runs[0].failures = failuresOfShapes();
  return withPage(report, {}, async (page, noticed) => {
    await bring(page, "#gallery canvas");
    const words = await page.$eval("#gallery", (gallery) => {
      for (const fold of gallery.querySelectorAll("details")) fold.open = true;
      return gallery.textContent;
    });
    assert.doesNotMatch(words, /undefined|NaN|\[object/);
    const names = await page.$$eval("#gallery article", (cards) =>
      cards.map((card) => card.getAttribute("aria-label")),
    );
    assert.ok(names.includes("nonconverged of auto, superellipsoid against capsule"), names.join("; "));
    for (const name of names) assert.doesNotMatch(name, /, $/);
    const facts = await page.$$eval("#gallery article th", (heads) => heads.map((head) => head.textContent));
    assert.ok(facts.includes("overlap") && !facts.includes("angle error, °"));
    await page.click('#gallery .view3d button[title^="Zoom to the overlap"]:not([disabled])');
    assert.deepEqual(noticed, { console: [], requests: [] });
  });
});
