/** Lines of methods in small panels, both axes logarithmic; and maps of the angle to the common normal. */
import type { Data, LayoutAxis, Shape } from "plotly.js";
import type { StudyAnswer, StudyLimit, StudyMap } from "../../data";
import { type LogScale, logAxis, logScale, marginLabels, marginShapes } from "../../log_scale";
import { colourOf, inOrder, isOwn, symbolOf } from "../../methods";
import { error, number } from "../../numbers";
import { type Drawing, plain } from "../../plot";
import { ink, theme } from "../../theme";
import { SCALES } from "../atlas_plot";
import { isOff, largestAngle, type Quantity, quantityName, sweepName } from "./study_words";

export interface Dot {
  method: string;
  x: number;
  y: number | null;
  words: string[];
}

interface Panel {
  dots: Dot[];
  /** Shared by panels side by side. */
  y: LogScale;
  yTitle: string;
  x: Partial<LayoutAxis>;
  shapes: Partial<Shape>[];
}

/** Of lines that coincide, what lies beneath is seen through the gaps and around the markers. */
const DASH_CYCLE = ["solid", "dash", "dot"] as const;

function line(method: string, index: number, { dots, y }: Panel): Data {
  const own = dots.filter((dot) => dot.method === method).sort((a, b) => a.x - b.x);
  const colour = colourOf(method);
  return {
    type: "scatter",
    mode: "lines+markers",
    x: own.map((dot) => dot.x),
    y: own.map((dot) => y.place(dot.y)),
    line: { color: colour, width: isOwn(method) ? 2.4 : 1.6, dash: DASH_CYCLE[index % DASH_CYCLE.length] },
    marker: { color: colour, symbol: symbolOf(method), size: Math.max(5.5, 10 - 1.2 * index) },
    cliponaxis: false,
    hovertext: own.map(({ words }) => [`<b>${plain(method)}</b>`, ...words.map(plain)].join("<br>")),
    hovertemplate: "%{hovertext}<extra></extra>",
  } as Data;
}

function panelDrawing(panel: Panel): Drawing {
  const methods = inOrder(panel.dots.map(({ method }) => method));
  return {
    data: methods.map((method, index) => line(method, index, panel)),
    layout: {
      xaxis: panel.x,
      yaxis: logAxis(panel.y, panel.yTitle, 6),
      margin: { l: 76, r: 12, t: 8, b: 44 },
      shapes: [...marginShapes(panel.y, "y"), ...panel.shapes],
      annotations: marginLabels(panel.y, "y", "no answer"),
    },
  };
}

const ratioAxis = (dots: Dot[]): Partial<LayoutAxis> => logAxis(logScale(dots.map(({ x }) => x)), "overlap ratio", 5);

/** Of values within a decade or two, each is written. */
export function valueAxis(at: number[], title: string): Partial<LayoutAxis> {
  const values = [...new Set(at)].sort((a, b) => a - b);
  const powers = values.map(Math.log10);
  const [low, high] = [Math.min(...powers), Math.max(...powers)];
  const rim = Math.max(0.05, 0.06 * (high - low));
  return {
    type: "log",
    range: [low - rim, high + rim],
    tickvals: values,
    ticktext: values.map((value) => number(value)),
    tickangle: 0,
    tickfont: { size: 11 },
    title: { text: title },
    gridcolor: ink().grid,
    zeroline: false,
  } as object;
}

export const angleScale = (answers: StudyAnswer[]): LogScale => logScale(answers.map(largestAngle));

const offLine = (): Partial<Shape> =>
  ({
    ...{ type: "line", xref: "paper", x0: 0, x1: 1, yref: "y", y0: 0.01, y1: 0.01, layer: "below" },
    line: { color: ink().bad, width: 1.2, dash: "dash" },
  }) as Partial<Shape>;

export function anglesDrawing(answers: StudyAnswer[], y: LogScale): Drawing {
  const dots = answers.map((answer): Dot => {
    const [dn1, dn2, nn] = (answer.angles_deg ?? []).map(error);
    const angles = dn1 ? [`d, n1: ${dn1}°`, `d, n2: ${dn2}°`, `n1, n2: ${nn}°`] : ["no answer"];
    const words = [`overlap ratio ${number(answer.ratio)}: ${answer.status}`, ...angles];
    return { method: answer.method, x: answer.ratio, y: largestAngle(answer), words };
  });
  return panelDrawing({ dots, y, yTitle: "largest angle, °", x: ratioAxis(dots), shapes: [offLine()] });
}

