/** The surface of a wall that is no plane, and the lines that show it, in the wall's own axes. */
import { BoxGeometry, BufferAttribute, BufferGeometry, EdgesGeometry, LatheGeometry, Vector2, Vector3 } from "three";
import type { RoundWall, Vec, WallShape } from "../data";
import { cornersOf } from "../playback/wall_shapes";

/** Around the axis; what is between two of them bends less than an edge. */
const AROUND = 96;
/** Degrees between triangles from which on there is an edge. */
const EDGE = 5;
/** Lines along a round wall: they show that it turns. */
const ALONG = 8;

/** A line that is turned about the axis: distance from it, and height. */
function profile({ radii, heights, closed }: RoundWall): [number, number][] {
  const line = radii.map((radius, end): [number, number] => [radius, heights[end] as number]);
  if (closed[0]) line.unshift([0, heights[0]]);
  if (closed[1]) line.push([0, heights[1]]);
  return line;
}

function triangles(corners: Float32Array): BufferGeometry {
  return new BufferGeometry().setAttribute("position", new BufferAttribute(corners, 3));
}

/** three turns about y. */
function round(wall: RoundWall): BufferGeometry {
  const points = profile(wall).map(([r, z]) => new Vector2(r, z));
  return new LatheGeometry(points, AROUND).rotateX(Math.PI / 2);
}

export function surfaceOf(shape: WallShape): BufferGeometry {
  if ("triangles" in shape) return triangles(cornersOf(shape));
  if ("half_extents" in shape) return new BoxGeometry(...(shape.half_extents.map((x) => 2 * x) as Vec));
  return round(shape);
}

function linesAlong({ radii, heights }: RoundWall): Vector3[] {
  return Array.from({ length: ALONG }, (_, i) => (2 * Math.PI * i) / ALONG).flatMap((angle) =>
    radii.map((r, end) => new Vector3(r * Math.cos(angle), r * Math.sin(angle), heights[end])),
  );
}

/** Two points a line. */
export function linesOf(shape: WallShape, surface: BufferGeometry): BufferGeometry {
  const edges = new EdgesGeometry(surface, EDGE);
  if (!("radii" in shape)) return edges;
  const ends = edges.getAttribute("position");
  const points = Array.from({ length: ends.count }, (_, i) => new Vector3().fromBufferAttribute(ends, i));
  return new BufferGeometry().setFromPoints([...points, ...linesAlong(shape)]);
}
