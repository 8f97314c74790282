/** A scene's view, its player and its figure, held together; unpacked when it comes into view. */
import type { Playback } from "../data";
import { button, h } from "../dom";
import { count } from "../numbers";
import { theme } from "../theme";
import { load3d, loaded3d, NO_WEBGL } from "../view3d/cards";
import type { Look, PlaybackView } from "../view3d/playback_view";
import { bulkFigure } from "./bulk";
import { Clock } from "./clock";
import { SCALE } from "./colours";
import { energyFigure } from "./energy";
import { Frames } from "./frames";
import { Player } from "./player";
import { MOST_PATCHES, usesPatch } from "./patches";
import { undrawnWalls } from "./wall_shapes";

const CAPTION =
  "Between frames positions are interpolated linearly, orientations by slerp; contacts are those of the frame last passed.";
const PATCHES = ` A contact's patch is drawn up to the rim, where both surfaces cross, and its point is the patch's centre; frames of more than ${MOST_PATCHES} contacts show no patches.`;

/** What the file holds no numbers of. */
function undrawn(playback: Playback): string {
  const many = undrawnWalls(playback);
  if (many === 0) return "";
  const all = count(playback.walls.length);
  return ` Not drawn: ${count(many)} of ${all} walls. The file has no numbers of them, as of a mesh of more than 20\u202f000 triangles.`;
}

export class PlaybackBlock {
  readonly element: HTMLElement;
  readonly figures: HTMLElement[];
  private readonly clock: Clock;
  private readonly canvas: HTMLCanvasElement;
  private readonly key = h("div", { class: "scale-key" });
  private readonly look: Look = { colouring: "body", contacts: false };
  private frames: Frames | null = null;
  private view: PlaybackView | null = null;
  private isSeen = false;
  private before: number | null = null;

  constructor(private readonly playback: Playback) {
    const { times, name } = playback;
    this.clock = new Clock(times[0] as number, times.at(-1) as number, times.length);
    const label = `3-D view of the scene ${name}. Arrow keys turn it, plus and minus zoom, 0 resets, space plays, comma and full stop step.`;
    this.canvas = h("canvas", { tabindex: 0, role: "application", "aria-label": label });
    const player = new Player(
      playback,
      this.clock,
      (time) => this.unpacked.at(time).frame,
      this.look,
      () => this.show(),
    );
    const seek = (time: number) => this.clock.seek(time);
    const figures = [energyFigure(playback, seek), bulkFigure(playback, seek)].filter((figure) => figure !== null);
    this.figures = figures.map(({ element }) => element);
    const reset = button("Reset view", () => this.view?.reset(), { class: "quiet" });
    const bar = h("div", { class: "view-bar" }, this.key, reset);
    const caption = h("p", { class: "view-caption" }, CAPTION, usesPatch(playback) ? PATCHES : "", undrawn(playback));
    this.element = h("div", { class: "view3d" }, this.canvas, player.element, bar, caption);
    this.canvas.addEventListener("keydown", (event) => this.keyed(event, player));
    this.clock.time.watch((time) => {
      for (const figure of figures) figure.mark(time);
      this.show();
    });
    for (const figure of figures) figure.mark(this.clock.time.value);
    theme.watch(() => this.recolour());
    this.watch();
  }

  private get unpacked(): Frames {
    this.frames ??= new Frames(this.playback);
    return this.frames;
  }

  private watch(): void {
    const seen = ([entry]: IntersectionObserverEntry[]) => {
      this.isSeen = entry?.isIntersecting ?? false;
      if (this.isSeen) void load3d().then(() => this.show());
    };
    new IntersectionObserver(seen, { rootMargin: "150px" }).observe(this.canvas);
  }

  private keyed(event: KeyboardEvent, player: Player): void {
    const acts: Record<string, () => void> = {
      " ": () => this.clock.toggle(),
      ",": () => player.step(-1),
      ".": () => player.step(1),
    };
    const act = acts[event.key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    act();
  }

  /** What the clock says, where anybody sees it. */
  private show(): void {
    const engine = loaded3d();
    if (!engine || !this.isSeen) return;
    if (!engine.hasWebGl()) {
      this.canvas.replaceWith(h("p", { class: "empty" }, `${NO_WEBGL} The figures stand beside it.`));
      this.isSeen = false;
      return;
    }
    this.view ??= new engine.PlaybackView(this.canvas, this.playback, this.unpacked);
    this.view.show(this.unpacked.at(this.clock.time.value), this.look);
    this.explain(this.view);
  }

  /** What the colours mean. */
  private explain(view: PlaybackView): void {
    const { colouring } = this.look;
    if (this.key.dataset.of === colouring) return;
    this.key.dataset.of = colouring;
    if (colouring === "body") {
      this.key.replaceChildren("colours tell bodies apart; grey ones are fixed");
      return;
    }
    const { low, high } = view.scale(colouring);
    const bar = h("span", { class: "scale-bar", style: `background: linear-gradient(to right, ${SCALE.join(", ")})` });
    this.key.replaceChildren(low, bar, high);
  }

  private recolour(): void {
    this.view?.recolour();
    this.show();
  }

  /** The last frame, and then what was there before. */
  still(on: boolean): void {
    if (on) {
      this.before ??= this.clock.time.value;
      this.clock.pause();
      const wasSeen = this.isSeen;
      this.isSeen = true;
      this.clock.seek(this.playback.times.at(-1) as number);
      this.isSeen = wasSeen;
    } else if (this.before !== null) {
      this.clock.seek(this.before);
      this.before = null;
    }
  }
}
