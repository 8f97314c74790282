import type { Data, LayoutAxis } from "plotly.js";
import type { Atlas, Cell } from "../data";
import { count, number, percent } from "../numbers";
import { type Drawing, plain, short } from "../plot";
import { ink, theme } from "../theme";

export type AtlasMeasure = "failures" | "not_converged" | "iterations";
export const MEASURE_NAMES: Record<AtlasMeasure, string> = {
  failures: "failures, % of the judged",
  not_converged: "not converged, % of the answers",
  iterations: "iterations, mean",
};
/** Below so many judged answers a cell is shown as uncertain. */
export const FEW = 20;

/** From little to much. */
export const SCALES = {
  light: ["#e2ecf5", "#b3cfe6", "#7dafd6", "#478bc0", "#20639b", "#0a3a66"],
  dark: ["#22384c", "#2a5478", "#3576a8", "#4f9bd3", "#8cc3ec", "#d9eefc"],
};

export function measureOf(cell: Cell, measure: AtlasMeasure): number | null {
  if (measure === "iterations") return cell.iterations;
  if (measure === "not_converged") return cell.answers > 0 ? cell.not_converged / cell.answers : null;
  return cell.judged > 0 ? cell.failures / cell.judged : null;
}

const shown = (cell: Cell, measure: AtlasMeasure): number | null => {
  const value = measureOf(cell, measure);
  return value === null || measure === "iterations" ? value : 100 * value;
};

const sizeOf = (cell: Cell, measure: AtlasMeasure): number => (measure === "failures" ? cell.judged : cell.answers);

function hoverText(atlas: Atlas, cell: Cell): string {
  const failed = measureOf(cell, "failures");
  return [
    `<b>${plain(`${atlas.x.title}: ${atlas.x.labels[cell.x]}`)}</b>`,
    `<b>${plain(`${atlas.y.title}: ${atlas.y.labels[cell.y]}`)}</b>`,
    `${count(cell.answers)} answers, ${count(cell.judged)} judged`,
    `${count(cell.failures)} failures${failed === null ? "" : ` (${percent(failed)} %)`}`,
    `${count(cell.not_converged)} not converged`,
    `${number(cell.iterations)} iterations`,
  ].join("<br>");
}

/** A cell on a phone has room for one sign: the uncertain are marked. */
function cellText(cell: Cell, measure: AtlasMeasure, few: boolean, roomy: boolean): string {
  if (!roomy) return few ? "?" : "";
  if (few) return `n=${sizeOf(cell, measure)}`;
  const value = shown(cell, measure);
  if (value === null) return "";
  if (value > 0 && value < 0.1) return "&lt;0.1";
  return value > 0 && value < 10 ? value.toFixed(1) : value.toFixed(0);
}

function grid<T>(atlas: Atlas, cells: Cell[], none: T, of: (cell: Cell) => T): T[][] {
  const rows = atlas.y.labels.map(() => atlas.x.labels.map(() => none));
  for (const cell of cells) {
    const row = rows[cell.y];
    if (row) row[cell.x] = of(cell);
  }
  return rows;
}

function layer(atlas: Atlas, measure: AtlasMeasure, cells: Cell[], few: boolean, width: number): Data {
  const roomy = (width - 220) / atlas.x.labels.length > 30;
  return {
    type: "heatmap",
    x: atlas.x.labels.map((_, index) => index),
    y: atlas.y.labels.map((_, index) => index),
    z: grid<number | null>(atlas, cells, null, (cell) => shown(cell, measure)),
    text: grid(atlas, cells, "", (cell) => cellText(cell, measure, few, roomy)),
    texttemplate: "%{text}",
    textfont: few ? { size: 11, color: ink().text } : { size: 11 },
    hovertext: grid(atlas, cells, "", (cell) => hoverText(atlas, cell)),
    hovertemplate: "%{hovertext}<extra></extra>",
    coloraxis: "coloraxis",
    opacity: few ? 0.45 : 1,
    xgap: 1.5,
    ygap: 1.5,
    hoverongaps: false,
  } as unknown as Data;
}

/** The labels are intervals; on a narrow page every second one is written. */
function labelAxis(title: string, labels: string[], every: number): Partial<LayoutAxis> {
  const at = labels.map((_, index) => index).filter((index) => index % every === 0);
  return {
    title: { text: short(title, 60), standoff: 12, font: { size: 13 } },
    tickvals: at,
    ticktext: at.map((index) => short(labels[index] ?? "")),
    range: [-0.5, labels.length - 0.5],
    showgrid: false,
    zeroline: false,
    showline: true,
    mirror: true,
    linecolor: ink().grid,
    fixedrange: true,
    automargin: true,
  } as Partial<LayoutAxis>;
}

/** Of the colours: a round per cent, so that maps can be compared. */
function greatest(atlas: Atlas, measure: AtlasMeasure): number {
  const most = Math.max(0, ...atlas.cells.map((cell) => shown(cell, measure) ?? 0));
  return measure === "iterations" ? most : ([1, 10, 100].find((limit) => most <= limit) ?? 100);
}

export function atlasDrawing(atlas: Atlas, measure: AtlasMeasure, width: number): Drawing {
  const isFew = (cell: Cell) => sizeOf(cell, measure) < FEW;
  const sure = atlas.cells.filter((cell) => !isFew(cell));
  const unsure = atlas.cells.filter(isFew);
  const scale = SCALES[theme.value];
  const every = width / atlas.x.labels.length < 44 ? 2 : 1;
  const barPlace =
    width < 480 ? { orientation: "h", y: 1, yanchor: "bottom", len: 1, ypad: 6, nticks: 5 } : { len: 1, xpad: 6 };
  const coloraxis = {
    colorscale: scale.map((colour, index) => [index / (scale.length - 1), colour]),
    cmin: 0,
    cmax: greatest(atlas, measure),
    colorbar: { thickness: 10, outlinewidth: 0, ticksuffix: measure === "iterations" ? "" : " %", ...barPlace },
  };
  const layout = {
    xaxis: labelAxis(atlas.x.title, atlas.x.labels, every),
    yaxis: labelAxis(atlas.y.title, atlas.y.labels, 1),
    coloraxis,
    margin: { l: 30, r: 10, t: 8, b: 30 },
  };
  return { data: [layer(atlas, measure, sure, false, width), layer(atlas, measure, unsure, true, width)], layout };
}
