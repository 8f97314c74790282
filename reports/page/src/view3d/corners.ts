/** The faces and edges of a hull of few corners, by looking at each plane through three of them. */
import type { Vec } from "../data";
import { across, add, cross, divide, dot, length, subtract, unit } from "./vector";

/** In widths of the hull: what is as close to a plane lies on it, and three as close to a line say nothing. */
const ON_PLANE = 1e-7;

/** Each axis by its width, so that thin hulls are as others: that changes no face. */
function inUnitBox(corners: Vec[]): Vec[] {
  const widths = [0, 1, 2].map((axis) => {
    const along = corners.map((corner) => corner[axis] as number);
    return Math.max(...along) - Math.min(...along) || 1;
  }) as Vec;
  return corners.map(([x, y, z]) => [x / widths[0], y / widths[1], z / widths[2]]);
}

/** The normal of the plane through three, outwards; null where it cuts the hull. */
function outwards(corners: Vec[], a: Vec, b: Vec, c: Vec): Vec | null {
  const normal = cross(subtract(b, a), subtract(c, a));
  if (length(normal) < ON_PLANE) return null;
  const n = unit(normal);
  let side = 0;
  for (const corner of corners) {
    const height = dot(n, subtract(corner, a));
    if (Math.abs(height) <= ON_PLANE) continue;
    if (side * height < 0) return null;
    side = Math.sign(height);
  }
  return side > 0 ? [-n[0], -n[1], -n[2]] : n;
}

/** Anticlockwise, seen from outside. */
function inTurn(corners: Vec[], members: number[], n: Vec): number[] {
  const at = (index: number) => corners[index] as Vec;
  const middle = divide(members.map(at).reduce(add), members.length);
  const u = across(n);
  const v = cross(n, u);
  const angle = (index: number): number => {
    const from = subtract(at(index), middle);
    return Math.atan2(dot(from, v), dot(from, u));
  };
  return [...members].sort((i, j) => angle(i) - angle(j));
}

/** Of each face the indices of its corners, in turn. */
export function facesOf(given: Vec[]): number[][] {
  const corners = inUnitBox(given);
  const faces = new Map<string, number[]>();
  corners.forEach((a, i) =>
    corners.slice(i + 1).forEach((b, j) =>
      corners.slice(i + j + 2).forEach((c) => {
        const n = outwards(corners, a, b, c);
        if (!n) return;
        const members = [...corners.keys()].filter((k) => Math.abs(dot(n, subtract(corners[k] as Vec, a))) <= ON_PLANE);
        const name = members.join();
        if (!faces.has(name)) faces.set(name, inTurn(corners, members, n));
      }),
    ),
  );
  return [...faces.values()];
}

/** Each once; of two corners the line between them. */
export function edgesOf(corners: Vec[], faces: number[][]): [Vec, Vec][] {
  if (corners.length === 2) return [corners as [Vec, Vec]];
  const pairs = faces.flatMap((face) =>
    face.map((i, at): [number, number] => [i, face[(at + 1) % face.length] as number]),
  );
  const once = new Map(pairs.map(([i, j]) => [`${Math.min(i, j)} ${Math.max(i, j)}`, [i, j] as const]));
  return [...once.values()].map(([i, j]) => [corners[i] as Vec, corners[j] as Vec]);
}
