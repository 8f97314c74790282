/** A failure's geometry in float64, in units of its larger body and from its own contact: sizes of 1e-300 and places of 1e6 alike. */
import type { Answer, Body, Failure, Vec } from "../data";
import { rimOf, surfaceOf } from "./rim";
import { gauge, type Shape } from "./superellipsoid";
import { type Form, formOf, sizeOf, superellipsoidOf, sweptOf } from "./support";
import {
  add,
  divide,
  dot,
  isFinite3,
  length,
  middle,
  scale,
  subtract,
  type Turn,
  turned,
  turnedBack,
  turnOf,
  unit,
} from "./vector";

export interface Located {
  turn: Turn;
  centre: Vec;
}

/** A superellipsoid: it has a gauge. */
export interface Placed extends Shape, Located {}

/** Any other shape: it has a support map alone. */
export interface Formed extends Located {
  form: Form;
}

export type Drawn = Placed | Formed;
export const hasGauge = (body: Drawn): body is Placed => "axes" in body;

export interface Contact {
  points: [Vec, Vec];
  normals: [Vec, Vec] | null;
}

export interface Geometry {
  bodies: [Drawn, Drawn];
  answer: Contact | null;
  reference: Contact | null;
  /** From body 1 to body 2: the reference's, or the answer's, or the centres'. */
  normal: Vec;
  /** What the answer says is the normal. */
  given: Vec | null;
  /** Where both surfaces cross; closed. Of superellipsoids alone. */
  rim: Vec[] | null;
  /** The case's length of 1. */
  size: number;
}

export type Zoom = "bodies" | "patch" | "points" | "overlap";

/** What is to be seen: a ball, in the geometry's units. */
export interface Focus {
  centre: Vec;
  radius: number;
}

const isHalfSpace = ({ shape }: Body): boolean => "half_space" in sweptOf(shape).core;

/** What is drawn of a half-space is about the origin, on its plane. */
function halfSpace(body: Body, { turn, centre }: Located, size: number): Formed {
  const { core, radius } = sweptOf(body.shape);
  const normal = turned(turn, [0, 0, 1]);
  const height = dot(normal, centre) + radius / size;
  return { form: formOf(core, size), turn, centre: scale(normal, height) };
}

function placed(body: Body, origin: Vec, size: number): Drawn {
  const located = {
    turn: turnOf(body.orientation.quaternion_wxyz),
    centre: divide(subtract(body.position, origin), size),
  };
  const { shape } = body;
  if (isHalfSpace(body)) return halfSpace(body, located, size);
  const own = superellipsoidOf(shape);
  if (!own) return { form: formOf(shape, size), ...located };
  const { semi_axes, exponents } = own;
  return { axes: divide(semi_axes, size), exponents: exponents ?? [2, 2], ...located };
}

function contact(answer: Answer | null, origin: Vec, size: number): Contact | null {
  const [p, q] = answer?.points ?? [null, null];
  if (!isFinite3(p) || !isFinite3(q)) return null;
  const [n, m] = answer?.normals ?? [null, null];
  const at = (x: Vec): Vec => divide(subtract(x, origin), size);
  return { points: [at(p), at(q)], normals: isFinite3(n) && isFinite3(m) ? [unit(n), unit(m)] : null };
}

/** What a picture is made of. */
export type Shown = Pick<Failure, "case" | "answer" | "reference">;

function originOf({ answer, reference, case: { bodies } }: Shown): Vec {
  for (const one of [reference, answer]) {
    const [p, q] = one?.points ?? [null, null];
    if (isFinite3(p) && isFinite3(q)) return middle(p, q);
  }
  return (isHalfSpace(bodies[0]) ? bodies[1] : bodies[0]).position;
}

function rimBetween([first, second]: [Drawn, Drawn], normal: Vec): Vec[] | null {
  if (!hasGauge(first) || !hasGauge(second)) return null;
  return rimOf(surfaceOf(first), surfaceOf(second), [0, 0, 0], normal);
}

export function geometryOf(failure: Shown): Geometry {
  const [first, second] = failure.case.bodies;
  const size = Math.max(sizeOf(first.shape), sizeOf(second.shape)) || 1;
  const origin = originOf(failure);
  const bodies: [Drawn, Drawn] = [placed(first, origin, size), placed(second, origin, size)];
  const known = [failure.reference?.normal, failure.answer?.normal].find((n) => isFinite3(n));
  const normal = unit(known ?? subtract(bodies[1].centre, bodies[0].centre));
  return {
    bodies,
    answer: contact(failure.answer, origin, size),
    reference: contact(failure.reference, origin, size),
    normal,
    given: isFinite3(failure.answer?.normal) ? unit(failure.answer.normal) : null,
    rim: rimBetween(bodies, normal),
    size,
  };
}

/** No view is smaller, in units of the larger body: doubles end there. */
const LEAST = 1e-12;

