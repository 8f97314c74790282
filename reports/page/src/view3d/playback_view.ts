/** A scene at any time: three's things, moved and coloured in place. */
import { BufferGeometry, Color, Group, HemisphereLight, LineBasicMaterial, LineSegments, Vector3 } from "three";
import type { Playback, Vec } from "../data";
import { BODY_COLOURS, type Colouring, FIXED_COLOUR, SCALE, type Scaled, scaled } from "../playback/colours";
import { type Extent, extentOf } from "../playback/extent";
import { type Frames, type Moment, quantile } from "../playback/frames";
import { PART } from "../playback/packed";
import { usesPatch } from "../playback/patches";
import { ink, theme } from "../theme";
import { Orbit } from "./orbit";
import { Bodies } from "./playback_bodies";
import { Contacts } from "./playback_contacts";
import { Patches } from "./playback_patches";
import { Walls } from "./playback_walls";
import { renderTo } from "./renderer";
import { COLOURS, dispose, type Label, litScene } from "./scene";
import { length } from "./vector";

export interface Look {
  colouring: Colouring;
  contacts: boolean;
}

const SHADES = 256;

function shades(): Color[] {
  const stops = SCALE.map((stop) => new Color(stop));
  return Array.from({ length: SHADES }, (_, index) => {
    const place = (index / (SHADES - 1)) * (stops.length - 1);
    const stop = Math.min(stops.length - 2, Math.floor(place));
    return (stops[stop] as Color).clone().lerp(stops[stop + 1] as Color, place - stop);
  });
}

/** Of the largest force: what 98 in 100 contacts stay below. */
function ordinaryForce(frames: Frames): number {
  const all = frames.allForces;
  const stride = Math.max(1, Math.ceil(all.length / 40000));
  const forces = Array.from({ length: Math.floor(all.length / stride) }, (_, i) => Math.abs(all[i * stride] as number));
  return quantile(forces, 0.98) / PART || 1;
}

const AXES: [string, Vec][] = [
  ["x", [1, 0, 0]],
  ["y", [0, 1, 0]],
  ["z", [0, 0, 1]],
];

/** What one theme draws. */
class Stage {
  readonly scene = litScene();
  readonly labels: Label[] = [];
  readonly bodies: Bodies;
  readonly walls: Walls;
  readonly contacts: Contacts;
  readonly patches: Patches | null;

  constructor(playback: Playback, frames: Frames, extent: Extent, force: number) {
    const { muted } = ink();
    this.bodies = new Bodies(playback);
    this.walls = new Walls(playback, extent, muted);
    this.contacts = new Contacts(frames, extent.body, force, COLOURS[theme.value].link);
    this.patches = usesPatch(playback) ? new Patches(playback, frames, COLOURS[theme.value].patch) : null;
    if (this.patches) this.contacts.group.add(this.patches.group);
    const root = new Group().add(...this.bodies.meshes, this.walls.group, this.contacts.group);
    const radius = 0.95 * length(extent.half);
    // z up: three's y.
    root.rotation.x = -Math.PI / 2;
    root.scale.setScalar(1 / radius);
    const [x, y, z] = extent.centre;
    root.position.set(-x / radius, -z / radius, y / radius);
    root.add(this.axes(extent, muted));
    this.scene.add(root, new HemisphereLight("#ffffff", "#9aa4ae", 1.1));
    root.updateMatrixWorld();
    this.name(root, extent, muted);
  }

  private ends({ centre, half }: Extent): [string, Vector3, Vector3][] {
    const corner = new Vector3(...centre).sub(new Vector3(...half));
    const long = 0.22 * length(half);
    return AXES.map(([name, along]) => [name, corner, corner.clone().addScaledVector(new Vector3(...along), long)]);
  }

  private axes(extent: Extent, colour: string): LineSegments {
    const lines = this.ends(extent).flatMap(([, from, to]) => [from, to]);
    const axes = new LineSegments(new BufferGeometry().setFromPoints(lines), new LineBasicMaterial({ color: colour }));
    axes.renderOrder = 4;
    return axes;
  }

