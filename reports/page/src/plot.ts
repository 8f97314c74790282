/** A figure: drawn by Plotly when it comes into view, with a text alternative, buttons to zoom and the table behind it. */
import type { Config, Data, Layout, PlotlyHTMLElement, PlotMouseEvent } from "plotly.js";
import { button, type Child, details, freshId, h } from "./dom";
import { Mark } from "./plot_mark";
import { ink, theme } from "./theme";

export interface Drawing {
  data: Data[];
  layout: Partial<Layout>;
}

export interface FigureOptions {
  caption: string;
  /** What the picture shows, in words, for those who do not see it. */
  describe: () => string;
  height: (width: number) => number;
  draw: (width: number) => Drawing;
  table: () => Child;
  legend?: Child;
  /** Gets the point's customdata. */
  clicked?: (data: unknown) => void;
  zoom?: boolean;
  /** Paper does without the table. */
  longTable?: boolean;
}

export interface Figure {
  element: HTMLElement;
  redraw: () => void;
  /** An upright line at a value of the x axis. */
  mark: (x: number) => void;
}

type Library = typeof import("plotly.js-cartesian-dist-min");

const PAPER_WIDTH = 680;
const WIDEST = 1260;
const config: Partial<Config> = { displayModeBar: false, doubleClick: "reset", showTips: false };
const coarse = matchMedia("(pointer: coarse)");
const drawn = new Map<Element, (width?: number) => void>();
const waiting = new Map<Element, () => void>();

/** Of the figures that are still on the page. */
function drawAgain(width?: number): void {
  for (const [box, draw] of drawn) {
    if (box.isConnected) draw(width);
    else drawn.delete(box);
  }
}

theme.watch(() => drawAgain());

let Plotly: Library;

/** Read by the browser only when the first figure needs it. */
export async function loadPlotly(): Promise<void> {
  Plotly ??= await import("plotly.js-cartesian-dist-min");
}

const watcher = new IntersectionObserver(
  (entries) => {
    const seen = entries.filter((entry) => entry.isIntersecting).map((entry) => entry.target);
    if (seen.length > 0) void loadPlotly().then(() => seen.forEach(startDrawing));
  },
  { rootMargin: "200px" },
);

function startDrawing(box: Element): void {
  watcher.unobserve(box);
  const start = waiting.get(box);
  waiting.delete(box);
  start?.();
}

/** Every figure at the width of paper; without `on`, at its own width again. */
export function drawForPaper(on: boolean): void {
  if (!Plotly) return;
  for (const box of [...waiting.keys()]) startDrawing(box);
  drawAgain(on ? PAPER_WIDTH : undefined);
}

function commonLayout(width: number, height: number): Partial<Layout> {
  const { text, paper } = ink();
  return {
    width,
    height,
    paper_bgcolor: "rgba(0,0,0,0)",
    plot_bgcolor: "rgba(0,0,0,0)",
    font: { family: "system-ui, sans-serif", size: 12.5, color: text },
    showlegend: false,
    hovermode: "closest",
    dragmode: coarse.matches ? false : "zoom",
    hoverlabel: { align: "left", bgcolor: paper, bordercolor: text, font: { color: text, size: 12.5 } },
    margin: { l: 64, r: 14, t: 14, b: 48 },
  };
}

function freeAxes(box: HTMLElement): [string, [number, number]][] {
  const full = (box as unknown as { _fullLayout: Record<string, { range: [number, number]; fixedrange: boolean }> })
    ._fullLayout;
  return Object.keys(full)
    .filter((key) => /^[xy]axis\d*$/.test(key) && !full[key]?.fixedrange)
    .map((key) => [key, (full[key]?.range ?? [0, 1]).map(Number) as [number, number]]);
}

function zoomBy(box: HTMLElement, factor: number): void {
  const update: Record<string, unknown> = {};
  for (const [axis, [low, high]] of freeAxes(box)) {
    const middle = (low + high) / 2;
    update[`${axis}.range`] = [middle + (low - middle) * factor, middle + (high - middle) * factor];
  }
  void Plotly.relayout(box, update as Partial<Layout>);
}

function zoomButtons(box: HTMLElement, caption: string, reset: () => void): HTMLElement {
  const named = (label: string, meaning: string, pressed: () => void) =>
    button(label, pressed, { class: "quiet", "aria-label": `${meaning}: ${caption}`, title: meaning });
  return h(
    "div",
    { class: "tools" },
    named("+", "Zoom in", () => zoomBy(box, 0.6)),
    named("−", "Zoom out", () => zoomBy(box, 1 / 0.6)),
    named("Reset", "Reset the view", reset),
  );
}

function listenToClicks(box: HTMLElement, clicked: (data: unknown) => void): void {
  (box as unknown as PlotlyHTMLElement).on("plotly_click", (event: PlotMouseEvent) => {
    const data = event.points[0]?.customdata;
    if (data !== undefined) clicked(data);
  });
}

export function figure(options: FigureOptions): Figure {
  const box = h("div", { class: "plot", role: "img" });
  const inner = h("div");
  const mark = new Mark(inner);
  box.append(inner, mark.line);
  let started = false;
  let drawnWidth = 0;

  const draw = (width = box.clientWidth) => {
    if (width === 0) return;
    drawnWidth = width;
    const { data, layout } = options.draw(width);
    const whole = { ...commonLayout(width, options.height(width)), ...layout };
    void Plotly.react(inner, data, whole, config);
    box.style.minHeight = "";
    box.dataset.drawn = "true";
    if (!started) {
      if (options.clicked) listenToClicks(inner, options.clicked);
      (inner as unknown as PlotlyHTMLElement).on("plotly_afterplot", () => mark.place());
    }
    started = true;
  };
  const start = () => {
    draw();
    drawn.set(box, draw);
    new ResizeObserver(() => box.clientWidth !== drawnWidth && draw()).observe(box);
  };
  const behind = h("div");
  const refresh = () => {
    box.setAttribute("aria-label", options.describe());
    const print = options.longTable ? "closed" : undefined;
    behind.replaceChildren(details(`Table: ${options.caption}`, options.table, { "data-print": print }));
  };
  const reset = () => {
    Plotly.purge(inner);
    started = false;
    draw();
  };
  const redraw = () => {
    refresh();
    if (started) draw();
  };

  refresh();
  box.style.minHeight = `${options.height(Math.min(WIDEST, innerWidth - 2 * 16))}px`;
  waiting.set(box, start);
  watcher.observe(box);
  const caption = h("figcaption", { id: freshId("figure") }, options.caption);
  const tools = options.zoom === false ? null : zoomButtons(inner, options.caption, reset);
  const top = h("div", { class: "figure-top" }, caption, tools);
  return { element: h("figure", {}, top, options.legend, box, behind), redraw, mark: (x) => mark.to(x) };
}

/** Plotly reads some markup in its labels; the data's text must not become any. */
export const plain = (text: string): string => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");

/** For labels that must leave room for the plot. */
export const short = (text: string, most = 27): string =>
  plain(text.length > most ? `${text.slice(0, most - 1)}…` : text);

/** A command over several lines of a hover label, cut at blanks. */
export function wrapped(text: string, width: number): string {
  const lines: string[] = [];
  for (const word of text.split(" ")) {
    const last = lines[lines.length - 1];
    if (last !== undefined && last.length + word.length < width) lines[lines.length - 1] = `${last} ${word}`;
    else lines.push(word);
  }
  return lines.map(plain).join("<br>");
}
