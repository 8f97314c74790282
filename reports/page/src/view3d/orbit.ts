/** A camera around what is to be seen, and what pointer, touch and keys do to it. */
import { PerspectiveCamera } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Vec } from "../data";

const STEP = Math.PI / 18;

export class Orbit {
  readonly camera = new PerspectiveCamera(28, 1, 0.05, 500);
  private readonly controls: OrbitControls;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly start: Vec,
    private readonly paint: () => void,
  ) {
    this.controls = new OrbitControls(this.camera, canvas);
    this.hold(document.activeElement === canvas);
    this.home();
    this.controls.addEventListener("change", () => this.paint());
    canvas.addEventListener("keydown", (event) => this.key(event));
    canvas.addEventListener("focus", () => this.hold(true));
    canvas.addEventListener("blur", () => this.hold(false));
    new ResizeObserver(() => this.paint()).observe(canvas);
  }

  /** Only a canvas that the reader chose takes the wheel and the swipe from the page. */
  private hold(on: boolean): void {
    this.controls.enableZoom = on;
    this.canvas.style.touchAction = on ? "none" : "pan-y";
  }

  private home(): void {
    this.camera.position.set(...this.start);
    this.controls.target.set(0, 0, 0);
    this.controls.update();
  }

  reset(): void {
    this.home();
    this.paint();
  }

  release(): void {
    this.controls.dispose();
  }

  private dolly(factor: number): void {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
  }

  private key(event: KeyboardEvent): void {
    const turns: Record<string, () => void> = {
      ArrowLeft: () => this.controls.rotateLeft(STEP),
      ArrowRight: () => this.controls.rotateLeft(-STEP),
      ArrowUp: () => this.controls.rotateUp(STEP),
      ArrowDown: () => this.controls.rotateUp(-STEP),
      "+": () => this.dolly(0.85),
      "=": () => this.dolly(0.85),
      "-": () => this.dolly(1 / 0.85),
      "0": () => this.reset(),
    };
    const turn = turns[event.key];
    if (!turn || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    turn();
  }
}
