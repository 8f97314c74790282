import { command } from "../commands";
import type { Precision, PrecisionPoint } from "../data";
import { button, h, section, select, unique } from "../dom";
import { inOrder, scalarsInOrder } from "../methods";
import { made } from "../made";
import { count, error, number, onMachine, percent, time } from "../numbers";
import { figure } from "../plot";
import type { State } from "../state";
import { legend, methodName, scalarSwatch } from "../swatch";
import { type Column, table } from "../table";
import { describePaths, type Path, pathsDrawing, shownPaths } from "./paths";
import {
  MEASURES,
  type Measure,
  pointFigures,
  pointName,
  QUANTILES,
  type Quantile,
  type View,
} from "./precision_words";
import { describeWorkPrecision, workHeight, workPrecision } from "./work_precision";

const QUESTION = "Which method, which precision, which tolerance, at what price, and how often does it fail?";

/** Paper has room for the normal alone. */
const quantiles = (key: Measure): Column<PrecisionPoint> => ({
  screenOnly: key !== "normal",
  title: `${key}: median / p99 / max`,
  figure: true,
  cell: (point) => [point[key].median, point[key].p99, point[key].max].map(error).join(" / "),
});

const COLUMNS: Column<PrecisionPoint>[] = [
  { title: "Method", head: true, cell: (point) => methodName(point.method) },
  { title: "Scalar", cell: (point) => point.scalar },
  { title: "Tolerance", figure: true, cell: (point) => error(point.tolerance) },
  { title: "Certificate", cell: (point) => point.certificate || "none" },
  { title: "Time: median / p99", figure: true, cell: (point) => `${time(point.median_ns)} / ${time(point.p99_ns)}` },
  {
    title: "Iterations",
    figure: true,
    cell: (point) => `${number(point.iterations.median)} / ${number(point.iterations.max)}`,
  },
  { title: "No answer, %", figure: true, cell: (point) => percent(point.failed) },
  { title: "Off, %", figure: true, cell: (point) => percent(point.off) },
  ...MEASURES.map(([key]) => quantiles(key)),
  {
    title: "Front",
    hint: "Of the document: median time against the p99 of the normal",
    cell: (point) => (point.pareto ? "yes" : ""),
  },
  { title: "Command", screenOnly: true, cell: (point) => h("code", {}, point.command) },
];

interface PathRow {
  path: Path;
  step: Path["steps"][number];
}

const PATH_COLUMNS: Column<PathRow>[] = [
  { title: "Method", head: true, cell: ({ path }) => methodName(path.method) },
  { title: "Iterations", figure: true, cell: ({ step }) => String(step.iterations) },
  ...(["normal", "overlap"] as const).map((key): Column<PathRow> => ({
    title: `${key}: median / p99 / max`,
    figure: true,
    cell: ({ step }) => [step[key].median, step[key].p99, step[key].max].map(error).join(" / "),
  })),
];

/** Points that the reader clicked, with their commands. */
class Pins {
  readonly element = h("div", { class: "pins", "aria-live": "polite" });
  private readonly kept = new Set<string>();

  add(name: string, figures: string[], text: string): void {
    const key = `${name} ${text}`;
    if (this.kept.has(key)) return;
    this.kept.add(key);
    const remove = () => {
      this.kept.delete(key);
      pin.remove();
    };
    const close = button("Remove", remove, { class: "quiet", "aria-label": `Remove ${name}` });
    const head = h("div", { class: "pin-head" }, h("strong", {}, name), close);
    const pin: HTMLElement = h(
      "div",
      { class: "pin" },
      head,
      h("p", { class: "note" }, figures.join("; ")),
      command(text),
    );
    this.element.prepend(pin);
  }
}

function frontNote(place: HTMLElement, { set }: View): void {
  place.className = `verdict ${set.auto_on_front ? "good" : "bad"}`;
  place.textContent = set.front_note;
}

/** On how many pairs the figures stand. */
const standing = ({ set }: View): string =>
  set.pairs < 100
    ? `${set.pairs} pairs: the p99 of fewer than 100 is their greatest; 0 failures of ${set.pairs} leave up to ${percent(1 - 0.025 ** (1 / set.pairs))} % possible.`
    : `${set.pairs} pairs.`;

function settings(precision: Precision, view: View, changed: () => void): HTMLElement {
  const sets = precision.sets.map(({ name, of }, index): [string, string] => [String(index), `${name}: ${of}`]);
  const pickSet = (index: string) => {
    view.set = precision.sets[Number(index)] ?? view.set;
    changed();
  };
  const pickMeasure = (key: string) => {
    view.measure = key as Measure;
    changed();
  };
  const pickQuantile = (key: string) => {
    view.quantile = key as Quantile;
    changed();
  };
  return h(
    "div",
    { class: "controls" },
    select("Pairs", sets, "0", pickSet),
    select("Error of", MEASURES, view.measure, pickMeasure),
    select("Figure", QUANTILES, view.quantile, pickQuantile),
  );
}

