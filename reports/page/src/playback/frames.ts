/** A playback unpacked: where everything is at any time. Lengths in units of the scene's size, from its origin. */
import type { Playback } from "../data";
import { floats, indices, PART, parts, WHOLE, wholes } from "./packed";

/** Between two frames: how far from the first, 0..1. */
export interface Moment {
  frame: number;
  part: number;
}

export interface ContactAt {
  first: number;
  second: number;
  /** Read anew by every call. */
  point: Float32Array;
  normal: Float32Array;
  /** Of the largest force of the run. */
  force: number;
}

/** For Frames.contact to fill. */
export const blankContact = (): ContactAt => ({
  first: 0,
  second: 0,
  point: new Float32Array(3),
  normal: new Float32Array(3),
  force: 0,
});

/** The shorter way between two unit quaternions, into `out` at `at`; what it writes has length 1. */
export function slerp(q: Int16Array, from: number, to: number, part: number, out: Float32Array, at: number): void {
  let cosine = 0;
  let [one, two] = [0, 0];
  for (let i = 0; i < 4; i++) {
    const [a, b] = [q[from + i] as number, q[to + i] as number];
    cosine += a * b;
    one += a * a;
    two += b * b;
  }
  cosine /= Math.sqrt(one * two);
  const angle = Math.acos(Math.min(1, Math.abs(cosine)));
  const isSmall = angle < 1e-3;
  const first = isSmall ? 1 - part : Math.sin((1 - part) * angle);
  const second = (cosine < 0 ? -1 : 1) * (isSmall ? part : Math.sin(part * angle));
  let size = 0;
  for (let i = 0; i < 4; i++) {
    const value = first * (q[from + i] as number) + second * (q[to + i] as number);
    out[at + i] = value;
    size += value * value;
  }
  const scale = 1 / Math.sqrt(size || 1);
  for (let i = 0; i < 4; i++) out[at + i] = (out[at + i] as number) * scale;
}

function mix(x: Float32Array, from: number, to: number, part: number, out: Float32Array): void {
  for (let i = 0; i < out.length; i++)
    out[i] = (1 - part) * (x[from * out.length + i] as number) + part * (x[to * out.length + i] as number);
}

/** As mix, of quaternions. */
function turn(q: Int16Array, from: number, to: number, part: number, out: Float32Array): void {
  const wide = out.length;
  for (let i = 0; i < wide; i += 4) slerp(q, from * wide + i, to * wide + i, part, out, i);
}

export class Frames {
  readonly bodies: number;
  readonly count: number;
  readonly times: number[];
  private readonly x: Float32Array;
  private readonly q: Int16Array;
  private readonly walls: Float32Array;
  private readonly wallTurns: Int16Array;
  private readonly boxes: Float32Array;
  private readonly pairs: Uint16Array | Uint32Array;
  private readonly points: Uint16Array;
  private readonly normals: Int16Array;
  private readonly forces: Int16Array;
  /** Of each frame, where its contacts begin. */
  private readonly begins: number[] = [0];

  constructor(playback: Playback) {
    const { contacts } = playback;
    this.bodies = playback.bodies.length;
    this.times = playback.times;
    this.count = playback.times.length;
    this.x = floats(playback.positions);
    this.q = parts(playback.orientations);
    this.walls = floats(playback.wall_points);
    this.wallTurns = parts(playback.wall_orientations);
    this.boxes = floats(contacts.boxes);
    for (const many of contacts.counts) this.begins.push((this.begins.at(-1) as number) + many);
    this.pairs = indices(contacts.pairs, 2 * (this.begins.at(-1) as number));
    this.points = wholes(contacts.points);
    this.normals = parts(contacts.normals);
    this.forces = parts(contacts.forces);
  }

  get first(): number {
    return this.times[0] as number;
  }

  get last(): number {
    return this.times[this.count - 1] as number;
  }

  /** The last frame that is not after `time`. */
  at(time: number): Moment {
    let [low, high] = [0, this.count - 1];
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      if ((this.times[middle] as number) <= time) low = middle;
      else high = middle - 1;
    }
    const begin = this.times[low] as number;
    const long = (this.times[low + 1] ?? begin) - begin;
    return { frame: low, part: long > 0 ? Math.min(1, Math.max(0, (time - begin) / long)) : 0 };
  }

  positions({ frame, part }: Moment, out: Float32Array): void {
    mix(this.x, frame, Math.min(frame + 1, this.count - 1), part, out);
  }

  orientations({ frame, part }: Moment, out: Float32Array): void {
    turn(this.q, frame, Math.min(frame + 1, this.count - 1), part, out);
  }

  wallPoints({ frame, part }: Moment, out: Float32Array): void {
    if (out.length > 0) mix(this.walls, frame, Math.min(frame + 1, this.count - 1), part, out);
  }

  /** Of planes alone there are none. */
  wallOrientations({ frame, part }: Moment, out: Float32Array): void {
    if (this.wallTurns.length > 0) turn(this.wallTurns, frame, Math.min(frame + 1, this.count - 1), part, out);
  }

  /** Positions of all frames, three numbers a body. */
  get path(): Float32Array {
    return this.x;
  }

  contacts(frame: number): number {
    return (this.begins[frame + 1] as number) - (this.begins[frame] as number);
  }

  contact(frame: number, index: number, out: ContactAt): void {
    const at = (this.begins[frame] as number) + index;
    out.first = this.pairs[2 * at] as number;
    out.second = this.pairs[2 * at + 1] as number;
    for (let i = 0; i < 3; i++) {
      const [low, side] = [this.boxes[6 * frame + i] as number, this.boxes[6 * frame + 3 + i] as number];
      out.point[i] = low + (side * (this.points[3 * at + i] as number)) / WHOLE;
      out.normal[i] = (this.normals[3 * at + i] as number) / PART;
    }
    out.force = (this.forces[at] as number) / PART;
  }

  /** Of each body, with how many bodies and walls. */
  contactCounts(frame: number, out: Float32Array): void {
    out.fill(0);
    for (let at = 2 * (this.begins[frame] as number); at < 2 * (this.begins[frame + 1] as number); at++) {
      const body = this.pairs[at] as number;
      if (body < this.bodies) out[body] = (out[body] as number) + 1;
    }
  }

  /** From the frame before to the one after, in units of size by time. */
  speeds(frame: number, out: Float32Array): void {
    const [from, to] = [Math.max(0, frame - 1), Math.min(this.count - 1, frame + 1)];
    const long = (this.times[to] as number) - (this.times[from] as number);
    for (let body = 0; body < this.bodies; body++) {
      const [a, b] = [3 * (from * this.bodies + body), 3 * (to * this.bodies + body)];
      let square = 0;
      for (let i = 0; i < 3; i++) square += ((this.x[b + i] as number) - (this.x[a + i] as number)) ** 2;
      out[body] = long > 0 ? Math.sqrt(square) / long : 0;
    }
  }

  /** Forces of all contacts, of the largest. */
  get allForces(): Int16Array {
    return this.forces;
  }
}

/** The q-th part of the numbers is not above it. */
export function quantile(values: number[], q: number): number {
  if (values.length === 0) return 0;
  const sorted = Float64Array.from(values).sort();
  return sorted[Math.min(sorted.length - 1, Math.floor(q * sorted.length))] as number;
}
