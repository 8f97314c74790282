/** The view's things for three: bodies translucent, points and arrows in them; a ball of radius 1 is what is to be seen. */
import {
  AmbientLight,
  BackSide,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  DirectionalLight,
  DoubleSide,
  FrontSide,
  Group,
  InstancedMesh,
  Line,
  LineBasicMaterial,
  LineDashedMaterial,
  type Material,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  type Object3D,
  OctahedronGeometry,
  Quaternion,
  Scene,
  SphereGeometry,
  Vector3,
} from "three";
import type { Vec } from "../data";
import { number } from "../numbers";
import type { Theme } from "../theme";
import { formMesh } from "./form_mesh";
import { type Mapping, pieceMesh, type Mesh as Surface, wholeMesh } from "./mesh";
import { patches } from "./patches";
import {
  ARROW,
  anchorOf,
  type Contact,
  type Drawn,
  type Focus,
  focusOf,
  type Geometry,
  hasGauge,
  type Zoom,
} from "./placed";
import { across, add, cross, divide, dot, length, scale, subtract, type Turn, turned, unit } from "./vector";

export interface Label {
  text: string;
  at: Vec;
  colour: string;
  /** Which side of its point it stands on. */
  side: "left" | "right";
}

export interface Pictured {
  scene: Scene;
  labels: Label[];
  /** Half the width of what is seen, in the case's unit. */
  radius: number;
}

export interface Colours {
  first: string;
  second: string;
  reference: string;
  link: string;
  wrong: string;
  patch: string;
}

export const COLOURS: Record<Theme, Colours> = {
  light: {
    first: "#0067a5",
    second: "#b84300",
    reference: "#00734f",
    link: "#1c2127",
    wrong: "#b8006e",
    patch: "#6a3d9a",
  },
  dark: {
    first: "#63b8f7",
    second: "#ff9a5c",
    reference: "#3ed3a4",
    link: "#f2f4f6",
    wrong: "#ff7cc4",
    patch: "#c3a3f0",
  },
};

/** Shorter than this, a link is drawn by its direction only. */
const VISIBLE = 0.07;
/** A patch that reaches further from the middle is not drawn. */
const SEEN = 1.2;
/** Views below this part of a body's least axis show a piece of it. */
const CLOSE = 0.5;

/** The reference's normal goes up, and what the answer's normals miss it by lies in the picture. */
function viewTurn({ normal, answer, given }: Geometry, plain: boolean): Turn {
  const missed = plain ? given : answer?.normals?.[0];
  const aside = missed ? subtract(missed, scale(normal, dot(missed, normal))) : null;
  const side = aside && length(aside) > 1e-9 ? unit(aside) : across(normal);
  return [side, normal, cross(side, normal)];
}

function mappingOf(geometry: Geometry, focus: Focus, plain: boolean): Mapping {
  const turn = viewTurn(geometry, plain);
  return {
    point: (x) => turned(turn, divide(subtract(x, focus.centre), focus.radius)),
    direction: (x) => turned(turn, x),
  };
}

/** Smaller views show no form: it is drawn whole, and float32 moves its faces. */
const FINEST = 1e-5;

/** Null where nothing of it is drawn. */
function surface(geometry: Geometry, body: Drawn, index: 0 | 1, focus: Focus, mapping: Mapping): Surface | null {
  if (!hasGauge(body)) return focus.radius < FINEST ? null : formMesh(body, mapping);
  if (focus.radius >= CLOSE * Math.min(...body.axes)) return wholeMesh(body, mapping);
  return pieceMesh(body, anchorOf(geometry, body, index, focus), 1.5 * focus.radius, mapping);
}

function skin(
  geometry: BufferGeometry,
  colour: string,
  side: typeof FrontSide | typeof BackSide,
  opacity: number,
): Mesh {
  const material = new MeshLambertMaterial({ color: colour, transparent: true, opacity, side, depthWrite: false });
  const mesh = new Mesh(geometry, material);
  mesh.renderOrder = side === BackSide ? 0 : 1;
  return mesh;
}

