/** Time against error, and failures against the same error: two panels that zoom together. */
import type { Annotations, Data, Layout, Shape } from "plotly.js";
import type { PrecisionPoint, PrecisionSet } from "../data";
import { type LogScale, logAxis, logScale, marginLabels, marginShapes } from "../log_scale";
import { colourOf, dashOf, isOwn, symbolIn } from "../methods";
import { type Drawing, short, wrapped } from "../plot";
import { ink } from "../theme";
import { type Named, nameAnnotations } from "./certificate_labels";
import { axisTitle, isShown, pointFigures, pointName, type View } from "./precision_words";

const NARROW = 600;
const MARGIN = { l: 68, r: 22, t: 10, b: 52 };
/** The panel of times begins there, from below. */
const UPPER_FROM = 0.32;

export const workHeight = (width: number): number => (width < NARROW ? 560 : 680);

const shownEnvelopes = (view: View): PrecisionSet["envelopes"] =>
  view.set.envelopes.filter(({ scalar }) => !view.hiddenScalars.has(scalar));

const errorOf = (view: View, point: PrecisionPoint): number | null => point[view.measure][view.quantile];

/** The contract of the document's own front: common normals, 99 answers in 100, nothing certified. */
const mayLead = (point: PrecisionPoint): boolean =>
  point.problem === "common_normal" && point.certificate === "" && point.failed <= 0.01;

/** The points shown that none of the others beats in both time and error, the quickest first. */
export function frontOf(view: View, points: PrecisionPoint[]): PrecisionPoint[] {
  const candidates = points.filter((point) => mayLead(point) && errorOf(view, point) !== null);
  candidates.sort((a, b) => a.median_ns - b.median_ns);
  let least = Number.POSITIVE_INFINITY;
  return candidates.filter((point) => {
    const error = errorOf(view, point) as number;
    const leads = error < least;
    if (leads) least = error;
    return leads;
  });
}

function hoverText(point: PrecisionPoint, width: number): string {
  const columns = Math.max(34, Math.min(72, Math.floor(width / 9)));
  const lines = pointFigures(point).map((line) => wrapped(line, columns));
  return [`<b>${wrapped(pointName(point), columns)}</b>`, ...lines, `<i>${wrapped(point.command, columns)}</i>`].join(
    "<br>",
  );
}

function groups(points: PrecisionPoint[]): PrecisionPoint[][] {
  const grouped = new Map<string, PrecisionPoint[]>();
  for (const point of points) {
    const key = `${point.method}|${point.scalar}|${point.certificate ? "certified" : ""}`;
    grouped.set(key, [...(grouped.get(key) ?? []), point]);
  }
  for (const group of grouped.values()) group.sort((a, b) => b.tolerance - a.tolerance);
  return [...grouped.values()];
}

interface Panel {
  view: View;
  scale: LogScale;
  width: number;
}

function marker(first: PrecisionPoint, certified: boolean): object {
  const colour = colourOf(first.method);
  const size = certified ? 13 : isOwn(first.method) ? 9.5 : 8;
  const symbol = certified ? "circle-cross-open" : symbolIn(first.method, first.scalar);
  return { symbol, size, color: colour, line: { width: certified ? 2 : 1.4, color: colour } };
}

function trace(group: PrecisionPoint[], panel: Panel, below: boolean): Data {
  const first = group[0] as PrecisionPoint;
  const certified = first.certificate !== "";
  const { view, scale, width } = panel;
  return {
    type: "scatter",
    mode: certified ? "markers" : "lines+markers",
    yaxis: below ? "y2" : "y",
    x: group.map((point) => scale.place(errorOf(view, point))),
    y: group.map((point) => (below ? 100 * point.failed : point.median_ns)),
    line: { color: colourOf(first.method), width: isOwn(first.method) ? 2.4 : 1.4, dash: dashOf(first.scalar) },
    marker: marker(first, certified),
    cliponaxis: false,
    customdata: group.map((point) => view.set.points.indexOf(point)),
    hovertext: group.map((point) => hoverText(point, width)),
    hovertemplate: "%{hovertext}<extra></extra>",
  } as object;
}

/** plumb's own first: they get the best places. */
function certificateNames(
  { view, scale, width }: Panel,
  points: PrecisionPoint[],
  times: LogScale,
): Partial<Annotations>[] {
  const [across, up] = [width - MARGIN.l - MARGIN.r, workHeight(width) - MARGIN.t - MARGIN.b];
  const part = (power: number, { range: [low, high] }: LogScale) => (power - low) / (high - low);
  const certified = points.filter(({ certificate }) => certificate !== "");
  certified.sort((a, b) => Number(isOwn(b.method)) - Number(isOwn(a.method)));
  const named = certified.map((point): Named => {
    const at: [number, number] = [Math.log10(scale.place(errorOf(view, point))), Math.log10(point.median_ns)];
    const pixel: [number, number] = [part(at[0], scale) * across, -part(at[1], times) * up * (1 - UPPER_FROM)];
    return { text: short(`+ ${point.certificate}`), colour: colourOf(point.method), at, pixel };
  });
  return nameAnnotations(named, across);
}

