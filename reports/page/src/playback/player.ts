/** The buttons, the slider and the choices below a scene; they move a clock and say what it shows. */
import type { Playback } from "../data";
import { button, checkbox, h, select } from "../dom";
import { count, number } from "../numbers";
import type { Look } from "../view3d/playback_view";
import { type Clock } from "./clock";
import { type Colouring, COLOURINGS } from "./colours";

const SPEEDS: [string, string][] = [
  ["0.1", "1/10"],
  ["0.25", "1/4"],
  ["0.5", "1/2"],
  ["1", "1"],
  ["2", "2"],
  ["4", "4"],
];
const ICONS = {
  first: "M4 3h2v10H4zM13 3v10L7 8z",
  before: "M11 3v10L4 8z",
  play: "M4 2.5v11l9-5.5z",
  pause: "M4 3h3v10H4zM9 3h3v10H9z",
  after: "M5 3v10l7-5z",
  last: "M10 3h2v10h-2zM3 3v10l6-5z",
};

function icon(name: keyof typeof ICONS): SVGElement {
  const [picture, path] = ["svg", "path"].map((tag) => document.createElementNS("http://www.w3.org/2000/svg", tag)) as [
    SVGElement,
    SVGElement,
  ];
  picture.setAttribute("viewBox", "0 0 16 16");
  picture.setAttribute("aria-hidden", "true");
  path.setAttribute("d", ICONS[name]);
  picture.append(path);
  return picture;
}

function iconButton(name: keyof typeof ICONS, meaning: string, pressed: () => void): HTMLButtonElement {
  const made = button("", pressed, { class: "icon", "aria-label": meaning, title: meaning });
  made.append(icon(name));
  return made;
}

export class Player {
  readonly element: HTMLElement;
  private readonly slider = h("input", { type: "range", min: 0, max: 1, step: "any", value: 0, "aria-label": "Time" });
  private readonly status = h("p", { class: "player-status" });
  private readonly toggle: HTMLButtonElement;

  constructor(
    private readonly playback: Playback,
    private readonly clock: Clock,
    private readonly frameAt: (time: number) => number,
    look: Look,
    changed: () => void,
  ) {
    this.toggle = iconButton("play", "Play", () => clock.toggle());
    this.toggle.classList.add("main");
    this.slider.addEventListener("input", () => this.slid());
    this.slider.addEventListener("keydown", (event) => this.key(event));
    const buttons = h(
      "div",
      { class: "tools", role: "group", "aria-label": "Play and step" },
      iconButton("first", "First frame", () => this.go(0)),
      iconButton("before", "One frame back", () => this.step(-1)),
      this.toggle,
      iconButton("after", "One frame on", () => this.step(1)),
      iconButton("last", "Last frame", () => this.go(this.playback.times.length - 1)),
    );
    const line = h("div", { class: "player-line" }, buttons, this.slider);
    this.element = h("div", { class: "player" }, line, this.status, this.choices(look, changed));
    clock.time.watch(() => this.tell());
    clock.playing.watch((on) => this.tellPlaying(on));
    this.tell();
  }

  private choices(look: Look, changed: () => void): HTMLElement {
    const { clock } = this;
    const paint = select("Colour", COLOURINGS, look.colouring, (colouring) => {
      look.colouring = colouring as Colouring;
      changed();
    });
    const contacts = checkbox("Contacts", look.contacts, (on) => {
      look.contacts = on;
      changed();
    });
    const speed = select("Speed", SPEEDS, "1", (value) => {
      clock.speed = Number(value);
      this.tell();
    });
    const repeat = checkbox("Repeat", clock.repeat, (on) => {
      clock.repeat = on;
    });
    return h("div", { class: "player-choices" }, paint, contacts, speed, repeat);
  }

  private get frame(): number {
    return this.frameAt(this.clock.time.value);
  }

  private go(frame: number): void {
    this.clock.pause();
    const { times } = this.playback;
    this.clock.seek(times[Math.min(times.length - 1, Math.max(0, frame))] as number);
  }

  /** Back from between two frames is to the first of them. */
  step(by: number): void {
    const isOnFrame = this.playback.times[this.frame] === this.clock.time.value;
    this.go(this.frame + by + (by < 0 && !isOnFrame ? 1 : 0));
  }

  private slid(): void {
    this.clock.pause();
    const [first, last] = [this.playback.times[0] as number, this.playback.times.at(-1) as number];
    this.clock.seek(first + Number(this.slider.value) * (last - first));
  }

  private key(event: KeyboardEvent): void {
    const steps: Record<string, number> = {
      ArrowLeft: -1,
      ArrowDown: -1,
      ArrowRight: 1,
      ArrowUp: 1,
      PageDown: -10,
      PageUp: 10,
      Home: Number.NEGATIVE_INFINITY,
      End: Number.POSITIVE_INFINITY,
    };
    const by = steps[event.key];
    if (by === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    this.step(by);
  }

  private tell(): void {
    const { times, contacts } = this.playback;
    const [first, last] = [times[0] as number, times.at(-1) as number];
    const time = this.clock.time.value;
    const where = `t = ${number(time, 4)}, frame ${count(this.frame + 1)} of ${count(times.length)}`;
    this.slider.value = String(last > first ? (time - first) / (last - first) : 0);
    this.slider.setAttribute("aria-valuetext", where);
    const touching = `${count(contacts.counts[this.frame] ?? 0)} contacts`;
    this.status.textContent = `${where}, ${touching}; 1 s plays ${number(this.clock.rate, 2)}`;
  }

  private tellPlaying(on: boolean): void {
    const meaning = on ? "Pause" : "Play";
    this.toggle.replaceChildren(icon(on ? "pause" : "play"));
    this.toggle.title = meaning;
    this.toggle.setAttribute("aria-label", meaning);
  }
}
