/** A picture that turns: its camera, and what pointer, touch and keys do to it. */
import { PerspectiveCamera } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { number } from "../numbers";
import { theme } from "../theme";
import type { Geometry, Zoom } from "./placed";
import { renderTo } from "./renderer";
import { dispose, type Pictured, picture } from "./scene";

export { hasWebGl } from "./renderer";

const STEP = Math.PI / 18;

export class View3d {
  private readonly camera = new PerspectiveCamera(28, 1, 0.05, 500);
  private readonly controls: OrbitControls;
  private pictured: Pictured | null = null;
  private zoom: Zoom = "bodies";

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly geometry: Geometry,
    private readonly size: HTMLElement,
  ) {
    this.controls = new OrbitControls(this.camera, canvas);
    this.hold(document.activeElement === canvas);
    this.reset();
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

  show(zoom: Zoom): void {
    this.zoom = zoom;
    this.recolour();
  }

  recolour(): void {
    this.forget();
    this.pictured = picture(this.geometry, this.zoom, theme.value);
    this.canvas.dataset.drawn = "true";
    this.size.textContent = this.pictured ? `radius ${number(this.pictured.radius, 2)}` : "nothing to show";
    this.paint();
  }

  private paint(): void {
    if (this.pictured) renderTo(this.canvas, this.pictured, this.camera);
  }

  private forget(): void {
    if (this.pictured) dispose(this.pictured.scene);
    this.pictured = null;
  }

  reset(): void {
    this.camera.position.set(1.2, 0.9, 4.4);
    this.controls.target.set(0, 0, 0);
    this.controls.update();
    this.paint();
  }

  release(): void {
    this.forget();
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
