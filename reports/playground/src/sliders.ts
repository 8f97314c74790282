/** One slider a number of the setting. */
import { h } from "../../page/src/dom";
import type { Setting, Solid } from "./pair";

interface Range {
  least: number;
  most: number;
  step: number;
}

const AXIS: Range = { least: 0.1, most: 3, step: 0.01 };
const EXPONENT: Range = { least: 1.1, most: 10, step: 0.1 };
const CIRCLE: Range = { least: 0, most: 360, step: 1 };
const HALF: Range = { least: 0, most: 180, step: 1 };
const RATIO: Range = { least: -0.2, most: 0.5, step: 0.001 };

/** What a slider reads and writes; `touch` is the distance of first touch, NaN where it is not known. */
interface Number_ {
  label: string;
  range: Range;
  get: (setting: Setting, touch: number) => number;
  set: (setting: Setting, value: number, touch: number) => void;
}

function ofSolid(index: 0 | 1): Number_[] {
  const solid = (setting: Setting): Solid => setting.solids[index];
  const part = (label: string, range: Range, list: (s: Solid) => number[], at: number): Number_ => ({
    label: `${label}, body ${index + 1}`,
    range,
    get: (setting) => list(solid(setting))[at] as number,
    set: (setting, value) => {
      list(solid(setting))[at] = value;
    },
  });
  return [
    ...["a", "b", "c"].map((name, at) => part(name, AXIS, (s) => s.axes, at)),
    ...["n1", "n2"].map((name, at) => part(name, EXPONENT, (s) => s.exponents, at)),
    ...["phi°", "theta°", "psi°"].map((name, at) => part(name, at === 1 ? HALF : CIRCLE, (s) => s.euler, at)),
  ];
}

const PLACE: Number_[] = [
  {
    label: "overlap ratio",
    range: RATIO,
    get: ({ distance }, touch) => 1 - distance / touch,
    set: (setting, value, touch) => {
      setting.distance = touch * (1 - value);
    },
  },
  {
    label: "line's zenith°",
    range: HALF,
    get: ({ line }) => line[0],
    set: (setting, value) => {
      setting.line[0] = value;
    },
  },
  {
    label: "line's azimuth°",
    range: CIRCLE,
    get: ({ line }) => line[1],
    set: (setting, value) => {
      setting.line[1] = value;
    },
  },
];

const shown = (x: number): string => (Number.isFinite(x) ? String(Number(x.toFixed(4))) : "–");

/** Follows the setting by `show`; what the reader moves goes to `change`. */
export class Sliders {
  readonly element: HTMLElement;
  private readonly shows: ((setting: Setting, touch: number) => void)[] = [];
  private touch = Number.NaN;

  constructor(private readonly change: (apply: (setting: Setting) => void) => void) {
    this.element = h(
      "div",
      { class: "sliders" },
      this.group("Body 1", ofSolid(0)),
      this.group("Body 2", ofSolid(1)),
      this.group("Where body 2 is", PLACE),
    );
  }

  private group(title: string, numbers: Number_[]): HTMLElement {
    return h("fieldset", {}, h("legend", {}, title), ...numbers.map((one) => this.slider(one)));
  }

  private slider({ label, range, get, set }: Number_): HTMLElement {
    const output = h("span", { class: "value" });
    const input = h("input", {
      type: "range",
      min: range.least,
      max: range.most,
      step: range.step,
      "data-number": label,
      input: () => this.change((setting) => set(setting, Number(input.value), this.touch)),
    });
    this.shows.push((setting, touch) => {
      const value = get(setting, touch);
      input.disabled = !Number.isFinite(value);
      if (document.activeElement !== input || Number(input.value) !== value) input.value = String(value);
      output.textContent = shown(value);
    });
    return h("label", { class: "slider" }, h("span", {}, label.replace(/, body .*/, "")), input, output);
  }

  show(setting: Setting, touch: number): void {
    this.touch = touch;
    for (const show of this.shows) show(setting, touch);
  }
}