export function surfaceGeometry({ positions, normals, triangles }: Surface): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  geometry.setIndex(triangles);
  return geometry;
}

export function bodyGroup(surface: Surface, colour: string, dashed: boolean): Group {
  const group = new Group();
  const geometry = surfaceGeometry(surface);
  group.add(skin(geometry, colour, BackSide, 0.16), skin(geometry, colour, FrontSide, 0.22));
  const look = { color: colour, transparent: true, opacity: 0.75 };
  const material = dashed
    ? new LineDashedMaterial({ ...look, dashSize: 0.05, gapSize: 0.035 })
    : new LineBasicMaterial(look);
  for (const points of surface.lines) {
    const line = new Line(new BufferGeometry().setFromPoints(points.map((point) => new Vector3(...point))), material);
    line.renderOrder = 2;
    group.add(line.computeLineDistances());
  }
  return group;
}

function solid(geometry: BufferGeometry, colour: string): Mesh {
  const material = new MeshBasicMaterial({ color: colour, side: DoubleSide, transparent: true });
  const mesh = new Mesh(geometry, material);
  mesh.renderOrder = 3;
  return mesh;
}

export function arrow(from: Vec, direction: Vec, size: number, colour: string, thickness = 0.011): Group {
  const group = new Group();
  const head = Math.min(0.12, 0.45 * size);
  const shaft = solid(new CylinderGeometry(thickness, thickness, size - head, 10), colour);
  shaft.position.y = (size - head) / 2;
  const tip = solid(new ConeGeometry(head * 0.32, head, 14), colour);
  tip.position.y = size - head / 2;
  group.add(shaft, tip);
  group.position.set(...from);
  group.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), new Vector3(...direction)));
  return group;
}

const degreesBetween = (a: Vec, b: Vec): number => (Math.atan2(length(cross(a, b)), dot(a, b)) * 180) / Math.PI;

export const marker = (geometry: BufferGeometry, at: Vec, colour: string): Mesh => {
  const mesh = solid(geometry, colour);
  mesh.position.set(...at);
  return mesh;
};

export function litScene(): Scene {
  const sun = new DirectionalLight("#ffffff", 1.6);
  sun.position.set(-1, 2, 3);
  return new Scene().add(new AmbientLight("#ffffff", 1.7), sun);
}

class Drawing {
  readonly scene = litScene();
  readonly labels: Label[] = [];
  constructor(
    private readonly mapping: Mapping,
    private readonly colours: Colours,
  ) {}

  private note(text: string, at: Vec, colour: string): void {
    this.labels.push({ text, at, colour, side: colour === this.colours.first ? "left" : "right" });
  }

  body(shape: Surface, index: 0 | 1): void {
    this.scene.add(bodyGroup(shape, index === 0 ? this.colours.first : this.colours.second, index === 1));
  }

  /** At the centre where that is seen, else on the piece. */
  bodyLabel(body: Drawn, index: 0 | 1, { positions, isPiece }: Surface): void {
    const { first, second } = this.colours;
    const middle: Vec = [positions[0] ?? 0, positions[1] ?? 0, positions[2] ?? 0];
    const at = isPiece ? add(middle, [index === 0 ? -0.5 : 0.5, 0, 0.3]) : this.mapping.point(body.centre);
    if (length(at) < 1.2) this.note(index === 0 ? "body 1" : "body 2", at, index === 0 ? first : second);
  }

  private direction(name: string, from: Vec, towards: Vec, colour: string, thickness?: number): void {
    const direction = this.mapping.direction(towards);
    this.scene.add(arrow(from, direction, ARROW, colour, thickness));
    this.note(name, add(from, scale(direction, ARROW + 0.05)), colour);
  }

