// The process door of plumb for a contact solver in JavaScript: this file alone, Node 18 or later, nothing else.
//
//     import { serve } from './plumb_solver.mjs';
//
//     function solve(pair) {                                  // called for one pair after the other
//       const [one, two] = pair.bodies;
//       ...
//       return pair.answer({ overlap, normal, points });      // or null: refused
//     }
//     await serve(solve, { name: 'mine', shapes: 'ellipsoids' });
//
// Then `plumb campaign --family all --cases 1000 --seed 1 --solver-command 'node mine.mjs' --out DIR` judges it. The abilities are the fields
// of corpus/solvers/abilities.hpp: what is not claimed is not asked. Standard output is plumb's: console.log goes to standard error here.
//
// A pair comes in safe numbers: world axes, origin at body 1, lengths in a power of two that puts the largest semi-axis into [1, 2).
// `pair.answer` takes lengths and points in the same and brings them back.
import { createInterface } from 'node:readline';
import { performance } from 'node:perf_hooks';

export const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
export const scale = (s, v) => [s * v[0], s * v[1], s * v[2]];
export const add = (u, v) => [u[0] + v[0], u[1] + v[1], u[2] + v[2]];
export const subtract = (u, v) => [u[0] - v[0], u[1] - v[1], u[2] - v[2]];
export const norm = (v) => Math.hypot(v[0], v[1], v[2]);

// (|x|^m + |y|^m)^(1/m) and its gradient; zeros at the origin.
function normGradient(x, y, m) {
  const top = Math.max(Math.abs(x), Math.abs(y));
  if (top === 0) return { value: 0, gradient: [0, 0] };
  const value = top * ((Math.abs(x) / top) ** m + (Math.abs(y) / top) ** m) ** (1 / m);
  const slope = (v) => Math.sign(v) * (Math.abs(v) / value) ** (m - 1);
  return { value, gradient: [slope(x), slope(y)] };
}

// Of any length above 0.
function unitQuaternion(q) {
  const largest = Math.max(...q.map(Math.abs));
  const scaled = q.map((v) => v / largest);
  const length = Math.hypot(...scaled);
  return scaled.map((v) => v / length);
}

// Three rows; takes body axes to world axes.
function rotationOf([w, x, y, z]) {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
}

// (|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1 = 1 in body axes, turned and placed.
export class Body {
  constructor(semiAxes, exponents, position, quaternion) {
    this.semiAxes = semiAxes;
    this.exponents = exponents;
    this.position = position;
    this.quaternion = quaternion; // w, x, y, z, of length 1
    this.rotation = rotationOf(quaternion);
  }

  // A direction of the body's axes in the world's, and back.
  toWorld(v) {
    return this.rotation.map((row) => dot(row, v));
  }
  toBody(v) {
    return [0, 1, 2].map((j) => dot(this.rotation.map((row) => row[j]), v));
  }

  // In body axes, about the body's own position: the point that lies furthest along a direction of any length above 0.
  localSupportPoint(direction) {
    const [n1, n2] = this.exponents;
    const q = this.semiAxes.map((a, i) => a * direction[i]);
    const largest = Math.max(...q.map(Math.abs));
    const [x, y, z] = q.map((v) => v / largest);
    const ring = normGradient(x, y, n2 / (n2 - 1));
    const whole = normGradient(ring.value, z, n1 / (n1 - 1));
    const gradient = [whole.gradient[0] * ring.gradient[0], whole.gradient[0] * ring.gradient[1], whole.gradient[1]];
    return this.semiAxes.map((a, i) => a * gradient[i]);
  }

  // The same in world axes, where the body is.
  supportPoint(direction) {
    return add(this.position, this.toWorld(this.localSupportPoint(this.toBody(direction))));
  }
}

// math.ldexp of C: 2^e may be out of double's range where the product is not.
function times2(x, e) {
  const half = Math.trunc(e / 2);
  return x * 2 ** half * 2 ** (e - half);
}

const isFinite = (value) =>
  Array.isArray(value) ? value.every(isFinite) : typeof value === 'string' || Number.isFinite(value);

export class Pair {
  #origin;
  #exponent;

  // `bodies`: two of Body; `last`: the answer a step before in the same numbers, or null; `request`: what plumb sent.
  constructor(request) {
    this.request = request;
    const shapes = request.bodies.map((body) => body.shape.superellipsoid);
    this.#origin = request.bodies[0].position;
    this.#exponent = Math.floor(Math.log2(Math.max(...shapes.flatMap((shape) => shape.semi_axes))));
    this.bodies = request.bodies.map(
      (body, i) =>
        new Body(
          shapes[i].semi_axes.map((a) => this.#inwardLength(a)),
          shapes[i].exponents ?? [2, 2],
          this.#inward(body.position),
          unitQuaternion(body.orientation.quaternion_wxyz),
        ),
    );
    this.last = request.last ? this.#inwardAnswer(request.last) : null;
  }

  // The reply in the caller's numbers. status: "converged" unless it says otherwise, verdict: the overlap's, contact_point: between the
  // points; normal: unit, from body 1 to body 2; iterations, evaluations. What is not finite is not known.
  answer({ overlap, normal, points, contact_point, ...others }) {
    const between = contact_point ?? (points && scale(0.5, add(points[0], points[1])));
    const fields = {
      status: 'converged',
      overlap: overlap === undefined ? undefined : times2(overlap, this.#exponent),
      normal: normal && [...normal],
      points: points?.map((point) => this.#outward(point)),
      contact_point: between && this.#outward(between),
      ...others,
    };
    return Object.fromEntries(Object.entries(fields).filter(([, value]) => isFinite(value)));
  }

  #inwardLength(length) {
    return times2(length, -this.#exponent);
  }
  #inward(point) {
    return subtract(point, this.#origin).map((v) => this.#inwardLength(v));
  }
  #inwardAnswer({ overlap, points, contact_point, ...others }) {
    const back = { ...others };
    if (overlap !== undefined) back.overlap = this.#inwardLength(overlap);
    if (points) back.points = points.map((point) => this.#inward(point));
    if (contact_point) back.contact_point = this.#inward(contact_point);
    return back;
  }
  #outward(point) {
    return add(
      this.#origin,
      point.map((v) => times2(v, this.#exponent)),
    );
  }
}

// Answers plumb until plumb ends. `solve` takes a Pair and returns pair.answer(..), or null where it refuses the pair; or a promise of it.
// An error ends the program, with its message last, where plumb looks for it.
export async function serve(solve, abilities) {
  console.log = console.info = console.debug = console.error;
  const say = (message) => process.stdout.write(JSON.stringify(message) + '\n');
  say(abilities);
  try {
    for await (const line of createInterface({ input: process.stdin })) {
      const pair = new Pair(JSON.parse(line));
      const start = performance.now();
      const answer = await solve(pair);
      const ns = Math.round((performance.now() - start) * 1e6);
      say({ number: pair.request.number, ns, ...(answer ?? { refused: true }) });
    }
  } catch (error) {
    console.error(error instanceof Error ? `${error.stack}\n${error}` : error);
    process.exit(1);
  }
}