function legends(precision: Precision, view: View, changed: () => void): HTMLElement {
  const points = precision.sets.flatMap((set) => set.points);
  const scalarName = (scalar: string) => h("span", { class: "method" }, scalarSwatch(scalar), scalar);
  const methods = legend("Methods", inOrder(points.map((point) => point.method)), methodName, view.hidden, changed);
  const scalars = legend(
    "Scalars",
    scalarsInOrder(points.map((point) => point.scalar)),
    scalarName,
    view.hiddenScalars,
    changed,
  );
  return h("div", { class: "legends" }, methods, scalars);
}

function workFigure(view: View, pins: Pins) {
  return figure({
    caption: "Median time against error (lower left is better), and the share of pairs without an answer",
    describe: () => describeWorkPrecision(view),
    height: workHeight,
    draw: (width) => workPrecision(view, width),
    table: () =>
      table({ caption: `All points of ${view.set.name}`, columns: COLUMNS, rows: view.set.points, hideCaption: true }),
    clicked: (index) => {
      const point = view.set.points[index as number];
      if (point) pins.add(`${pointName(point)}, ${view.set.name}`, pointFigures(point), point.command);
    },
  });
}

function pathsFigure(view: View, scalar: () => string, pins: Pins) {
  const rows = () => shownPaths(view, scalar()).flatMap((path) => path.steps.map((step) => ({ path, step })));
  return figure({
    caption: "Error against iterations: solid and filled the median, dotted and open the p99",
    describe: () => describePaths(view, scalar()),
    height: (width) => (width < 600 ? 360 : 420),
    draw: (width) => pathsDrawing(view, scalar(), width),
    table: () => table({ caption: "Error against iterations", columns: PATH_COLUMNS, rows: rows(), hideCaption: true }),
    clicked: (index) => {
      const path = view.set.paths[index as number];
      if (path) pins.add(`${path.method}, ${path.scalar}, error against iterations`, [], path.command);
    },
  });
}

/** Of the paths, double first. */
function scalarsOf(precision: Precision): string[] {
  const scalars = unique(precision.sets.flatMap((set) => set.paths.map((path) => path.scalar)));
  return scalars.sort((a, b) => Number(b === "double") - Number(a === "double"));
}

const cutShort = ({ without }: Precision): string =>
  without.length > 0 ? ` (interrupted: without ${without.join(", ")})` : "";

function content(precision: Precision, view: View): HTMLElement[] {
  const pins = new Pins();
  const note = h("p");
  const scalars = scalarsOf(precision);
  let scalar = scalars[0] ?? "double";
  const work = workFigure(view, pins);
  const paths = pathsFigure(view, () => scalar, pins);
  const pairs = h("p", { class: "note" }, standing(view));
  const redraw = () => {
    frontNote(note, view);
    pairs.textContent = standing(view);
    work.redraw();
    paths.redraw();
  };
  const pickScalar = (value: string) => {
    scalar = value;
    paths.redraw();
  };
  frontNote(note, view);
  const key = h(
    "p",
    { class: "note" },
    "A line joins the tolerances of one method in one scalar. Broad yellow: the front, of common-normal methods that answer 99 in 100 pairs. Dashed upright lines and bands: the least error that the condition numbers allow. Crossed circles: a certificate asked for beside the answer. Click or tap a point to keep its command.",
  );
  return [
    settings(precision, view, redraw),
    note,
    legends(precision, view, redraw),
    work.element,
    pairs,
    key,
    made([precision.command], "all sets"),
    pins.element,
    h("h3", {}, "How the error falls"),
    h(
      "p",
      { class: "note" },
      "Where convergence is quadratic, each step doubles the number of right digits and the line bends down; a straight line is linear convergence.",
    ),
    scalars.length > 1
      ? select(
          "Scalar",
          scalars.map((name) => [name, name]),
          scalar,
          pickScalar,
        )
      : h("span"),
    paths.element,
    made([precision.command], "all paths"),
    h(
      "p",
      { class: "note" },
      `${count(precision.sets.length)} sets, measured at commit ${precision.commit}${onMachine(precision.host)}${cutShort(precision)}:`,
    ),
    command(precision.command),
  ];
}

/** They stretch the axis by thirty decades. */
const HIDDEN_AT_FIRST = ["50 digits"];

export function precisionSection({ report: { precision } }: State): HTMLElement | null {
  const set = precision?.sets[0];
  if (!precision || !set) return null;
  const view: View = {
    set,
    measure: "normal",
    quantile: "p99",
    hidden: new Set(),
    hiddenScalars: new Set(HIDDEN_AT_FIRST),
  };
  return section("precision", "Work and precision", QUESTION, ...content(precision, view));
}
