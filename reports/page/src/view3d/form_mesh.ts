/** The surface of any form, shaded flat: the faces of a hull, or the image of a sphere's mesh under the support map. */
import type { Vec } from "../data";
import { edgesOf, facesOf } from "./corners";
import { Collector, inWorld, type Mapping, type Mesh } from "./mesh";
import type { Formed } from "./placed";
import type { Form } from "./support";
import { add, cross, dot, length, subtract, turned, unit } from "./vector";

type Triangle = [Vec, Vec, Vec];

/** Of the sphere's mesh, from pole to pole and around z: rims about z fall on its lines. */
const ROWS = 48;
const AROUND = 96;
/** Of more corners the faces take too long. */
const MOST_CORNERS = 120;
/** No form is thinner to the grid of directions. */
const THINNEST = 1e-6;

/** Where the form is thin, the direction is nearer to that axis. */
function directionsFor({ stretch }: Form): (u: Vec) => Vec {
  const least = THINNEST * Math.max(...stretch);
  const [x, y, z] = stretch.map((width) => Math.max(width, least) || 1) as Vec;
  return (u) => unit([u[0] / x, u[1] / y, u[2] / z]);
}

/** Flatter triangles have no normal: they are what rims and corners leave of many directions. */
const FLATTEST = 1e-9;

/** On the sphere; the poles are the axis itself. */
function direction(row: number, step: number): Vec {
  const [down, around] = [(Math.PI * row) / ROWS, (2 * Math.PI * step) / AROUND];
  const away = row % ROWS === 0 ? 0 : Math.sin(down);
  return [away * Math.cos(around), away * Math.sin(around), Math.cos(down)];
}

/** Two a cell. */
function sphere(): Triangle[] {
  const cells = [...Array(ROWS * AROUND).keys()].map((cell) => [Math.floor(cell / AROUND), cell % AROUND] as const);
  return cells.flatMap(([row, step]): Triangle[] => {
    const next = (step + 1) % AROUND;
    const [a, b, c, d] = [direction(row, step), direction(row, next), direction(row + 1, step), direction(row + 1, next)]; // prettier-ignore
    return [
      [a, c, b],
      [b, c, d],
    ];
  });
}

/** It looks to where its directions do. */
function outwards([a, b, c]: Triangle, [u, v, w]: Triangle): Triangle {
  const normal = cross(subtract(b, a), subtract(c, a));
  return dot(normal, add(u, add(v, w))) < 0 ? [a, c, b] : [a, b, c];
}

function image(form: Form): Triangle[] {
  const near = directionsFor(form);
  return sphere().map((triangle) => {
    const directions = triangle.map(near) as Triangle;
    return outwards(directions.map(form.support) as Triangle, directions);
  });
}

/** Null of what is flatter than its rounding. */
function normalOf([a, b, c]: Triangle): Vec | null {
  const [ab, ac, bc] = [subtract(b, a), subtract(c, a), subtract(c, b)];
  const normal = cross(ab, ac);
  const longest = Math.max(dot(ab, ab), dot(ac, ac), dot(bc, bc));
  return length(normal) > FLATTEST * longest ? unit(normal) : null;
}

const circle = (point: (x: number, y: number) => Vec): Vec[] =>
  Array.from({ length: AROUND + 1 }, (_, i) => {
    const angle = (2 * Math.PI * (i % AROUND)) / AROUND;
    return point(Math.cos(angle), Math.sin(angle));
  });

/** Where the form is seen to end along each axis, and its sharp rims. */
function roundLines(form: Form): Vec[][] {
  const near = directionsFor(form);
  const outline = (of: (x: number, y: number) => Vec) => circle((x, y) => form.support(near(of(x, y))));
  return [
    outline((x, y) => [x, y, 0]),
    outline((x, y) => [x, 0, y]),
    outline((x, y) => [0, x, y]),
    ...form.rims.map(([radius, z]) => circle((x, y) => [radius * x, radius * y, z])),
  ];
}

/** A fan for each face. */
function fans(corners: Vec[], faces: number[][]): Triangle[] {
  return faces.flatMap((face) => {
    const [first, ...others] = face.map((index) => corners[index] as Vec);
    return others.slice(1).map((corner, i): Triangle => [first as Vec, others[i] as Vec, corner]);
  });
}

function surfaceOf(form: Form): { triangles: Triangle[]; lines: Vec[][] } {
  const { corners } = form;
  if (!corners || corners.length > MOST_CORNERS) return { triangles: image(form), lines: roundLines(form) };
  const faces = facesOf(corners);
  return { triangles: fans(corners, faces), lines: edgesOf(corners, faces) };
}

export function formMesh(body: Formed, mapping: Mapping): Mesh {
  const { triangles, lines } = surfaceOf(body.form);
  const collector = new Collector(mapping);
  for (const triangle of triangles) {
    const normal = normalOf(triangle);
    if (!normal) continue;
    collector.flat(triangle.map((x) => inWorld(body, x)) as Triangle, turned(body.turn, normal));
  }
  return collector.mesh(
    lines.map((line) => line.map((x) => inWorld(body, x))),
    false,
  );
}
