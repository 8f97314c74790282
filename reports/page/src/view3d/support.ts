/** Every shape by its support map: the point that is farthest along a direction, in body axes (corpus/formats/case.md, "Shapes"). */
import type { BodyShape, Vec } from "../data";
import { gauge } from "./superellipsoid";
import { add, dot, length, scale } from "./vector";

export interface Form {
  /** Of a unit direction. */
  support: (n: Vec) => Vec;
  /** No point is farther from the origin. */
  reach: number;
  /** How wide the round parts are: where they are thin, directions are to lie closer to each other. */
  stretch: Vec;
  /** Sharp rims about z, radius and height. */
  rims: [number, number][];
  /** Where the form is the hull of these. */
  corners?: Vec[];
}

/** Of each word of a shape that is swept by nothing, its fields. */
interface Numbers {
  superellipsoid: { semi_axes: Vec; exponents?: [number, number] };
  capsule: { half_length: number; radius: number };
  cylinder: { half_length: number; radius: number };
  cone: { radius: number; height: number };
  frustum: { radii: [number, number]; height: number };
  box: { half_extents: Vec };
  polyhedron: { points: Vec[] };
  poly_superellipsoid: { semi_axes: [number, number, number, number, number, number]; exponents?: [number, number] };
  half_space: object;
  tablet: { half_length: number; radius: number; cap_height: number };
}

/** Where a circle about z is farthest. */
function onCircle(radius: number, [x, y]: Vec, z: number): Vec {
  const away = Math.hypot(x, y);
  return away > 0 ? [(radius * x) / away, (radius * y) / away, z] : [0, 0, z];
}

/** The farthest point of the ball of a norm of (x/a, y/b), by Hölder's inequality. */
function reachOfNorm(a: number, b: number, n: number): number {
  const longer = Math.max(a, b);
  const dual = n / (n - 2);
  return n > 2 ? longer * (1 + (Math.min(a, b) / longer) ** (2 * dual)) ** (0.5 / dual) : longer;
}

/** The support is the gradient of the dual gauge: axes 1/a, exponents n/(n - 1). */
function norms(axesAlong: (n: Vec) => Vec, [n1, n2]: [number, number], stretch: Vec): Form {
  const exponents: [number, number] = [n1 / (n1 - 1), n2 / (n2 - 1)];
  const support = (n: Vec): Vec => {
    const [a, b, c] = axesAlong(n);
    return gauge({ axes: [1 / a, 1 / b, 1 / c], exponents }, n).gradient;
  };
  const reach = reachOfNorm(reachOfNorm(stretch[0], stretch[1], n2), stretch[2], n1);
  return { support, reach, stretch, rims: [] };
}

function superellipsoid({ semi_axes, exponents }: Numbers["superellipsoid"]): Form {
  return norms(() => semi_axes, exponents ?? [2, 2], semi_axes);
}

/** The half-axes of the octant that the direction points to. */
function polySuperellipsoid({ semi_axes, exponents }: Numbers["poly_superellipsoid"]): Form {
  const [x, left, y, front, z, below] = semi_axes;
  const octant = (n: Vec): Vec => [n[0] < 0 ? left : x, n[1] < 0 ? front : y, n[2] < 0 ? below : z];
  return norms(octant, exponents ?? [2, 2], [Math.max(x, left), Math.max(y, front), Math.max(z, below)]);
}

function capsule({ half_length, radius }: Numbers["capsule"]): Form {
  const support = (n: Vec): Vec => add([0, 0, half_length * Math.sign(n[2])], scale(n, radius));
  return { support, reach: half_length + radius, stretch: [1, 1, 1], rims: [] };
}

function cylinder({ half_length, radius }: Numbers["cylinder"]): Form {
  const support = (n: Vec): Vec => onCircle(radius, n, half_length * Math.sign(n[2]));
  const rims: Form["rims"] = [-half_length, half_length].map((z) => [radius, z]);
  return { support, reach: Math.hypot(half_length, radius), stretch: [1, 1, 1], rims };
}

/** How far the bottom is below the centroid. */
function depthOfBottom([bottom, top]: [number, number], height: number): number {
  const larger = Math.max(bottom, top);
  const [p, q] = [bottom / larger, top / larger];
  return ((height / 4) * (p * p + 2 * p * q + 3 * q * q)) / (p * p + p * q + q * q);
}

function frustum({ radii, height }: Numbers["frustum"]): Form {
  const [bottom, top] = radii;
  const low = -depthOfBottom(radii, height);
  const high = low + height;
  const support = (n: Vec): Vec => {
    const isTop = (top - bottom) * Math.hypot(n[0], n[1]) + height * n[2] > 0;
    return isTop ? onCircle(top, n, high) : onCircle(bottom, n, low);
  };
  const wide = Math.max(bottom, top);
  const reach = Math.max(Math.hypot(bottom, low), Math.hypot(top, high));
  const ends: Form["rims"] = [[bottom, low], [top, high]]; // prettier-ignore
  return { support, reach, stretch: [wide, wide, height], rims: ends.filter(([radius]) => radius > 0) };
}

