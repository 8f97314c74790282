/** Bodies as instances: one mesh for all of the same exponents, stretched to their axes. */
import { Color, InstancedMesh, MeshLambertMaterial } from "three";
import type { Playback, Vec } from "../data";
import { wholeMesh } from "./mesh";
import { surfaceGeometry } from "./scene";

/** So many move fluently even without a graphics card; their edges then are off by a part of a pixel. */
const TRIANGLES = 150000;
const FINEST = 7;
const COARSEST = 2;
/** Of a mesh with so many steps from axis to edge: 4 half rows of 8 half cells. */
const trianglesOf = (half: number): number => 2 * 4 * half * 8 * half;

export function finenessFor(bodies: number): number {
  let half = FINEST;
  while (half > COARSEST && bodies * trianglesOf(half) > TRIANGLES) half--;
  return half;
}

interface Alike {
  mesh: InstancedMesh;
  bodies: number[];
}

/** Column by column: the turn of the quaternion (w, x, y, z), stretched, then the place. */
function place(out: Float32Array, at: number, q: Float32Array, [a, b, c]: Vec, x: Float32Array, body: number): void {
  const [s, i, j, k] = [q[4 * body], q[4 * body + 1], q[4 * body + 2], q[4 * body + 3]] as [
    number,
    number,
    number,
    number,
  ];
  out[at] = a * (1 - 2 * (j * j + k * k));
  out[at + 1] = a * 2 * (i * j + s * k);
  out[at + 2] = a * 2 * (i * k - s * j);
  out[at + 4] = b * 2 * (i * j - s * k);
  out[at + 5] = b * (1 - 2 * (i * i + k * k));
  out[at + 6] = b * 2 * (j * k + s * i);
  out[at + 8] = c * 2 * (i * k + s * j);
  out[at + 9] = c * 2 * (j * k - s * i);
  out[at + 10] = c * (1 - 2 * (i * i + j * j));
  for (let axis = 0; axis < 3; axis++) out[at + 12 + axis] = x[3 * body + axis] as number;
  out[at + 15] = 1;
}

export class Bodies {
  readonly material = new MeshLambertMaterial();
  private readonly all: Alike[] = [];
  private readonly axes: Vec[];

  constructor(playback: Playback) {
    const { shapes, bodies, size } = playback;
    this.axes = bodies.map((shape) => (shapes[shape]?.semi_axes ?? [0, 0, 0]).map((axis) => axis / size) as Vec);
    const alike = new Map<string, { exponents: [number, number]; bodies: number[] }>();
    bodies.forEach((shape, body) => {
      const exponents = shapes[shape]?.exponents ?? [2, 2];
      const known = alike.get(exponents.join());
      if (known) known.bodies.push(body);
      else alike.set(exponents.join(), { exponents, bodies: [body] });
    });
    const half = finenessFor(bodies.length);
    for (const { exponents, bodies: members } of alike.values())
      this.all.push({ mesh: this.instances(exponents, half, members.length), bodies: members });
  }

  private instances(exponents: [number, number], half: number, count: number): InstancedMesh {
    const turn: [Vec, Vec, Vec] = [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ];
    const same = (x: Vec) => x;
    const unit = wholeMesh(
      { axes: [1, 1, 1], exponents, turn, centre: [0, 0, 0] },
      { point: same, direction: same },
      half,
    );
    const mesh = new InstancedMesh(surfaceGeometry(unit), this.material, count);
    mesh.frustumCulled = false;
    mesh.renderOrder = 1;
    mesh.setColorAt(0, new Color("#ffffff"));
    return mesh;
  }

  get meshes(): InstancedMesh[] {
    return this.all.map(({ mesh }) => mesh);
  }

  move(x: Float32Array, q: Float32Array): void {
    for (const { mesh, bodies } of this.all) {
      const matrices = mesh.instanceMatrix.array as Float32Array;
      bodies.forEach((body, index) => place(matrices, 16 * index, q, this.axes[body] as Vec, x, body));
      mesh.instanceMatrix.needsUpdate = true;
    }
  }

  paint(colourOf: (body: number) => Color): void {
    for (const { mesh, bodies } of this.all) {
      bodies.forEach((body, index) => mesh.setColorAt(index, colourOf(body)));
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    }
  }

  /** Seen through, what is inside can be seen; then none hides another. */
  fade(on: boolean): void {
    if (this.material.transparent === on) return;
    Object.assign(this.material, { transparent: on, opacity: on ? 0.22 : 1, depthWrite: !on, needsUpdate: true });
  }
}