/** In units of how far they reach: around two points and their arrows, around a rim. */
const ROOM = 2.5;
const RIM_ROOM = 1.6;

function aroundPoints(points: Vec[], room: number): Focus {
  const centre = divide(points.reduce(add), points.length);
  const radius = Math.max(...points.map((point) => length(subtract(point, centre))));
  return { centre, radius: Math.max(LEAST, room * radius) };
}

/** Of an arrow, in radii of what is seen; and with its name. */
export const ARROW = 0.62;
const NAMED_ARROW = 0.66;
/** Further from the middle, in radii, nothing is surely seen. */
const SEEN = 0.95;
/** A superellipsoid's box reaches further than it. */
const BALL = 0.65;
/** About its centre, with all of the body in it, as far as that is seen. */
const ballOf = (body: Drawn, corner: Vec): number =>
  hasGauge(body) ? BALL * length(corner) : Math.min(length(corner), body.form.reach || Number.POSITIVE_INFINITY);

/** Arrows grow with the radius that makes room for them: by then it hardly changes. */
const ROUNDS = 10;

/** Where arrows begin, and their directions. */
function arrowsOf({ answer, reference, normal, given }: Geometry, plain: boolean): [Vec, Vec][] {
  const right = reference ? [normal, ...(plain && given ? [given] : [])] : [];
  const arrows = right.map((direction): [Vec, Vec] => [reference?.points[0] ?? [0, 0, 0], direction]);
  const { points, normals } = answer ?? {};
  if (plain || !points) return arrows;
  if (!normals) return given ? [...arrows, [points[0], given]] : arrows;
  return [...arrows, [points[0], normals[0]], [points[1], normals[1]]];
}

/** The bodies' box with those points, and all of it seen. */
export function around(bodies: Drawn[], tips: Vec[]): Focus {
  const ends = (sign: 1 | -1) =>
    [0, 1, 2].map((i) => [
      ...bodies.map((body) => (body.centre[i] as number) + sign * reach(body, i)),
      ...tips.map((tip) => tip[i] as number),
    ]);
  const low = ends(-1).map((all) => Math.min(...all)) as Vec;
  const high = ends(1).map((all) => Math.max(...all)) as Vec;
  const centre = middle(low, high);
  const corners = bodies.map((body) => [0, 1, 2].map((i) => reach(body, i)) as Vec);
  const furthest = [
    ...bodies.map((body, k) => length(subtract(body.centre, centre)) + ballOf(body, corners[k] as Vec)),
    ...tips.map((tip) => length(subtract(tip, centre))),
  ];
  return { centre, radius: Math.max(...furthest) / SEEN };
}

function aroundBodies(geometry: Geometry, plain: boolean): Focus {
  const arrows = arrowsOf(geometry, plain);
  let focus = around(geometry.bodies, []);
  for (let round = 0; round < ROUNDS && arrows.length > 0; ++round) {
    const size = NAMED_ARROW * focus.radius;
    focus = around(
      geometry.bodies,
      arrows.map(([from, direction]) => add(from, scale(direction, size))),
    );
  }
  return focus;
}

/** Half the extent of the body's box along a world axis. */
function reach(body: Drawn, axis: number): number {
  const row = body.turn[axis] as Vec;
  if (!hasGauge(body)) {
    const { support } = body.form;
    const back = scale(row, -1);
    return Math.max(dot(row, support(row)), dot(back, support(back)));
  }
  return Math.hypot(row[0] * body.axes[0], row[1] * body.axes[1], row[2] * body.axes[2]);
}

/** Null where there is nothing to zoom to. */
export function focusOf(geometry: Geometry, zoom: Zoom, plain = false): Focus | null {
  if (zoom === "bodies") return aroundBodies(geometry, plain);
  const { answer, reference, rim } = geometry;
  if (zoom === "patch") return rim && aroundPoints(rim, RIM_ROOM);
  const both = [...(answer?.points ?? []), ...(reference?.points ?? [])];
  const narrow = reference?.points ?? answer?.points ?? [];
  const points = zoom === "points" ? both : [...narrow];
  return points.length > 0 ? aroundPoints(points, ROOM) : null;
}

/** The surface point of a body that a small view is centred on. */
export function anchorOf({ reference, answer }: Geometry, body: Placed, index: 0 | 1, focus: Focus): Vec {
  const near = [reference, answer]
    .map((one) => one?.points[index])
    .find((point) => point && length(subtract(point, focus.centre)) <= 2 * focus.radius);
  const point = near ?? focus.centre;
  const local = turnedBack(body.turn, subtract(point, body.centre));
  const { value } = gauge(body, local);
  if (near && Math.abs(value - 1) < 1e-9) return near;
  return value > 0 ? add(body.centre, turned(body.turn, scale(local, 1 / value))) : point;
}
