import type { Atlas, Cell, Run } from "../data";
import { fill, h, section, select } from "../dom";
import { made } from "../made";
import { inOrder } from "../methods";
import { count, number, percent } from "../numbers";
import { type Figure, figure } from "../plot";
import { perRun, type State } from "../state";
import { type Column, table } from "../table";
import { type AtlasMeasure, atlasDrawing, FEW, MEASURE_NAMES, measureOf } from "./atlas_plot";

interface AtlasView {
  family: string;
  method: string;
  measure: AtlasMeasure;
}

const MAP_NAMES: Record<Atlas["map"], string> = {
  "aspect-overlap": "Aspect and overlap",
  "exponent-tilt": "Exponents and tilt",
};

function columnsOf(atlas: Atlas): Column<Cell>[] {
  return [
    { title: atlas.x.title, head: true, cell: (cell) => atlas.x.labels[cell.x] ?? String(cell.x) },
    { title: atlas.y.title, cell: (cell) => atlas.y.labels[cell.y] ?? String(cell.y) },
    { title: "Answers", figure: true, cell: (cell) => count(cell.answers) },
    { title: "Judged", figure: true, cell: (cell) => count(cell.judged) },
    { title: "Failures", figure: true, cell: (cell) => count(cell.failures) },
    { title: "Failures, %", figure: true, cell: (cell) => percent(measureOf(cell, "failures")) },
    { title: "Not converged", figure: true, cell: (cell) => count(cell.not_converged) },
    { title: "Iterations, mean", figure: true, cell: (cell) => number(cell.iterations) },
  ];
}

function describe(atlas: Atlas, view: AtlasView): string {
  const sure = atlas.cells.filter((cell) => cell.judged >= FEW);
  const worst = sure.sort((a, b) => (measureOf(b, view.measure) ?? 0) - (measureOf(a, view.measure) ?? 0))[0];
  const where = worst
    ? ` Highest where ${atlas.x.title} is ${atlas.x.labels[worst.x]} and ${atlas.y.title} is ${atlas.y.labels[worst.y]}: ${
        view.measure === "iterations" ? number(worst.iterations) : `${percent(measureOf(worst, view.measure))} %`
      }.`
    : "";
  return `Heat map: ${MEASURE_NAMES[view.measure]} of ${view.method} in ${view.family}, over ${atlas.x.title} and ${atlas.y.title}.${where}`;
}

function mapFigure(atlas: Atlas, view: AtlasView): Figure {
  return figure({
    caption: `${MAP_NAMES[atlas.map]}: ${MEASURE_NAMES[view.measure]} of ${view.method}, ${view.family}`,
    describe: () => describe(atlas, view),
    zoom: false,
    height: (width) => Math.min(520, Math.max(330, width * 0.72)) + 40,
    draw: (width) => atlasDrawing(atlas, view.measure, width),
    table: () =>
      table({ caption: MAP_NAMES[atlas.map], columns: columnsOf(atlas), rows: atlas.cells, hideCaption: true }),
  });
}

function maps(run: Run, view: AtlasView): HTMLElement[] {
  const chosen = run.atlases.filter((atlas) => atlas.family === view.family && atlas.method === view.method);
  if (chosen.length === 0) return [h("p", { class: "empty" }, `No map of ${view.method} in ${view.family}.`)];
  return chosen.map((atlas) =>
    atlas.cells.length > 0
      ? mapFigure(atlas, view).element
      : h("p", { class: "empty" }, `${MAP_NAMES[atlas.map]}: no answers to show.`),
  );
}

/** A map of zeros says little: it opens on the method with most to see. */
function mostFailing(run: Run, family: string): string {
  const failures = (atlas: Atlas) => atlas.cells.reduce((sum, cell) => sum + cell.failures, 0);
  const here = run.atlases.filter((atlas) => atlas.family === family);
  return here.reduce((most, atlas) => (failures(atlas) > failures(most) ? atlas : most)).method;
}

function content(run: Run, view: AtlasView): HTMLElement[] {
  if (run.atlases.length === 0) return [h("p", { class: "empty" }, "This run holds no maps.")];
  const families = [...new Set(run.atlases.map((atlas) => atlas.family))];
  const methods = inOrder(run.atlases.map((atlas) => atlas.method));
  if (!families.includes(view.family)) view.family = families[0] as string;
  if (!methods.includes(view.method)) view.method = mostFailing(run, view.family);
  const place = h("div", { class: "maps" });
  const redraw = () => fill(place, ...maps(run, view));
  const choice = (label: string, key: keyof AtlasView, values: [string, string][]) =>
    select(label, values, view[key], (value) => {
      Object.assign(view, { [key]: value });
      redraw();
    });
  const named = (names: string[]) => names.map((name): [string, string] => [name, name]);
  redraw();
  return [
    h(
      "div",
      { class: "controls" },
      choice("Family", "family", named(families)),
      choice("Method", "method", named(methods)),
      choice("Colour", "measure", Object.entries(MEASURE_NAMES)),
    ),
    place,
    made(
      run.families.map(({ command }) => command),
      "a command for each family of pairs",
    ),
    h(
      "p",
      { class: "note" },
      `Pale cells with “n=…” or “?” hold fewer than ${FEW} answers to count; empty cells hold none.`,
    ),
  ];
}

export function atlasSection(state: State): HTMLElement {
  const view: AtlasView = { family: "", method: "", measure: "failures" };
  const place = perRun(state, h("div"), (run) => content(run, view));
  return section("atlas", "Failure atlas", "Which pairs make a method fail, or work hard?", place);
}