  /** `given`: the normal of an answer whose surfaces have none of their own. */
  answer({ points, normals }: Contact, given: Vec | null): void {
    const { first, second } = this.colours;
    const [p1, p2] = points.map(this.mapping.point) as [Vec, Vec];
    this.scene.add(marker(new SphereGeometry(0.034, 16, 12), p1, first));
    this.scene.add(marker(new BoxGeometry(0.055, 0.055, 0.055), p2, second));
    if (normals) {
      this.direction("n1", p1, normals[0], first);
      this.direction("n2", p2, normals[1], second);
    } else if (given) {
      this.direction("normal", p1, given, first);
    }
    this.note("p1", p1, first);
    this.note("p2", p2, second);
    this.link(p1, p2);
  }

  private link(p1: Vec, p2: Vec): void {
    const d = subtract(p2, p1);
    const size = length(d);
    if (size === 0) return;
    const isLong = size >= VISIBLE;
    this.scene.add(arrow(p1, unit(d), isLong ? size : 0.4, this.colours.link, isLong ? 0.009 : 0.006));
    const at = isLong ? add(p1, scale(d, 0.5)) : add(p1, scale(unit(d), 0.44));
    this.note(isLong ? "d" : "d (direction)", at, this.colours.link);
  }

  reference({ points }: Contact, normal: Vec): void {
    const { reference } = this.colours;
    const [r1, r2] = points.map(this.mapping.point) as [Vec, Vec];
    for (const at of [r1, r2]) this.scene.add(marker(new OctahedronGeometry(0.036), at, reference));
    this.direction("reference", r1, normal, reference);
  }

  /** Where all of it is seen. */
  patch(rim: Vec[]): void {
    const seen = rim.map(this.mapping.point);
    const furthest = Math.max(...seen.map(length));
    if (furthest > SEEN) return;
    this.scene.add(patches([seen], this.colours.patch));
    const first = seen[0] as Vec;
    if (length(subtract(first, seen[seen.length / 2] as Vec)) > VISIBLE) this.note("patch", first, this.colours.patch);
  }

  /** The right normal and the one that was given, both from the right contact so that the angle between them is seen. */
  normals({ points }: Contact, right: Vec, given: Vec, angle: string): void {
    const { reference, wrong } = this.colours;
    const from = this.mapping.point(points[0]);
    this.scene.add(marker(new SphereGeometry(0.03, 16, 12), from, this.colours.link));
    this.direction("right normal", from, right, reference, 0.02);
    this.direction(`given: ${angle} off`, from, given, wrong, 0.02);
  }
}

/** `plain`: for who has not read what p1, n1 and d are: the two normals alone. */
export function picture(geometry: Geometry, zoom: Zoom, theme: Theme, plain = false): Pictured | null {
  const focus = focusOf(geometry, zoom, plain);
  if (!focus || !(focus.radius > 0) || !Number.isFinite(focus.radius)) return null;
  const mapping = mappingOf(geometry, focus, plain);
  const drawing = new Drawing(mapping, COLOURS[theme]);
  const bodyNotes: (() => void)[] = [];
  for (const index of [0, 1] as const) {
    const body = geometry.bodies[index];
    const shape = surface(geometry, body, index, focus, mapping);
    if (!shape) continue;
    drawing.body(shape, index);
    bodyNotes.push(() => drawing.bodyLabel(body, index, shape));
  }
  if (plain) {
    const { reference, normal, given } = geometry;
    if (reference && given) drawing.normals(reference, normal, given, `${number(degreesBetween(normal, given), 2)}°`);
    return { scene: drawing.scene, labels: drawing.labels, radius: focus.radius * geometry.size };
  }
  if (geometry.reference) drawing.reference(geometry.reference, geometry.normal);
  if (geometry.answer) drawing.answer(geometry.answer, geometry.given);
  if (geometry.rim) drawing.patch(geometry.rim);
  for (const note of bodyNotes) note();
  return { scene: drawing.scene, labels: drawing.labels, radius: focus.radius * geometry.size };
}

export function dispose(root: Object3D): void {
  root.traverse((thing) => {
    const { geometry, material } = thing as unknown as { geometry?: BufferGeometry; material?: Material };
    geometry?.dispose();
    material?.dispose();
    if (thing instanceof InstancedMesh) thing.dispose();
  });
}