const cone = ({ radius, height }: Numbers["cone"]): Form => frustum({ radii: [radius, 0], height });

/** A cap is a sphere's, up to where its normal is steeper than at the rim. */
function tablet({ half_length, radius, cap_height }: Numbers["tablet"]): Form {
  const sphere = radius * (radius / (2 * cap_height)) + cap_height / 2;
  const support = (n: Vec): Vec => {
    const side = Math.sign(n[2]);
    if (sphere * Math.hypot(n[0], n[1]) >= radius) return onCircle(radius, n, side * half_length);
    return add([0, 0, side * (half_length + cap_height - sphere)], scale(n, sphere));
  };
  const reach = Math.max(Math.hypot(half_length, radius), half_length + cap_height);
  const rims: Form["rims"] = [-half_length, half_length].map((z) => [radius, z]);
  return { support, reach, stretch: [radius, radius, cap_height], rims };
}

const widest = (corners: Vec[], axis: number): number =>
  Math.max(...corners.map((corner) => Math.abs(corner[axis] ?? 0)));

function hull(corners: Vec[]): Form {
  const support = (n: Vec): Vec => corners.reduce((best, corner) => (dot(corner, n) > dot(best, n) ? corner : best));
  const stretch: Vec = [widest(corners, 0), widest(corners, 1), widest(corners, 2)];
  return { support, reach: Math.max(...corners.map(length)), stretch, rims: [], corners };
}

const SIGNS = [-1, 1];

function box({ half_extents: [x, y, z] }: Numbers["box"]): Form {
  return hull(SIGNS.flatMap((i) => SIGNS.flatMap((j) => SIGNS.map((k): Vec => [i * x, j * y, k * z]))));
}

/** Half a side of what is drawn of a plane, in units of the other body. */
const PLANE = 1.3;

/** A square about its position: no direction but z has a farthest point. */
const halfSpace = (): Form => ({
  ...hull(SIGNS.flatMap((i) => SIGNS.map((j): Vec => [i * PLANE, j * PLANE, 0]))),
  reach: 0,
});

const FORMS: { [Word in keyof Numbers]: (numbers: Numbers[Word]) => Form } = {
  superellipsoid,
  capsule,
  cylinder,
  cone,
  frustum,
  box,
  polyhedron: ({ points }) => hull(points),
  poly_superellipsoid: polySuperellipsoid,
  half_space: halfSpace,
  tablet,
};

/** All lengths of a shape in units of a size. */
function inUnits<Part>(part: Part, size: number): Part {
  if (typeof part === "number") return (part / size) as Part;
  if (Array.isArray(part)) return part.map((one) => inUnits(one, size)) as Part;
  const fields = Object.entries(part as object);
  return Object.fromEntries(
    fields.map(([name, value]) => [name, name === "exponents" ? value : inUnits(value, size)]),
  ) as Part;
}

/** A shape that is swept by nothing. */
type Core = { [Word in keyof Numbers]: Record<Word, Numbers[Word]> }[keyof Numbers];

/** One sweep for several. */
export function sweptOf(shape: BodyShape): { core: Core; radius: number } {
  const sweep = shape.sphere_swept as { core: BodyShape; radius: number } | undefined;
  if (!sweep) return { core: shape as unknown as Core, radius: 0 };
  const { core, radius } = sweptOf(sweep.core);
  return { core, radius: radius + sweep.radius };
}

/** All within a radius of a form: r n beyond its farthest point, and nothing sharp. */
function swept({ support, reach, stretch }: Form, radius: number): Form {
  const wider = add(stretch, [radius, radius, radius]);
  return { support: (n) => add(support(n), scale(n, radius)), reach: reach + radius, stretch: wider, rims: [] };
}

/** In units of a size. */
export function formOf(shape: BodyShape, size: number): Form {
  const { core, radius } = sweptOf(shape);
  const [[word, numbers]] = Object.entries(inUnits(core, size)) as [[keyof Numbers, never]];
  const form = FORMS[word](numbers);
  return radius > 0 ? swept(form, radius / size) : form;
}

/** That is swept by nothing. */
export const superellipsoidOf = (shape: BodyShape) => shape.superellipsoid as Numbers["superellipsoid"] | undefined;

/** The larger body's is the picture's unit: the largest semi-axis, of others the reach. */
export function sizeOf(shape: BodyShape): number {
  const own = superellipsoidOf(shape);
  return own ? Math.max(...own.semi_axes) : formOf(shape, 1).reach;
}
