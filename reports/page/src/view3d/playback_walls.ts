/** Walls, seen through: planes, cut to the scene's extent, and shapes. What has neither a normal nor a shape is not drawn. */
import {
  BufferGeometry,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineLoop,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  Vector3,
} from "three";
import type { Playback, Vec, WallShape } from "../data";
import type { Extent } from "../playback/extent";
import { across, add, cross, dot, scale, subtract } from "./vector";
import { linesOf, surfaceOf } from "./wall_surface";

const CORNERS = [
  [-1, -1],
  [1, -1],
  [1, 1],
  [-1, 1],
] as const;

const SKIN = 0.1;
const LINE = 0.55;

const look = (colour: string, opacity: number) => ({ color: colour, transparent: true, depthWrite: false, opacity });

/** Drawn before bodies that are seen through, and its lines after them. */
function drawn(surface: BufferGeometry, edge: LineLoop | LineSegments, colour: string): Group {
  const mesh = new Mesh(surface, new MeshBasicMaterial({ ...look(colour, SKIN), side: DoubleSide }));
  mesh.renderOrder = 0;
  edge.renderOrder = 2;
  return new Group().add(mesh, edge);
}

/** A rectangle about the origin, as wide as the extent's box seen along the normal. */
function pane(normal: Vec, { half }: Extent, colour: string): Group {
  const u = across(normal);
  const v = cross(normal, u);
  const reach = (along: Vec) => along.reduce((sum, part, axis) => sum + Math.abs(part) * (half[axis] as number), 0);
  const [wide, high] = [reach(u), reach(v)];
  const corners = CORNERS.map(([x, y]) => new Vector3(x * wide, y * high, 0));
  const edge = new LineLoop(new BufferGeometry().setFromPoints(corners), new LineBasicMaterial(look(colour, LINE)));
  const group = drawn(new PlaneGeometry(2 * wide, 2 * high), edge, colour);
  group.quaternion.setFromRotationMatrix(
    new Matrix4().makeBasis(new Vector3(...u), new Vector3(...v), new Vector3(...normal)),
  );
  return group;
}

function shaped(shape: WallShape, colour: string): Group {
  const surface = surfaceOf(shape);
  const edge = new LineSegments(linesOf(shape, surface), new LineBasicMaterial(look(colour, LINE)));
  return drawn(surface, edge, colour);
}

export class Walls {
  readonly group = new Group();
  private readonly panes: (Group | null)[];
  private readonly shapes: (Group | null)[];

  constructor(
    private readonly playback: Pick<Playback, "walls" | "wall_shapes">,
    private readonly extent: Extent,
    colour: string,
  ) {
    const { walls, wall_shapes } = playback;
    this.panes = walls.map((normal) => (dot(normal, normal) > 0 ? pane(normal, extent, colour) : null));
    this.shapes = wall_shapes.map((shape) => shape && shaped(shape, colour));
    for (const one of [...this.panes, ...this.shapes]) if (one) this.group.add(one);
  }

  move(points: Float32Array, turns: Float32Array): void {
    this.panes.forEach((pane, wall) => pane?.position.set(...this.middle(wall, points)));
    this.shapes.forEach((shape, wall) => {
      shape?.position.fromArray(points, 3 * wall);
      const [w, x, y, z] = turns.subarray(4 * wall, 4 * wall + 4) as unknown as [number, number, number, number];
      shape?.quaternion.set(x, y, z, w);
    });
  }

  /** Where a plane is closest to the scene's middle. */
  private middle(wall: number, points: Float32Array): Vec {
    const normal = this.playback.walls[wall] as Vec;
    const point = [...points.subarray(3 * wall, 3 * wall + 3)] as unknown as Vec;
    const away = dot(normal, subtract(point, this.extent.centre));
    return add(this.extent.centre, scale(normal, away));
  }
}