export const limitScale = (rows: StudyLimit[], quantity: Quantity): LogScale =>
  logScale(rows.map((row) => row[quantity]));

const AXIS_TITLES: Record<Quantity, string> = {
  angle_deg: "angle, °",
  point: "points / size",
  overlap: "overlap, relative",
};

export function limitsDrawing(rows: StudyLimit[], quantity: Quantity, y: LogScale): Drawing {
  const dots = rows.map((row): Dot => {
    const most = quantity === "angle_deg" ? [`at most ${error(row.angle_max_deg)}`] : [];
    const figures = [`median ${quantityName(quantity)}: ${error(row[quantity])}`, ...most];
    const words = [`${sweepName(row.sweep)} ${number(row.x)}`, ...figures, `${row.certified} of ${row.pairs} pairs`];
    return { method: row.system, x: row.x, y: row[quantity], words };
  });
  const sweep = rows[0]?.sweep ?? "";
  const values = dots.map(({ x }) => x);
  const x = sweep === "ratio" ? ratioAxis(dots) : valueAxis(values, plain(sweepName(sweep)));
  return panelDrawing({ dots, y, yTitle: AXIS_TITLES[quantity], x, shapes: [] });
}

/** What is nearer than the first, or further than the last, has their colour. */
export const MAP_RANGE: [number, number] = [1e-3, 180];
const placed = (deg: number): number => Math.log10(Math.min(MAP_RANGE[1], Math.max(MAP_RANGE[0], deg)));

function cells({ theta_deg, theta_L_deg, off_deg }: StudyMap): Data {
  const scale = SCALES[theme.value];
  const words = (row: number, column: number, deg: number | null) =>
    `θ_L ${number(theta_L_deg[row])}°, θ ${number(theta_deg[column])}°<br><b>${deg === null ? "no answer" : `${number(deg)}° off`}</b>${isOff(deg) ? " ✗" : ""}`;
  return {
    type: "heatmap",
    x: theta_deg,
    y: theta_L_deg,
    z: off_deg.map((row) => row.map((deg) => (deg === null ? null : placed(deg)))),
    zmin: placed(MAP_RANGE[0]),
    zmax: placed(MAP_RANGE[1]),
    colorscale: scale.map((colour, index) => [index / (scale.length - 1), colour]),
    showscale: false,
    hoverongaps: false,
    hovertext: off_deg.map((row, i) => row.map((deg, k) => words(i, k, deg))),
    hovertemplate: "%{hovertext}<extra></extra>",
  } as unknown as Data;
}

function crosses({ theta_deg, theta_L_deg, off_deg }: StudyMap): Data {
  const none = off_deg.flatMap((row, i) =>
    row.flatMap((deg, k) => (deg === null ? [{ x: theta_deg[k] ?? 0, y: theta_L_deg[i] ?? 0 }] : [])),
  );
  return {
    type: "scatter",
    mode: "markers",
    x: none.map(({ x }) => x),
    y: none.map(({ y }) => y),
    marker: { symbol: "x-thin", size: 7, line: { width: 1.4, color: ink().muted } },
    hovertext: none.map(({ x, y }) => `θ_L ${number(y)}°, θ ${number(x)}°<br><b>no answer</b>`),
    hovertemplate: "%{hovertext}<extra></extra>",
  } as Data;
}

/** To the outer edges of its cells. */
function mapAxis(text: string, at: number[]): Partial<LayoutAxis> {
  const [first, last] = [at[0] ?? 0, at.at(-1) ?? 0];
  const [low, high] = [((at[1] ?? first + 1) - first) / 2, (last - (at.at(-2) ?? last - 1)) / 2];
  return {
    title: { text, standoff: 8 },
    range: [first - low, last + high],
    dtick: last - first > 120 ? 45 : last - first >= 60 ? 30 : undefined,
    ticks: "outside",
    showgrid: false,
    zeroline: false,
    fixedrange: true,
  };
}

export const mapDrawing = (map: StudyMap): Drawing => ({
  data: [cells(map), crosses(map)],
  layout: {
    xaxis: mapAxis("θ, °", map.theta_deg),
    yaxis: mapAxis("θ<sub>L</sub>, °", map.theta_L_deg),
    plot_bgcolor: ink().band,
    margin: { l: 56, r: 10, t: 6, b: 46 },
  },
});
