/** A failure's picture, which turns. */
import { number } from "../numbers";
import { theme } from "../theme";
import { Orbit } from "./orbit";
import type { Geometry, Zoom } from "./placed";
import { renderTo } from "./renderer";
import { dispose, type Pictured, picture } from "./scene";

export class View3d {
  private readonly orbit: Orbit;
  private pictured: Pictured | null = null;
  private zoom: Zoom = "bodies";

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly geometry: Geometry,
    private readonly size: HTMLElement,
    private readonly plain = false,
  ) {
    this.orbit = new Orbit(canvas, plain ? [1, 0.75, 3.7] : [1.2, 0.9, 4.4], () => this.paint());
  }

  show(zoom: Zoom): void {
    this.zoom = zoom;
    this.recolour();
  }

  recolour(): void {
    this.forget();
    this.pictured = picture(this.geometry, this.zoom, theme.value, this.plain);
    this.canvas.dataset.drawn = "true";
    this.size.textContent = this.pictured ? `radius ${number(this.pictured.radius, 2)}` : "nothing to show";
    this.paint();
  }

  reset(): void {
    this.orbit.reset();
  }

  /** Until the reader takes hold of it, who is then told. */
  spin(on: boolean, stopped: () => void): void {
    this.orbit.spin(on, stopped);
  }

  private paint(): void {
    if (this.pictured) renderTo(this.canvas, this.pictured, this.orbit.camera);
  }

  private forget(): void {
    if (this.pictured) dispose(this.pictured.scene);
    this.pictured = null;
  }

  release(): void {
    this.forget();
    this.orbit.release();
  }
}
