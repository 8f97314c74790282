/** The patches of a frame's contacts, from the places of the bodies in it. */
import { Group } from "three";
import type { Playback, Vec } from "../data";
import { blankContact, type Frames } from "../playback/frames";
import { MOST_PATCHES } from "../playback/patches";
import { patches } from "./patches";
import { halfSpace, rimOf, type Surface, surfaceOf } from "./rim";
import { dispose } from "./scene";
import { divide, turnOf, unit } from "./vector";

const triple = (x: Float32Array, at: number): Vec => [...x.subarray(3 * at, 3 * at + 3)] as unknown as Vec;

export class Patches {
  readonly group = new Group();
  private readonly x: Float32Array;
  private readonly q: Float32Array;
  private readonly wallPoints: Float32Array;

  constructor(
    private readonly playback: Playback,
    private readonly frames: Frames,
    private readonly colour: string,
  ) {
    this.x = new Float32Array(3 * frames.bodies);
    this.q = new Float32Array(4 * frames.bodies);
    this.wallPoints = new Float32Array(3 * playback.walls.length);
  }

  show(frame: number): void {
    dispose(this.group);
    this.group.clear();
    const count = this.frames.contacts(frame);
    if (count > MOST_PATCHES) return;
    const moment = { frame, part: 0 };
    this.frames.positions(moment, this.x);
    this.frames.orientations(moment, this.q);
    this.frames.wallPoints(moment, this.wallPoints);
    const rims = Array.from({ length: count }, (_, index) => this.rim(frame, index));
    this.group.add(
      patches(
        rims.filter((rim) => rim !== null),
        this.colour,
      ),
    );
  }

  private rim(frame: number, index: number): Vec[] | null {
    const contact = blankContact();
    this.frames.contact(frame, index, contact);
    const [first, second] = [this.surface(contact.first), this.surface(contact.second)];
    return rimOf(first, second, triple(contact.point, 0), unit(triple(contact.normal, 0)));
  }

  /** Walls are counted on from the bodies. */
  private surface(index: number): Surface {
    const { shapes, bodies, size, walls } = this.playback;
    const wall = index - this.frames.bodies;
    if (wall >= 0) return halfSpace(triple(this.wallPoints, wall), walls[wall] as Vec);
    const { semi_axes, exponents } = shapes[bodies[index] as number] as Playback["shapes"][number];
    const turn = turnOf([...this.q.subarray(4 * index, 4 * index + 4)] as [number, number, number, number]);
    return surfaceOf({ axes: divide(semi_axes, size), exponents, turn, centre: triple(this.x, index) });
  }
}