  private name(root: Group, extent: Extent, colour: string): void {
    for (const [text, , to] of this.ends(extent))
      this.labels.push({ text, at: to.clone().applyMatrix4(root.matrixWorld).toArray() as Vec, colour, side: "right" });
  }
}

export class PlaybackView {
  private readonly orbit: Orbit;
  private readonly extent: Extent;
  private readonly force: number;
  private readonly shades = shades();
  private readonly fixed: Set<number>;
  private readonly own = BODY_COLOURS.map((colour) => new Color(colour));
  private readonly still = new Color(FIXED_COLOUR);
  private readonly scales = new Map<Colouring, Scaled>();
  private readonly x: Float32Array;
  private readonly q: Float32Array;
  private readonly wallPoints: Float32Array;
  private readonly wallTurns: Float32Array;
  private readonly values: Float32Array;
  private stage: Stage;
  private coloured = "";
  private contactsOf = -1;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly playback: Playback,
    private readonly frames: Frames,
  ) {
    this.extent = extentOf(playback, frames);
    this.force = ordinaryForce(frames);
    this.fixed = new Set(playback.fixed);
    this.x = new Float32Array(3 * frames.bodies);
    this.q = new Float32Array(4 * frames.bodies);
    this.wallPoints = new Float32Array(3 * playback.walls.length);
    this.wallTurns = new Float32Array(4 * playback.walls.length);
    this.values = new Float32Array(frames.bodies);
    this.stage = this.newStage();
    this.orbit = new Orbit(canvas, [1.9, 1.5, 3.7], () => this.paint());
  }

  private newStage(): Stage {
    return new Stage(this.playback, this.frames, this.extent, this.force);
  }

  /** After it, show is to be called. */
  recolour(): void {
    dispose(this.stage.scene);
    this.stage = this.newStage();
    this.coloured = "";
    this.contactsOf = -1;
  }

  show(moment: Moment, look: Look): void {
    this.frames.positions(moment, this.x);
    this.frames.orientations(moment, this.q);
    this.frames.wallPoints(moment, this.wallPoints);
    this.frames.wallOrientations(moment, this.wallTurns);
    this.stage.bodies.move(this.x, this.q);
    this.stage.walls.move(this.wallPoints, this.wallTurns);
    this.colour(moment.frame, look.colouring);
    this.stage.bodies.fade(look.contacts);
    this.stage.contacts.group.visible = look.contacts;
    if (look.contacts && this.contactsOf !== moment.frame) {
      this.stage.contacts.show(moment.frame);
      this.stage.patches?.show(moment.frame);
      this.contactsOf = moment.frame;
    }
    this.canvas.dataset.drawn = "true";
    this.paint();
  }

  scale(colouring: Exclude<Colouring, "body">): Scaled {
    const known = this.scales.get(colouring) ?? scaled(colouring, this.playback, this.frames);
    this.scales.set(colouring, known);
    return known;
  }

  private colour(frame: number, colouring: Colouring): void {
    const wanted = colouring === "body" ? colouring : `${colouring} ${frame}`;
    if (wanted === this.coloured) return;
    this.coloured = wanted;
    const free = colouring === "body" ? this.ownColours() : this.scaledColours(frame, colouring);
    this.stage.bodies.paint((body) => (this.fixed.has(body) ? this.still : free(body)));
  }

  private ownColours(): (body: number) => Color {
    return (body) => this.own[body % this.own.length] as Color;
  }

  private scaledColours(frame: number, colouring: Exclude<Colouring, "body">): (body: number) => Color {
    const { most, values } = this.scale(colouring);
    values(frame, this.values);
    return (body) => {
      const part = most > 0 ? Math.min(1, (this.values[body] as number) / most) : 0;
      return this.shades[Math.round(part * (SHADES - 1))] as Color;
    };
  }

  private paint(): void {
    renderTo(this.canvas, this.stage, this.orbit.camera);
  }

  reset(): void {
    this.orbit.reset();
  }
}
