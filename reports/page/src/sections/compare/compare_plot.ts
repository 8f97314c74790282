/** Before against after: what lies above the diagonal has grown. */
import type { Data } from "plotly.js";
import type { Comparison, ComparisonRow } from "../../data";
import { h, select } from "../../dom";
import { logAxis, logScale, marginLabels, marginShapes } from "../../log_scale";
import { type Drawing, type Figure, figure, plain } from "../../plot";
import { table } from "../../table";
import { ink } from "../../theme";
import { MARKS, show } from "./compare_words";

type Unit = ComparisonRow["unit"];
const UNITS: Record<Unit, string> = { share: "share, %", deg: "angle, °", relative: "relative error", count: "count" };
const SYMBOLS: Record<ComparisonRow["verdict"], string> = {
  worse: "triangle-up",
  better: "triangle-down",
  noise: "circle-open",
  same: "line-ew-open",
};

function colourOf(verdict: ComparisonRow["verdict"]): string {
  const { good, bad, muted } = ink();
  return verdict === "worse" ? bad : verdict === "better" ? good : muted;
}

const shown = (value: number | null, unit: Unit): number | null =>
  value === null ? null : unit === "share" ? 100 * value : value;

function hoverText(row: ComparisonRow): string {
  const what = `<b>${plain(`${row.family}, ${row.method}`)}</b><br>${plain(row.measure)}: ${MARKS[row.verdict]}`;
  return `${what}<br>${show(row.before, row.unit)} → ${show(row.after, row.unit)}`;
}

function draw(rows: ComparisonRow[], comparison: Comparison, unit: Unit): Drawing {
  const scale = logScale(rows.flatMap((row) => [shown(row.before, unit), shown(row.after, unit)]));
  const verdicts = ["same", "noise", "better", "worse"] as const;
  const trace = (verdict: ComparisonRow["verdict"]) => {
    const these = rows.filter((row) => row.verdict === verdict);
    return {
      type: "scatter",
      mode: "markers",
      x: these.map((row) => scale.place(shown(row.before, unit))),
      y: these.map((row) => scale.place(shown(row.after, unit))),
      marker: {
        symbol: SYMBOLS[verdict],
        color: colourOf(verdict),
        size: 10,
        line: { width: 1.5, color: colourOf(verdict) },
      },
      hovertext: these.map(hoverText),
      hovertemplate: "%{hovertext}<extra></extra>",
    } as Data;
  };
  const ends = scale.range.map((power) => 10 ** power);
  const diagonal = {
    type: "scatter",
    mode: "lines",
    x: ends,
    y: ends,
    hoverinfo: "skip",
    line: { color: ink().muted, width: 1 },
  };
  const axis = (name: string) => logAxis(scale, `${name}: ${UNITS[unit]}`);
  return {
    data: [diagonal as Data, ...verdicts.map(trace)],
    layout: {
      xaxis: axis("before"),
      yaxis: axis("after"),
      margin: { l: 78, r: 16, t: 10, b: 52 },
      shapes: [...marginShapes(scale, "x"), ...marginShapes(scale, "y")],
      annotations: [...marginLabels(scale, "x", "none"), ...marginLabels(scale, "y", "none")],
      uirevision: `${comparison.after} ${unit}`,
    },
  };
}

function describe(rows: ComparisonRow[], unit: Unit): string {
  const worse = rows
    .filter((row) => row.verdict === "worse")
    .map((row) => `${row.family} ${row.method} ${row.measure}`);
  const words = worse.length > 0 ? `Worse: ${worse.slice(0, 5).join("; ")}.` : "None is worse.";
  return `Scatter plot of ${rows.length} figures (${UNITS[unit]}), before against after, both logarithmic. ${words}`;
}

export function comparisonFigure(comparison: Comparison, rows: () => ComparisonRow[]): Figure {
  const known = (Object.keys(UNITS) as Unit[]).filter((unit) => comparison.rows.some((row) => row.unit === unit));
  let unit: Unit = known[0] ?? "share";
  const these = () => rows().filter((row) => row.unit === unit);
  const columns = [
    { title: "Family", head: true, cell: (row: ComparisonRow) => row.family },
    { title: "Method", cell: (row: ComparisonRow) => row.method },
    { title: "Measure", cell: (row: ComparisonRow) => row.measure },
    { title: "Before", figure: true, cell: (row: ComparisonRow) => show(row.before, row.unit) },
    { title: "After", figure: true, cell: (row: ComparisonRow) => show(row.after, row.unit) },
  ];
  const pick = select(
    "Figures",
    known.map((key) => [key, UNITS[key]]),
    unit,
    (value) => {
      unit = value as Unit;
      plot.redraw();
    },
  );
  const plot: Figure = figure({
    caption: "Before and after: above the diagonal it has grown (▲ worse, ▼ better, ○ noise, – same)",
    describe: () => describe(these(), unit),
    height: (width) => Math.min(560, Math.max(360, width * 0.8)),
    draw: () => draw(these(), comparison, unit),
    table: () => table({ caption: "Before and after", columns, rows: these(), hideCaption: true }),
  });
  return { ...plot, element: h("div", {}, h("div", { class: "controls" }, pick), plot.element) };
}