function frontTrace({ view, scale }: Panel, points: PrecisionPoint[]): Data {
  const front = frontOf(view, points);
  return {
    type: "scatter",
    mode: "lines",
    x: front.map((point) => scale.place(errorOf(view, point))),
    y: front.map((point) => point.median_ns),
    line: { color: ink().front, width: 12, shape: "vh" },
    hoverinfo: "skip",
  } as Data;
}

/** By scalar, what the condition numbers allow: a line at the chosen figure, a band from the median to the greatest. */
function envelopes({ view, scale, width }: Panel): { shapes: Partial<Shape>[]; annotations: Partial<Annotations>[] } {
  const { band, muted, paper } = ink();
  const shown = shownEnvelopes(view);
  const across = { xref: "x", yref: "paper", y0: 0, y1: 1, layer: "below" };
  const shapes = shown.flatMap((envelope) => {
    const { median, max, [view.quantile]: at } = envelope[view.measure];
    if (at === null) return [];
    const whole = { type: "rect", x0: scale.place(median ?? at), x1: scale.place(max ?? at), fillcolor: band };
    const line = {
      type: "line",
      x0: scale.place(at),
      x1: scale.place(at),
      line: { color: muted, width: 1.5, dash: "dash" },
    };
    return [
      { ...across, ...whole, line: { width: 0 } },
      { ...across, ...line },
    ];
  });
  const annotations = shown.flatMap((envelope, index) => {
    const at = envelope[view.measure][view.quantile];
    if (at === null) return [];
    const text = short(envelope.scalar) + (width < NARROW ? "" : ": condition × ε");
    const place = {
      xref: "x",
      yref: "paper",
      x: Math.log10(scale.place(at)),
      y: 0.285,
      yshift: index % 2 === 0 ? 9 : -9,
      xanchor: "center",
      yanchor: "middle",
    };
    return [
      {
        ...place,
        text,
        showarrow: false,
        bgcolor: paper,
        opacity: 0.9,
        font: { size: 11.5, color: muted },
      },
    ];
  });
  return { shapes: shapes as Partial<Shape>[], annotations: annotations as Partial<Annotations>[] };
}

function axesOf({ view, scale, width }: Panel, times: LogScale): Partial<Layout> {
  const { grid } = ink();
  const ticks = {
    tickvals: [1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9],
    ticktext: ["0.1 µs", "1 µs", "10 µs", "0.1 ms", "1 ms", "10 ms", "0.1 s", "1 s"],
  };
  return {
    xaxis: { ...logAxis(scale, axisTitle(view), width < NARROW ? 5 : 9), anchor: "y2" },
    yaxis: {
      type: "log",
      range: [...times.range],
      domain: [UPPER_FROM, 1],
      title: { text: "median time" },
      gridcolor: grid,
      ...ticks,
    },
    yaxis2: {
      range: [-6, 106],
      domain: [0, 0.25],
      title: { text: "no answer, %" },
      gridcolor: grid,
      zeroline: false,
      dtick: 50,
    },
  } as Partial<Layout>;
}

export function workPrecision(view: View, width: number): Drawing {
  const points = view.set.points.filter((point) => isShown(view, point));
  const allowed = shownEnvelopes(view)
    .map((envelope) => envelope[view.measure][view.quantile])
    .filter((x) => x !== null);
  const scale = logScale([...points.map((point) => errorOf(view, point)), ...allowed]);
  const times = logScale(points.map((point) => point.median_ns));
  const panel: Panel = { view, scale, width };
  const { shapes, annotations } = envelopes(panel);
  const data = groups(points).flatMap((group) => [trace(group, panel, false), trace(group, panel, true)]);
  const layout: Partial<Layout> = {
    ...axesOf(panel, times),
    margin: MARGIN,
    shapes: [...marginShapes(scale, "x"), ...shapes],
    annotations: [...marginLabels(scale, "x", "no answer"), ...annotations, ...certificateNames(panel, points, times)],
    uirevision: `${view.set.name} ${view.measure} ${view.quantile}`,
  };
  return { data: [frontTrace(panel, points), ...data], layout };
}

export function describeWorkPrecision(view: View): string {
  const front = frontOf(view, view.set.points);
  const leaders = [...new Set(front.map((point) => `${point.method} in ${point.scalar}`))].join(", ");
  return `Scatter plot, both axes logarithmic: median time against ${axisTitle(view)}, ${view.set.points.length} points of ${view.set.of}; below it the share without an answer against the same error. On the front: ${leaders || "nothing"}.`;
}
