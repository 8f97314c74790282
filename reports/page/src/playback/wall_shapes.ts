/** Walls that are no planes, as the playback holds them. */
import type { MeshWall, Playback, Vec, WallShape } from "../data";
import { add, turned, turnOf } from "../view3d/vector";
import type { Frames } from "./frames";
import { floats } from "./packed";

const ROUND = 16;
const SIGNS = [-1, 1] as const;

export const cornersOf = ({ triangles }: MeshWall): Float32Array => floats(triangles);

/** They have neither a normal nor a shape. */
export const undrawnWalls = ({ walls, wall_shapes }: Playback): number =>
  wall_shapes.filter((shape, wall) => shape === null && (walls[wall] as Vec).every((part) => part === 0)).length;

/** Points of its own that it ends at: it reaches no further along any direction, or hardly. */
function ends(shape: WallShape): Vec[] {
  if ("triangles" in shape) {
    const corners = cornersOf(shape);
    return Array.from(
      { length: corners.length / 3 },
      (_, i) => [...corners.subarray(3 * i, 3 * i + 3)] as unknown as Vec,
    );
  }
  if ("half_extents" in shape) {
    const [a, b, c] = shape.half_extents;
    return SIGNS.flatMap((x) => SIGNS.flatMap((y) => SIGNS.map((z): Vec => [x * a, y * b, z * c])));
  }
  return shape.radii.flatMap((radius, end) =>
    Array.from({ length: ROUND }, (_, i): Vec => {
      const angle = (2 * Math.PI * i) / ROUND;
      return [radius * Math.cos(angle), radius * Math.sin(angle), shape.heights[end] as number];
    }),
  );
}

function stretch([low, high]: [Vec, Vec], point: Vec): void {
  point.forEach((x, axis) => {
    low[axis] = Math.min(low[axis] as number, x);
    high[axis] = Math.max(high[axis] as number, x);
  });
}

/** Of each wall that has a shape the least corner and the greatest of the box that holds it at the first frame and at the last. */
export function shapeBoxes({ wall_shapes }: Playback, frames: Frames): [Vec, Vec][] {
  const points = new Float32Array(3 * wall_shapes.length);
  const turns = new Float32Array(4 * wall_shapes.length);
  const own = wall_shapes.map((shape) => (shape ? ends(shape) : []));
  const boxes = own.map((): [Vec, Vec] => [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ]);
  for (const frame of [0, frames.count - 1]) {
    frames.wallPoints({ frame, part: 0 }, points);
    frames.wallOrientations({ frame, part: 0 }, turns);
    own.forEach((all, wall) => {
      const turn = turnOf([...turns.subarray(4 * wall, 4 * wall + 4)] as [number, number, number, number]);
      const at = [...points.subarray(3 * wall, 3 * wall + 3)] as unknown as Vec;
      for (const end of all) stretch(boxes[wall] as [Vec, Vec], add(at, turned(turn, end)));
    });
  }
  return boxes.filter((_, wall) => wall_shapes[wall] !== null);
}
