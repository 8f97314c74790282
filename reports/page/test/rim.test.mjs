// The rim of a patch, without a browser: closed forms, and what has none.
import assert from "node:assert/strict";
import { test } from "node:test";
import { contactPair } from "./support/fixture-geometry.mjs";
import { stream } from "./support/fixture.mjs";
import { makePlayback } from "./support/fixture-playback.mjs";
import { load } from "./support/modules.mjs";

const { geometryOf, halfSpace, rimOf, surfaceOf, usesPatch } = await load(
  "view3d/placed.ts",
  "view3d/rim.ts",
  "playback/patches.ts",
);

const TURN = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
const UP = [0, 0, 1];
const body = (axes, exponents, centre) => surfaceOf({ axes, exponents, turn: TURN, centre });
const ball = (radius, height) => body([radius, radius, radius], [2, 2], [0, 0, height]);
const cube = (height) => body([1, 1, 1], [8, 8], [0, 0, height]);
const near = (value, wanted, slack) => assert.ok(Math.abs(value - wanted) <= slack, `${value} for ${wanted}`);

test("the rim of two spheres is their circle", () => {
  for (const [r1, r2, apart] of [
    [1, 1, 1.9],
    [1, 0.3, 1.2],
    [1, 0.8, 1.8 - 1e-6],
  ]) {
    const height = (apart ** 2 + r1 ** 2 - r2 ** 2) / (2 * apart);
    const rim = rimOf(ball(r1, 0), ball(r2, apart), [0, 0, height], UP);
    for (const [x, y, z] of rim) {
      near(Math.hypot(x, y), Math.sqrt(r1 ** 2 - height ** 2), 1e-9);
      near(z, height, 1e-9);
    }
  }
});

test("the rim of a sphere in a wall is the circle of their section", () => {
  const rim = rimOf(ball(1, 0), halfSpace([5, 3, 0.96], [0, 0, -1]), [0, 0, 0.9], UP);
  for (const [x, y, z] of rim) {
    near(Math.hypot(x, y), 0.28, 1e-9);
    near(z, 0.96, 1e-9);
  }
});

test("the rim of face on face is on both surfaces, their section, and not cut short at its corners", () => {
  const bodies = [cube(0), cube(1.99)];
  const rim = rimOf(...bodies, [0.1, 0, 0.995], UP);
  for (const point of rim) {
    for (const surface of bodies) near(surface(point).value, 1, 1e-12);
    near(point[0] ** 8 + point[1] ** 8, 1 - 0.995 ** 8, 1e-9);
  }
  near(Math.max(...rim.map(([x, y]) => x + y)), 2 * ((1 - 0.995 ** 8) / 2) ** (1 / 8), 1e-3);
  assert.ok(rim.length < 400, `${rim.length}`);
});

test("the rim of an edge on a face is as long as the edge", () => {
  const half = Math.SQRT1_2;
  const turn = [
    [half, 0, half],
    [0, 1, 0],
    [-half, 0, half],
  ];
  const lying = surfaceOf({ axes: [1, 1, 1], exponents: [40, 40], turn, centre: [0, 0, 0] });
  const top = 1 / lying([0, 0, 1]).value;
  const rim = rimOf(lying, halfSpace([0, 0, top - 0.01], [0, 0, -1]), [0, 0, top], UP);
  const reach = (axis) => Math.max(...rim.map((point) => point[axis]));
  assert.ok(reach(1) > 0.9 && reach(0) < 0.05, `${reach(0)} ${reach(1)}`);
});

test("bodies apart, and one in the other, have no rim", () => {
  assert.equal(rimOf(ball(1, 0), ball(1, 2.01), [0, 0, 1.005], UP), null);
  assert.equal(rimOf(cube(0), cube(2.1), [0, 0, 1.05], UP), null);
  assert.equal(rimOf(ball(1, 0), ball(0.3, 0.4), [0, 0, 0.5], UP), null);
  assert.equal(rimOf(ball(1, 0), ball(1, 0), [0, 0, 0], UP), null);
  assert.equal(rimOf(ball(1, 0), halfSpace([0, 0, 1], [0, 0, 0]), [0, 0, 1], UP), null);
});

test("of made-up failures the rim is on both bodies, at any depth", () => {
  const random = stream(11);
  for (const kind of ["ellipsoids", "blocky", "pointed"])
    for (const overlapRatio of [1e-9, 1e-6, 1e-3, 0.05]) {
      const pair = contactPair(random, { kind, size: 1e9, far: 0, ratio: 0.7, overlapRatio, tilt: 0.3 });
      const { bodies, rim } = geometryOf({ ...pair, case: { bodies: pair.bodies } });
      for (const point of rim) for (const one of bodies) near(surfaceOf(one)(point).value, 1, 1e-12);
    }
});

test("a scene uses patches where one of its effects does", () => {
  const scene = makePlayback({ bodies: 2, frames: 1 });
  assert.equal(usesPatch(scene), false);
  const effect = (name, on) => usesPatch({ ...scene, effects: [{ name, on, why: "" }] });
  assert.deepEqual([effect("volume", true), effect("foundation", true), effect("volume", false)], [true, true, false]);
});
