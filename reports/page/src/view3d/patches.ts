/** Patches of contacts for three: their rims, and what is within them. */
import {
  BufferGeometry,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
} from "three";
import type { Vec } from "../data";
import { add, divide } from "./vector";

const geometryOf = (corners: Vec[]): BufferGeometry =>
  new BufferGeometry().setAttribute("position", new Float32BufferAttribute(corners.flat(), 3));

/** The sides of a closed curve. */
const sides = (rim: Vec[]): [Vec, Vec][] => rim.map((point, index) => [point, rim[index + 1] ?? (rim[0] as Vec)]);

/** A triangle from each side to the middle. */
function fan(rim: Vec[]): Vec[] {
  const middle = divide(rim.reduce(add), rim.length);
  return sides(rim).flatMap(([from, to]) => [middle, from, to]);
}

export function patches(rims: Vec[][], colour: string): Group {
  const look = { color: colour, transparent: true, depthWrite: false };
  const area = new Mesh(
    geometryOf(rims.flatMap(fan)),
    new MeshBasicMaterial({ ...look, side: DoubleSide, opacity: 0.35 }),
  );
  const lines = new LineSegments(geometryOf(rims.flatMap(sides).flat()), new LineBasicMaterial(look));
  area.renderOrder = 2;
  lines.renderOrder = 3;
  for (const thing of [area, lines]) thing.frustumCulled = false;
  return new Group().add(area, lines);
}
