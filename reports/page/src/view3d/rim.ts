/** The rim of a contact's patch: the closed curve where the surfaces of both bodies cross (theory.md, "The patch"). */
import type { Vec } from "../data";
import type { Placed } from "./placed";
import { type Gauge, gauge } from "./superellipsoid";
import { across, add, cross, dot, length, scale, subtract, turned, turnedBack } from "./vector";

/** The gauge of what is convex, at a point of the world: 1 on the surface, below 1 inside. */
export type Surface = (x: Vec) => Gauge;

export const surfaceOf =
  (body: Placed): Surface =>
  (x) => {
    const { value, gradient } = gauge(body, turnedBack(body.turn, subtract(x, body.centre)));
    return { value, gradient: turned(body.turn, gradient) };
  };

/** All that is behind a plane. */
export const halfSpace =
  (point: Vec, normal: Vec): Surface =>
  (x) => ({ value: 1 + dot(normal, subtract(x, point)), gradient: normal });

/** Of a half-plane about the normal: away from it, and along it. */
interface RimPoint {
  angle: number;
  away: number;
  along: number;
  at: Vec;
}

const STEPS = 60;
/** In distances from the normal: the longest step, and the last. */
const LONGEST = 0.5;
const CLOSE = 1e-13;
/** What rounding leaves of a gauge. */
const ROUNDING = 1e-15;
/** In units of the larger body: small, and yet not so small that a wide patch is far. */
const FIRST = 0.01;
const COARSE = 16;
const HALVINGS = 6;
/** In chords; of a circle its 25th part. */
const BENT = 0.03;

/** How far a point is from the chord of two others, in chords. */
function bend(from: Vec, point: Vec, to: Vec): number {
  const chord = subtract(to, from);
  return length(cross(subtract(point, from), chord)) / dot(chord, chord);
}

class Rim {
  private readonly across: [Vec, Vec];

  constructor(
    private readonly bodies: [Surface, Surface],
    private readonly origin: Vec,
    private readonly normal: Vec,
  ) {
    const side = across(normal);
    this.across = [side, cross(normal, side)];
  }

  /**
   * Newton on both gauges. They are convex, so that each tangent plane is outside its body and the steps come in from outside; from the
   * middle, where the planes are nearly parallel, they go out. Null where it ends on no crossing of a surface that looks along the
   * normal with one that looks against it.
   */
  private point(angle: number, start: Pick<RimPoint, "away" | "along">): RimPoint | null {
    const out = add(scale(this.across[0], Math.cos(angle)), scale(this.across[1], Math.sin(angle)));
    let { away, along } = start;
    for (let step = 0; step < STEPS; step++) {
      const at = add(this.origin, add(scale(out, away), scale(this.normal, along)));
      const [one, two] = this.bodies.map((body) => body(at)) as [Gauge, Gauge];
      const [a, b] = [dot(one.gradient, out), dot(one.gradient, this.normal)];
      const [c, d] = [dot(two.gradient, out), dot(two.gradient, this.normal)];
      const determinant = a * d - b * c;
      if (!(determinant < 0)) {
        away *= 1 + LONGEST;
        continue;
      }
      const [r1, r2] = [1 - one.value, 1 - two.value];
      const [outwards, upwards] = [(d * r1 - b * r2) / determinant, (a * r2 - c * r1) / determinant];
      const size = Math.hypot(outwards, upwards) / away;
      if (size <= CLOSE || Math.max(Math.abs(r1), Math.abs(r2)) <= ROUNDING)
        return b > 0 && d < 0 ? { angle, away, along, at } : null;
      const part = Math.min(1, LONGEST / size);
      away += part * outwards;
      along += part * upwards;
    }
    return null;
  }

  /** Adds the points from the one up to the other, as close as the curve bends; false where one is missing. */
  private add(from: RimPoint, to: RimPoint, halvings: number, points: Vec[]): boolean {
    const half = this.point((from.angle + to.angle) / 2, from);
    if (!half) return false;
    if (halvings > 0 && bend(from.at, half.at, to.at) > BENT)
      return this.add(from, half, halvings - 1, points) && this.add(half, to, halvings - 1, points);
    points.push(from.at, half.at);
    return true;
  }

  points(): Vec[] | null {
    const coarse: RimPoint[] = [];
    for (let index = 0; index < COARSE; index++) {
      const found = this.point((2 * Math.PI * index) / COARSE, coarse.at(-1) ?? { away: FIRST, along: 0 });
      if (!found) return null;
      coarse.push(found);
    }
    const points: Vec[] = [];
    const next = (index: number): RimPoint => coarse[index] ?? { ...(coarse[0] as RimPoint), angle: 2 * Math.PI };
    return coarse.every((from, index) => this.add(from, next(index + 1), HALVINGS, points)) ? points : null;
  }
}

/**
 * Of two bodies, the normal from the first to the second; `origin`: any point from which the normal's line goes through what they have
 * in common. Null where they have nothing in common, where one is in the other, and where a half-plane about the normal has no crossing.
 */
export const rimOf = (first: Surface, second: Surface, origin: Vec, normal: Vec): Vec[] | null =>
  new Rim([first, second], origin, normal).points();
