// A whole solver for plumb's process door, of limited ability: the common normal of lowest overlap of two ellipsoids.
//
//     plumb campaign --family ellipsoid --cases 1000 --seed 1 --solver-command 'node solver/js/example/ellipsoids.mjs' --out DIR
//
// Along a unit n the bodies overlap by o(n) = h1(n) + h2(n) - n.r, with the support functions h(n) = sqrt(n.S n) and r from body 1 to
// body 2. The least of all directions is the overlap. Newton on the sphere, from several directions: a common normal is where the
// gradient of o along the sphere is 0.
import { add, dot, norm, scale, serve, subtract } from '../plumb_solver.mjs';

const DIRECTIONS = 400; // looked at; Newton starts from the best of them
const STARTS = 12;
const STEPS = 60;

const isEllipsoid = (body) => body.exponents[0] === 2 && body.exponents[1] === 2;
const unit = (v) => scale(1 / norm(v), v);
const cross = (u, v) => [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];

// h, its gradient (the support point), and the action of its Hessian on a vector.
function support(body, n) {
  const w = body.semiAxes.map((a, i) => a * body.toBody(n)[i]);
  const h = norm(w);
  const times = (v) => body.toWorld(v.map((x, i) => x * body.semiAxes[i]));
  const point = times(scale(1 / h, w));
  const hessian = (t) => {
    const q = body.semiAxes.map((a, i) => a * body.toBody(t)[i]);
    return times(scale(1 / h, subtract(q, scale(dot(q, w) / (h * h), w))));
  };
  return { h, point, hessian };
}

function overlapAlong(pair, n) {
  const [one, two] = pair.bodies.map((body) => support(body, n));
  const offset = pair.bodies[1].position; // body 1 is at the origin
  return {
    n,
    value: one.h + two.h - dot(n, offset),
    gradient: subtract(add(one.point, two.point), offset),
    hessian: (t) => add(one.hessian(t), two.hessian(t)),
    points: [one.point, subtract(offset, two.point)],
  };
}

function tangents(n) {
  const least = n.map(Math.abs).reduce((best, v, i, all) => (v < all[best] ? i : best), 0);
  const first = unit(cross(n, [0, 1, 2].map((i) => (i === least ? 1 : 0))));
  return [first, cross(n, first)];
}

// One step down, with as much added to the curvature as makes it a minimum's; the same place where none leads down.
function step(pair, at) {
  const [u, v] = tangents(at.n);
  const [hu, hv] = [at.hessian(u), at.hessian(v)];
  const [a, b, c] = [dot(u, hu) - at.value, dot(u, hv), dot(v, hv) - at.value];
  const [gu, gv] = [dot(u, at.gradient), dot(v, at.gradient)];
  const lowest = (a + c) / 2 - Math.hypot((a - c) / 2, b);
  for (let damping = Math.max(0, -1.5 * lowest), k = 0; k < 30; ++k, damping = 4 * damping + 1e-3 * Math.hypot(a, b, c)) {
    const det = (a + damping) * (c + damping) - b * b;
    const x = [-(gu * (c + damping) - gv * b) / det, -(gv * (a + damping) - gu * b) / det];
    const next = overlapAlong(pair, unit(add(at.n, add(scale(x[0], u), scale(x[1], v)))));
    if (next.value < at.value) return next;
    // At rounding the value says nothing more: the slope does.
    if (k === 0 && lowest > 0 && slope(next) < slope(at) && Math.hypot(...x) < 1e-6) return next;
  }
  return at;
}

const slope = (at) => norm(subtract(at.gradient, scale(at.value, at.n)));

function descend(pair, n) {
  let at = overlapAlong(pair, n);
  for (let i = 0; i < STEPS; ++i) {
    const next = step(pair, at);
    if (next === at) return { ...at, iterations: i };
    at = next;
  }
  return { ...at, iterations: STEPS };
}

// Evenly over the sphere: a spiral by the golden angle.
const spiral = Array.from({ length: DIRECTIONS }, (_, i) => {
  const z = 1 - (2 * i + 1) / DIRECTIONS;
  const turn = i * Math.PI * (3 - Math.sqrt(5));
  return [Math.sqrt(1 - z * z) * Math.cos(turn), Math.sqrt(1 - z * z) * Math.sin(turn), z];
});

function starts(pair) {
  const offset = pair.bodies[1].position;
  const all = norm(offset) > 0 ? [unit(offset), ...spiral] : spiral;
  const valued = all.map((n) => ({ n, value: overlapAlong(pair, n).value }));
  return valued.sort((p, q) => p.value - q.value).slice(0, STARTS);
}

function solve(pair) {
  if (!pair.bodies.every(isEllipsoid)) return null;
  const found = starts(pair).map(({ n }) => descend(pair, n));
  const best = found.reduce((p, q) => (q.value < p.value ? q : p));
  const { value, n, points, iterations } = best;
  return pair.answer({ overlap: value, normal: n, points, iterations });
}

await serve(solve, { name: 'ellipsoids.mjs', version: '1', licence: 'BSD-3-Clause', shapes: 'ellipsoids', tolerance: 1e-12 });
