/** How far a scene reaches, and how large its bodies are: what the view and its walls and arrows are scaled by. */
import type { Playback, Vec } from "../data";
import { middle, scale, subtract } from "../view3d/vector";
import { type Frames, quantile } from "./frames";
import { shapeBoxes } from "./wall_shapes";

export interface Extent {
  centre: Vec;
  /** Half the sides of the box. */
  half: Vec;
  /** The median body's largest semi-axis. */
  body: number;
}

const SAMPLES = 20000;
/** Bodies this much larger than the median are ground rather than grain. */
const GROUND = 4;
/** Walls that make the bodies' box this much larger are cut off by the view. */
const LARGE = 4;

const largestAxis = ({ shapes, bodies, size }: Playback, body: number): number =>
  Math.max(...(shapes[bodies[body] as number]?.semi_axes ?? [0])) / size;

/** A wall across an axis, and not far off, is an end of the box: walls then meet. */
function meetWalls(playback: Playback, frames: Frames, low: Vec, high: Vec): void {
  const points = new Float32Array(3 * playback.walls.length);
  const near = Math.max(...subtract(high, low)) / 2;
  for (const frame of [0, frames.count - 1]) {
    frames.wallPoints({ frame, part: 0 }, points);
    playback.walls.forEach((normal, wall) => {
      const axis = normal.findIndex((part) => Math.abs(part) > 0.9999);
      if (axis < 0) return;
      const place = points[3 * wall + axis];
      if (place === undefined || place < (low[axis] as number) - near || place > (high[axis] as number) + near) return;
      low[axis] = Math.min(low[axis] as number, place);
      high[axis] = Math.max(high[axis] as number, place);
    });
  }
}

/** A wall with a shape is seen as a whole, but for one beside which the bodies would be small. */
function meetShapes(playback: Playback, frames: Frames, low: Vec, high: Vec): void {
  const most = LARGE * Math.max(...subtract(high, low));
  for (const [least, greatest] of shapeBoxes(playback, frames)) {
    const [from, to] = [
      low.map((x, i) => Math.min(x, least[i] as number)),
      high.map((x, i) => Math.max(x, greatest[i] as number)),
    ];
    if (Math.max(...subtract(to as Vec, from as Vec)) > most) continue;
    Object.assign(low, from);
    Object.assign(high, to);
  }
}

/** A body that flew off does not make the others small. */
function reach(values: number[]): [number, number] {
  const [low, high] = [quantile(values, 0.01), quantile(values, 0.99)];
  const slack = high - low;
  const kept = values.filter((x) => x >= low - slack && x <= high + slack);
  return [Math.min(...kept), Math.max(...kept)];
}

export function extentOf(playback: Playback, frames: Frames): Extent {
  const sizes = playback.bodies.map((_, body) => largestAxis(playback, body));
  const body = quantile(sizes, 0.5);
  const grains = sizes.flatMap((size, index) => (size <= GROUND * body ? [index] : []));
  const stride = Math.max(1, Math.ceil((frames.count * grains.length) / SAMPLES));
  const along: [number[], number[], number[]] = [[], [], []];
  for (let frame = frames.count - 1; frame >= 0; frame -= stride)
    for (const grain of grains)
      along.forEach((values, axis) => values.push(frames.path[3 * (frame * frames.bodies + grain) + axis] as number));
  const ends = along.map(reach);
  const pad = Math.max(...grains.map((grain) => sizes[grain] as number));
  const low = ends.map(([least]) => least - pad) as Vec;
  const high = ends.map(([, most]) => most + pad) as Vec;
  meetShapes(playback, frames, low, high);
  meetWalls(playback, frames, low, high);
  return { centre: middle(low, high), half: scale(subtract(high, low), 0.5), body };
}
