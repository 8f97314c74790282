/** Error against iterations: where convergence is quadratic the digits double from step to step. */
import type { Data } from "plotly.js";
import { logAxis, logScale, marginLabels, marginShapes } from "../log_scale";
import { colourOf, isOwn, symbolIn } from "../methods";
import { error } from "../numbers";
import { type Drawing, plain, wrapped } from "../plot";
import { ink } from "../theme";
import { isShown, type Quantile, type View } from "./precision_words";

export type Path = View["set"]["paths"][number];
type Step = Path["steps"][number];

/** Paths hold no points: for these the normal stands in. */
const measured = (view: View): "normal" | "overlap" => (view.measure === "overlap" ? "overlap" : "normal");
const errorOf = (view: View, step: Step, quantile: Quantile): number | null => step[measured(view)][quantile];
export const shownPaths = (view: View, scalar: string): Path[] =>
  view.set.paths.filter((path) => path.scalar === scalar && isShown({ ...view, hiddenScalars: new Set() }, path));

function hoverText(view: View, path: Path, step: Step, width: number): string {
  const { median, p99, max } = step[measured(view)];
  return [
    `<b>${plain(path.method)}</b>, ${plain(path.scalar)}, ${step.iterations} iterations`,
    `${measured(view)}: median ${error(median)}, p99 ${error(p99)}, max ${error(max)}`,
    `<i>${wrapped(path.command, Math.max(34, Math.min(72, width / 9)))}</i>`,
  ].join("<br>");
}

export function pathsDrawing(view: View, scalar: string, width: number): Drawing {
  const paths = shownPaths(view, scalar);
  const both: Quantile[] = ["median", "p99"];
  const scale = logScale(
    paths.flatMap((path) => path.steps.flatMap((step) => both.map((q) => errorOf(view, step, q)))),
  );
  const trace = (path: Path, quantile: Quantile) =>
    ({
      type: "scatter",
      mode: "lines+markers",
      x: path.steps.map((step) => step.iterations),
      y: path.steps.map((step) => scale.place(errorOf(view, step, quantile))),
      line: {
        color: colourOf(path.method),
        width: isOwn(path.method) ? 2.4 : 1.5,
        dash: quantile === "median" ? "solid" : "dot",
      },
      marker: {
        color: colourOf(path.method),
        size: 7.5,
        symbol: symbolIn(path.method, quantile === "median" ? "double" : "p99"),
      },
      customdata: path.steps.map(() => view.set.paths.indexOf(path)),
      hovertext: path.steps.map((step) => hoverText(view, path, step, width)),
      hovertemplate: "%{hovertext}<extra></extra>",
    }) as Data;
  return {
    data: paths.flatMap((path) => both.map((quantile) => trace(path, quantile))),
    layout: {
      xaxis: { title: { text: "iterations" }, gridcolor: ink().grid, zeroline: false, rangemode: "tozero", nticks: 12 },
      yaxis: logAxis(scale, `error of the ${measured(view)}${measured(view) === "normal" ? ", rad" : ""}`),
      margin: { l: 78, r: 16, t: 10, b: 48 },
      shapes: marginShapes(scale, "y"),
      annotations: marginLabels(scale, "y", "none"),
      uirevision: `${view.set.name} ${measured(view)} ${scalar}`,
    },
  };
}

export function describePaths(view: View, scalar: string): string {
  const ends = shownPaths(view, scalar).map((path) => {
    const last = path.steps[path.steps.length - 1];
    return last ? `${path.method} ${error(errorOf(view, last, "median"))} after ${last.iterations}` : path.method;
  });
  return `Line plot: error of the ${measured(view)}, logarithmic, against iterations, in ${scalar}. Medians: ${ends.join("; ")}.`;
}
