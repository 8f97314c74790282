/** A camera around what is to be seen, and what pointer, touch and keys do to it. */
import { PerspectiveCamera } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Vec } from "../data";

const STEP = Math.PI / 18;
/** Of a view that turns by itself: a turn in half a minute, in few enough pictures for a machine without a graphics card. */
const SPIN = { speed: 2, pause: 60 };

export class Orbit {
  readonly camera = new PerspectiveCamera(28, 1, 0.05, 500);
  private readonly controls: OrbitControls;
  private stopped = () => {};
  private released = false;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly start: Vec,
    private readonly paint: () => void,
  ) {
    this.controls = new OrbitControls(this.camera, canvas);
    this.hold(document.activeElement === canvas);
    this.home();
    this.controls.addEventListener("change", () => this.paint());
    this.controls.addEventListener("start", () => this.halt());
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

  spin(on: boolean, stopped: () => void): void {
    this.stopped = stopped;
    const starts = on && !this.controls.autoRotate;
    this.controls.autoRotate = on;
    this.controls.autoRotateSpeed = SPIN.speed;
    if (starts) this.step(performance.now());
  }

  private halt(): void {
    if (!this.controls.autoRotate) return;
    this.controls.autoRotate = false;
    this.stopped();
  }

  private step(before: number): void {
    if (!this.controls.autoRotate || this.released) return;
    const { top, bottom } = this.canvas.getBoundingClientRect();
    const now = performance.now();
    if (bottom > 0 && top < innerHeight) this.controls.update((now - before) / 1000);
    setTimeout(() => requestAnimationFrame(() => this.step(now)), SPIN.pause);
  }

  release(): void {
    this.released = true;
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
    this.halt();
    turn();
  }
}
