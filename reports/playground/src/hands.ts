/** What pointer, touch and keys do to the bodies, where the reader has not chosen to turn the view. */
import type { PerspectiveCamera } from "three";
import type { Vec } from "../../page/src/data";
import { add, length, scale, unit } from "../../page/src/view3d/vector";
import { positionOf, type Setting } from "./pair";
import { composed, eulerOf, lineOf, quaternionOf, turnAbout } from "./rotation";
import { turnOf } from "../../page/src/view3d/vector";

export type Hold = "view" | "turn1" | "turn2" | "move2";

/** Radians a pixel, and a press of a key in pixels. */
const TURN = 0.01;
const KEY = 9;

const rounded = (x: number): number => Math.round(x * 1e4) / 1e4;

/** The camera's right and up, in the world's axes. */
function sides(camera: PerspectiveCamera): [Vec, Vec] {
  const e = camera.matrixWorld.elements as unknown as number[];
  return [unit([e[0]!, e[1]!, e[2]!]), unit([e[4]!, e[5]!, e[6]!])];
}

function turned(setting: Setting, index: 0 | 1, [right, up]: [Vec, Vec], x: number, y: number): void {
  const solid = setting.solids[index];
  const turn = composed(turnAbout(up, x * TURN), turnAbout(right, y * TURN));
  solid.euler = eulerOf(composed(turn, turnOf(quaternionOf(solid.euler)))).map(rounded) as Vec;
}

function moved(setting: Setting, [right, up]: [Vec, Vec], x: number, y: number, pixel: number): void {
  const to = add(positionOf(setting), add(scale(right, x * pixel), scale(up, -y * pixel)));
  setting.line = lineOf(to).map(rounded) as [number, number];
  setting.distance = rounded(length(to));
}

export class Hands {
  hold: Hold = "view";

  /** `change` gets pixels as a change of the setting; made before OrbitControls, so that it hears of nothing that is the bodies'. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly camera: () => PerspectiveCamera,
    private readonly lengthOfPixel: () => number,
    private readonly change: (apply: (setting: Setting) => void) => void,
  ) {
    const early = { capture: true };
    canvas.addEventListener("pointerdown", (event) => this.down(event), early);
    canvas.addEventListener("pointermove", (event) => this.drag(event), early);
    canvas.addEventListener("keydown", (event) => this.key(event), early);
  }

  choose(hold: Hold): void {
    this.hold = hold;
    this.canvas.classList.toggle("held", hold !== "view");
  }

  private by(x: number, y: number): void {
    const to = sides(this.camera());
    const { hold } = this;
    this.change((setting) => {
      if (hold === "move2") moved(setting, to, x, y, this.lengthOfPixel());
      else turned(setting, hold === "turn1" ? 0 : 1, to, x, y);
    });
  }

  private down(event: PointerEvent): void {
    if (this.hold === "view") return;
    event.stopImmediatePropagation();
    this.canvas.setPointerCapture(event.pointerId);
  }

  private drag(event: PointerEvent): void {
    if (this.hold === "view") return;
    event.stopImmediatePropagation();
    if (event.isPrimary && event.buttons !== 0) this.by(event.movementX, event.movementY);
  }

  private key(event: KeyboardEvent): void {
    const steps: Record<string, [number, number]> = {
      ArrowLeft: [-KEY, 0],
      ArrowRight: [KEY, 0],
      ArrowUp: [0, -KEY],
      ArrowDown: [0, KEY],
    };
    const step = steps[event.key];
    if (this.hold === "view" || !step || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    this.by(...step);
  }
}
