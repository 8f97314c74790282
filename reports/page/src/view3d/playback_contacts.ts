/** Contacts as instances: a point, and an arrow along the normal as long as the force is large. */
import {
  type BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  Group,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  OctahedronGeometry,
  Quaternion,
  Vector3,
} from "three";
import { blankContact, type Frames } from "../playback/frames";

const UP = new Vector3(0, 1, 0);
/** In units of the median body. */
const POINT = 0.1;
const LONGEST = 2.4;
const HEAD = 0.34;

export class Contacts {
  readonly group = new Group();
  private readonly points: InstancedMesh;
  private readonly shafts: InstancedMesh;
  private readonly heads: InstancedMesh;

  /** `force`: as large a part of the largest force has the longest arrow. */
  constructor(
    private readonly frames: Frames,
    private readonly body: number,
    private readonly force: number,
    colour: string,
  ) {
    let most = 1;
    for (let frame = 0; frame < frames.count; frame++) most = Math.max(most, frames.contacts(frame));
    const material = new MeshBasicMaterial({ color: colour, transparent: true });
    const instances = (geometry: BufferGeometry): InstancedMesh => {
      const mesh = new InstancedMesh(geometry, material, most);
      mesh.frustumCulled = false;
      mesh.renderOrder = 3;
      return mesh;
    };
    this.points = instances(new OctahedronGeometry(POINT * body, 1));
    this.shafts = instances(new CylinderGeometry(0.035 * body, 0.035 * body, 1, 6, 1, true).translate(0, 0.5, 0));
    this.heads = instances(new ConeGeometry(0.3, 1, 8).translate(0, 0.5, 0));
    this.group.add(this.points, this.shafts, this.heads);
  }

  show(frame: number): void {
    const count = this.frames.contacts(frame);
    const contact = blankContact();
    const [at, along, size] = [new Vector3(), new Vector3(), new Vector3()];
    const [turn, matrix] = [new Quaternion(), new Matrix4()];
    for (let index = 0; index < count; index++) {
      this.frames.contact(frame, index, contact);
      at.fromArray(contact.point);
      turn.setFromUnitVectors(UP, along.fromArray(contact.normal).normalize());
      const long = LONGEST * this.body * Math.min(1, Math.abs(contact.force) / this.force);
      const head = Math.min(HEAD * this.body, 0.5 * long);
      this.points.setMatrixAt(index, matrix.makeTranslation(at));
      this.shafts.setMatrixAt(index, matrix.compose(at, turn, size.set(1, long - head, 1)));
      at.addScaledVector(along, long - head);
      this.heads.setMatrixAt(index, matrix.compose(at, turn, size.setScalar(head)));
    }
    for (const mesh of [this.points, this.shafts, this.heads]) {
      mesh.count = count;
      mesh.instanceMatrix.needsUpdate = true;
    }
  }
}
