/** Surfaces as triangles, all in float64 and in the axes of the view; three gets what is left as float32. */
import type { Vec } from "../data";
import type { Located, Placed } from "./placed";
import { gauge, loop, quarter } from "./superellipsoid";
import { across, add, cross, dot, scale, subtract, turned, turnedBack, unit } from "./vector";

export interface Mesh {
  positions: Float32Array;
  normals: Float32Array;
  triangles: number[];
  /** Polylines that show the form. */
  lines: Vec[][];
  isPiece: boolean;
}

/** From the world (in units of the pair, from its origin) to the view. */
export interface Mapping {
  point: (x: Vec) => Vec;
  direction: (x: Vec) => Vec;
}

const HALF = 7;

export class Collector {
  private readonly positions: number[] = [];
  private readonly normals: number[] = [];
  readonly triangles: number[] = [];
  constructor(private readonly mapping: Mapping) {}

  add(point: Vec, normal: Vec): void {
    this.positions.push(...this.mapping.point(point));
    this.normals.push(...this.mapping.direction(normal));
  }

  /** A triangle with corners of its own. */
  flat(corners: [Vec, Vec, Vec], normal: Vec): void {
    for (const corner of corners) {
      this.triangles.push(this.triangles.length);
      this.add(corner, normal);
    }
  }

  /** Two triangles a cell of a grid of rows; cells with a vertex that is not are left out. */
  grid(rows: number, columns: number, exists: (index: number) => boolean): void {
    for (let row = 0; row + 1 < rows; row++)
      for (let column = 0; column + 1 < columns; column++) {
        const a = row * columns + column;
        const [b, c, d] = [a + 1, a + columns, a + columns + 1];
        if ([a, b, c, d].every(exists)) this.triangles.push(a, c, b, b, c, d);
      }
  }

  mesh(lines: Vec[][], isPiece: boolean): Mesh {
    const mapped = lines.map((line) => line.map(this.mapping.point));
    return {
      positions: new Float32Array(this.positions),
      normals: new Float32Array(this.normals),
      triangles: this.triangles,
      lines: mapped,
      isPiece,
    };
  }
}

export const inWorld = (body: Located, x: Vec): Vec => add(turned(body.turn, x), body.centre);
const stretched = (body: Placed, [x, y, z]: Vec): Vec => [x * body.axes[0], y * body.axes[1], z * body.axes[2]];

/** The three principal sections. */
function sections(body: Placed): Vec[][] {
  const [n1, n2] = body.exponents;
  const world = (x: Vec) => inWorld(body, stretched(body, x));
  return [
    loop(n2, 12).map(([u, v]) => world([u, v, 0])),
    loop(n1, 12).map(([u, v]) => world([u, 0, v])),
    loop(n1, 12).map(([u, v]) => world([0, u, v])),
  ];
}

/** `half` steps from an axis to the next edge. */
export function wholeMesh(body: Placed, mapping: Mapping, half = HALF): Mesh {
  const [n1, n2] = body.exponents;
  const south = quarter(n1, half);
  const meridian = [...south.map(([r, z]) => [r, -z]).reverse(), ...south.slice(1)] as [number, number][];
  const parallel = loop(n2, half);
  const collector = new Collector(mapping);
  for (const [r, z] of meridian)
    for (const [x, y] of parallel) {
      const point = stretched(body, [r * x, r * y, z]);
      collector.add(inWorld(body, point), turned(body.turn, unit(gauge(body, point).gradient)));
    }
  collector.grid(meridian.length, parallel.length, () => true);
  return collector.mesh(sections(body), false);
}

const RINGS = 16;
const SECTORS = 40;
/** Below this size, in units of the pair, a smooth surface is a plane to all digits. */
const FLAT = 1e-9;

/** How far the surface is from `start` along `n`; NaN where the line misses it. The gauge is convex: Newton from outside is safe. */
function heightAlong(body: Placed, start: Vec, n: Vec): number {
  let height = 0;
  for (let step = 0; step < 60; step++) {
    const { value, gradient } = gauge(body, add(start, scale(n, height)));
    const rate = dot(gradient, n);
    if (!(rate > 0)) return Number.NaN;
    const change = (value - 1) / rate;
    height -= change;
    if (Math.abs(change) <= 1e-15) break;
  }
  return height;
}

/** The surface within `radius` of a point on it, as a disc of rings: for views far smaller than the body. */
export function pieceMesh(body: Placed, anchor: Vec, radius: number, mapping: Mapping): Mesh {
  const local = turnedBack(body.turn, subtract(anchor, body.centre));
  const n = unit(gauge(body, local).gradient);
  const t1 = across(n);
  const t2 = cross(n, t1);
  const points: (Vec | null)[] = [];
  const collector = new Collector(mapping);
  for (let ring = 0; ring <= RINGS; ring++)
    for (let sector = 0; sector <= SECTORS; sector++) {
      const r = radius * (ring / RINGS) ** 1.4;
      const angle = (2 * Math.PI * sector) / SECTORS;
      const offset = add(scale(t1, r * Math.cos(angle)), scale(t2, r * Math.sin(angle)));
      const height = radius < FLAT ? 0 : heightAlong(body, add(local, offset), n);
      const isThere = Math.abs(height) <= 4 * radius;
      const rise = add(offset, scale(n, isThere ? height : 0));
      const normal = radius < FLAT ? n : unit(gauge(body, add(local, rise)).gradient);
      const world = add(anchor, turned(body.turn, rise));
      points.push(isThere ? world : null);
      collector.add(world, turned(body.turn, normal));
    }
  collector.grid(RINGS + 1, SECTORS + 1, (index) => points[index] !== null);
  return collector.mesh(pieceLines(points), true);
}

/** Some rings and spokes, broken where the surface is not there. */
function pieceLines(points: (Vec | null)[]): Vec[][] {
  const at = (ring: number, sector: number) => points[ring * (SECTORS + 1) + sector] ?? null;
  const lines: (Vec | null)[][] = [];
  for (const ring of [6, 11, RINGS]) lines.push(Array.from({ length: SECTORS + 1 }, (_, sector) => at(ring, sector)));
  for (let sector = 0; sector < SECTORS; sector += 5)
    lines.push(Array.from({ length: RINGS + 1 }, (_, ring) => at(ring, sector)));
  return lines.flatMap(unbroken);
}

function unbroken(line: (Vec | null)[]): Vec[][] {
  const parts: Vec[][] = [[]];
  for (const point of line) {
    if (point) parts[parts.length - 1]?.push(point);
    else parts.push([]);
  }
  return parts.filter((part) => part.length > 1);
}
