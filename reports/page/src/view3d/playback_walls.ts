/** Walls as translucent planes, cut to the scene's extent. One without a normal is no plane, and not drawn. */
import {
  BufferGeometry,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineLoop,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  Vector3,
} from "three";
import type { Vec } from "../data";
import type { Extent } from "../playback/extent";
import { across, add, cross, dot, scale, subtract } from "./vector";

const CORNERS = [
  [-1, -1],
  [1, -1],
  [1, 1],
  [-1, 1],
] as const;

/** A rectangle about the origin, as wide as the extent's box seen along the normal. */
function pane(normal: Vec, { half }: Extent, colour: string): Group {
  const u = across(normal);
  const v = cross(normal, u);
  const reach = (along: Vec) => along.reduce((sum, part, axis) => sum + Math.abs(part) * (half[axis] as number), 0);
  const [wide, high] = [reach(u), reach(v)];
  const look = { color: colour, transparent: true, depthWrite: false };
  const plane = new Mesh(
    new PlaneGeometry(2 * wide, 2 * high),
    new MeshBasicMaterial({ ...look, side: DoubleSide, opacity: 0.1 }),
  );
  plane.renderOrder = 0;
  const corners = CORNERS.map(([x, y]) => new Vector3(x * wide, y * high, 0));
  const edge = new LineLoop(
    new BufferGeometry().setFromPoints(corners),
    new LineBasicMaterial({ ...look, opacity: 0.55 }),
  );
  edge.renderOrder = 2;
  const group = new Group().add(plane, edge);
  group.quaternion.setFromRotationMatrix(
    new Matrix4().makeBasis(new Vector3(...u), new Vector3(...v), new Vector3(...normal)),
  );
  return group;
}

export class Walls {
  readonly group = new Group();
  private readonly panes: Group[];

  constructor(
    private readonly normals: Vec[],
    private readonly extent: Extent,
    colour: string,
  ) {
    this.panes = normals.map((normal) => (dot(normal, normal) > 0 ? pane(normal, extent, colour) : new Group()));
    for (const one of this.panes) this.group.add(one);
  }

  /** Each where its plane is closest to the scene's middle. */
  move(points: Float32Array): void {
    this.panes.forEach((pane, wall) => {
      const normal = this.normals[wall] as Vec;
      const point = [...points.subarray(3 * wall, 3 * wall + 3)] as unknown as Vec;
      const away = dot(normal, subtract(point, this.extent.centre));
      pane.position.set(...add(this.extent.centre, scale(normal, away)));
    });
  }
}
