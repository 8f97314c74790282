/** The 3-D view of a card: three is loaded and the picture drawn when the card comes into view. */
import { h } from "../dom";
import { theme } from "../theme";
import { focusOf, type Geometry, geometryOf, type Shown, type Zoom } from "./placed";
import type { View3d } from "./view";

type Engine = typeof import("./engine");

const ZOOMS: [Zoom, string, string][] = [
  ["bodies", "Bodies", "Show both bodies"],
  ["patch", "Patch", "Zoom to the patch: what both bodies have in common"],
  ["points", "Points", "Zoom to all points: the answer's and the reference's"],
  ["overlap", "Overlap", "Zoom to the overlap at the reference's contact"],
];
export const NO_WEBGL = "No 3-D view: this browser offers no WebGL.";

let engine: Engine;
export const loaded3d = (): Engine | undefined => engine;
const cards = new Map<Element, Card>();

export async function load3d(): Promise<Engine> {
  engine ??= await import("./engine");
  return engine;
}

function drawAll(canvases: Iterable<Element>): void {
  for (const canvas of canvases) cards.get(canvas)?.draw();
}

const watcher = new IntersectionObserver(
  (entries) => {
    const seen = entries.filter((entry) => entry.isIntersecting).map((entry) => entry.target);
    if (seen.length > 0) void load3d().then(() => drawAll(seen));
  },
  { rootMargin: "150px" },
);

theme.watch(() => {
  for (const card of cards.values()) card.view?.recolour();
});

export function drawCardsForPaper(): void {
  if (engine) drawAll(cards.keys());
}

/** The cards in that place are about to be thrown away. */
export function releaseCards(place: Element): void {
  for (const [canvas, card] of cards) {
    if (!place.contains(canvas)) continue;
    watcher.unobserve(canvas);
    card.view?.release();
    cards.delete(canvas);
  }
}

const still = matchMedia("(prefers-reduced-motion: reduce)");

class Card {
  view: View3d | null = null;
  readonly element: HTMLElement;
  private readonly canvas: HTMLCanvasElement;
  private readonly size = h("span", { class: "view-size" });
  private readonly turns: HTMLButtonElement;
  private readonly geometry: Geometry;
  private zoom: Zoom = "bodies";
  private turning = false;

  /** `plain`: the two normals alone, turning. */
  constructor(
    shown: Shown,
    name: string,
    private readonly plain: boolean,
  ) {
    const label = `3-D view of ${name}. Arrow keys turn it, plus and minus zoom, 0 resets.`;
    this.geometry = geometryOf(shown);
    this.canvas = h("canvas", { tabindex: 0, role: "application", "aria-label": label });
    const quiet = { type: "button", class: "quiet" };
    const reset = h("button", { ...quiet, title: "Turn back", click: () => this.view?.reset() }, "Reset");
    this.turns = h("button", { ...quiet, click: () => this.turn(!this.turning) }, "Turn");
    const controls = plain ? [this.turns, reset] : [this.zoomChoice(), reset, this.size];
    this.element = h("div", { class: "view3d" }, this.canvas, h("div", { class: "view-bar" }, ...controls));
    cards.set(this.canvas, this);
    watcher.observe(this.canvas);
  }

  private turn(on: boolean): void {
    this.turning = on;
    this.turns.textContent = on ? "Stop turning" : "Turn";
    this.view?.spin(on, () => this.turn(false));
  }

  draw(): void {
    if (!engine.hasWebGl()) {
      this.element.replaceChildren(
        h("p", { class: "empty" }, `${NO_WEBGL} The figures, the command and the case stand below.`),
      );
      return;
    }
    if (this.view) return this.view.show(this.zoom);
    this.view = new engine.View3d(this.canvas, this.geometry, this.size, this.plain);
    this.view.show(this.zoom);
    if (this.plain && !still.matches) this.turn(true);
  }

  private zoomChoice(): HTMLElement {
    const buttons = ZOOMS.map(([zoom, label, meaning]) => {
      const choose = () => {
        for (const other of buttons) other.setAttribute("aria-pressed", String(other === pressed));
        this.zoom = zoom;
        this.view?.show(zoom);
      };
      const look = { type: "button", class: "quiet", title: meaning, "aria-pressed": String(zoom === this.zoom) };
      const pressed: HTMLButtonElement = h("button", { ...look, click: choose }, label);
      pressed.disabled = focusOf(this.geometry, zoom) === null;
      return pressed;
    });
    return h("div", { class: "tools", role: "group", "aria-label": "What the view shows" }, ...buttons);
  }
}

export const view3d = (shown: Shown, name: string): HTMLElement => new Card(shown, name, false).element;
export const plainView3d = (shown: Shown, name: string): HTMLElement => new Card(shown, name, true).element;
