/** The share of failures with its interval, a panel a family. */
import type { Annotations, Data, Layout, Shape } from "plotly.js";
import type { Family, MethodRow, Run } from "../data";
import { type LogScale, logAxis, logScale, marginLabels, marginShapes } from "../log_scale";
import { colourOf, inOrder, isOwn, symbolOf } from "../methods";
import { percent, shareWithInterval } from "../numbers";
import { type Drawing, figure, plain, short } from "../plot";
import { methodName } from "../swatch";
import { table } from "../table";
import { ink } from "../theme";

const NARROW = 760;

interface Row {
  family: Family;
  row: MethodRow;
}

const rowsOf = (run: Run): Row[] => run.families.flatMap((family) => family.methods.map((row) => ({ family, row })));
const methodsOf = (run: Run): string[] => inOrder(rowsOf(run).map(({ row }) => row.method));

function scaleOf(run: Run): LogScale {
  const shares = rowsOf(run)
    .filter(({ row }) => row.failures.share !== null)
    .flatMap(({ row }) => [row.failures.share, row.failures.low, row.failures.high].map((x) => 100 * (x ?? 0)));
  return logScale([...shares.filter((x) => x > 1e-4), 100, 0]);
}

function whiskers(rows: MethodRow[], at: (x: number | null) => number): object {
  return {
    type: "data",
    symmetric: false,
    array: rows.map((row) => at(row.failures.high) - at(row.failures.share)),
    arrayminus: rows.map((row) => at(row.failures.share) - Math.max(at(row.failures.low), at(0))),
    color: ink().muted,
    thickness: 1.3,
    width: 3,
  };
}

function trace(family: Family, scale: LogScale, suffix: string): Data {
  const rows = family.methods.filter((row) => row.failures.share !== null);
  const at = (x: number | null) => scale.place(100 * (x ?? 0));
  return {
    type: "scatter",
    mode: "markers",
    xaxis: `x${suffix}`,
    yaxis: `y${suffix}`,
    x: rows.map((row) => at(row.failures.share)),
    y: rows.map((row) => short(row.method)),
    error_x: whiskers(rows, at),
    marker: {
      opacity: 1,
      line: { width: 0 },
      size: rows.map((row) => (isOwn(row.method) ? 11 : 9)),
      symbol: rows.map((row) => symbolOf(row.method)),
      color: rows.map((row) => colourOf(row.method)),
    },
    text: rows.map((row) => `<b>${plain(row.method)}</b>, ${plain(family.name)}<br>${shareWithInterval(row.failures)}`),
    hovertemplate: "%{text}<extra></extra>",
  } as Data;
}

/** Side by side, or one below the other where the page is narrow. */
function domains(index: number, of: number, narrow: boolean): { x: number[]; y: number[] } {
  const gap = narrow ? 0.3 / of : 0.012;
  const size = (1 - gap * (of - 1)) / of;
  const from = index * (size + gap);
  return narrow ? { x: [0, 1], y: [1 - from - size, 1 - from] } : { x: [from, from + size], y: [0, 1] };
}

function axes(run: Run, index: number, scale: LogScale, narrow: boolean): Partial<Layout> {
  const suffix = index === 0 ? "" : String(index + 1);
  const { x, y } = domains(index, run.families.length, narrow);
  const methods = methodsOf(run);
  const category = {
    type: "category",
    categoryorder: "array",
    categoryarray: methods.map((name) => short(name)).reverse(),
    range: [-0.6, methods.length - 0.4],
    gridcolor: ink().grid,
    fixedrange: true,
    showticklabels: narrow || index === 0,
  };
  return {
    [`xaxis${suffix}`]: { ...logAxis(scale, ""), domain: x, anchor: `y${suffix}`, fixedrange: true, nticks: 5 },
    [`yaxis${suffix}`]: { ...category, domain: y, anchor: `x${suffix}` },
  } as Partial<Layout>;
}

/** The family's name above its panel, the floor below it. */
function marks(family: Family, suffix: string, scale: LogScale): { annotations: object[]; shapes: object[] } {
  const here = { xref: `x${suffix}`, yref: `y${suffix} domain` };
  const title = {
    xref: `x${suffix} domain`,
    yref: `y${suffix} domain`,
    x: 0.5,
    y: 1,
    yanchor: "bottom",
    yshift: 2,
    text: `<b>${short(family.name)}</b>`,
    showarrow: false,
  };
  return {
    annotations: [title, ...marginLabels(scale, "x", "").map((label) => ({ ...label, ...here }))],
    shapes: marginShapes(scale, "x").map((shape) => ({ ...shape, ...here })),
  };
}

function draw(run: Run, width: number): Drawing {
  const narrow = width < NARROW;
  const scale = scaleOf(run);
  const layout: Partial<Layout> = { margin: { l: narrow ? 182 : 200, r: 16, t: 26, b: 40 } };
  const annotations: object[] = [];
  const shapes: object[] = [];
  const data = run.families.map((family, index) => {
    const suffix = index === 0 ? "" : String(index + 1);
    const extra = marks(family, suffix, scale);
    Object.assign(layout, axes(run, index, scale, narrow));
    annotations.push(...extra.annotations);
    shapes.push(...extra.shapes);
    return trace(family, scale, suffix);
  });
  layout.annotations = annotations as Partial<Annotations>[];
  layout.shapes = shapes as Partial<Shape>[];
  return { data, layout };
}

function describe(run: Run): string {
  const worst = [...rowsOf(run)].sort((a, b) => (b.row.failures.share ?? 0) - (a.row.failures.share ?? 0))[0];
  const words = worst
    ? ` Highest: ${worst.row.method} in ${worst.family.name}, ${percent(worst.row.failures.share)} %.`
    : "";
  return `Dot plot: share of judged answers that break a law, with 95 % intervals, by method, a panel a family.${words}`;
}

export function failureIntervals(run: Run): HTMLElement {
  const methods = methodsOf(run).length;
  const columns = [
    { title: "Family", head: true, cell: ({ family }: Row) => family.name },
    { title: "Method", cell: ({ row }: Row) => methodName(row.method) },
    { title: "Failures, % (95 %)", figure: true, cell: ({ row }: Row) => shareWithInterval(row.failures) },
  ];
  return figure({
    caption: "Answers that break a law, % of the judged, logarithmic; whiskers: exact 95 % interval",
    describe: () => describe(run),
    zoom: false,
    height: (width) => (width < NARROW ? run.families.length * (methods * 19 + 56) + 40 : methods * 24 + 80),
    draw: (width) => draw(run, width),
    table: () => table({ caption: "Failures by family and method", columns, rows: rowsOf(run), hideCaption: true }),
  }).element;
}
