import type { PrecisionPoint, PrecisionSet, Quantiles } from "../data";
import { error, number, percent, time } from "../numbers";

export type Measure = "normal" | "overlap" | "points";
export type Quantile = keyof Quantiles;

export const MEASURES: [Measure, string][] = [
  ["normal", "normal, rad"],
  ["overlap", "overlap, of the size"],
  ["points", "points, of the size"],
];
export const QUANTILES: [Quantile, string][] = [
  ["p99", "p99"],
  ["median", "median"],
  ["max", "greatest"],
];

/** What the two plots of the section show. */
export interface View {
  set: PrecisionSet;
  measure: Measure;
  quantile: Quantile;
  hidden: Set<string>;
  hiddenScalars: Set<string>;
}

export const axisTitle = ({ measure, quantile }: View): string => {
  const name = MEASURES.find(([key]) => key === measure)?.[1] ?? measure;
  return `error of the ${name} (${QUANTILES.find(([key]) => key === quantile)?.[1]})`;
};

export const tolerance = (point: PrecisionPoint): string =>
  point.tolerance > 0 ? `tolerance ${error(point.tolerance)}` : "tolerance 0 (all that rounding allows)";

export function pointName(point: PrecisionPoint): string {
  const certificate = point.certificate ? ` + ${point.certificate}` : "";
  return `${point.method}${certificate}, ${point.scalar}, ${tolerance(point)}`;
}

export function pointFigures(point: PrecisionPoint): string[] {
  const errors = MEASURES.map(
    ([key]) => `${key} ${error(point[key].median)} / ${error(point[key].p99)} / ${error(point[key].max)}`,
  );
  return [
    `time ${time(point.median_ns)} (p99 ${time(point.p99_ns)}), ${number(point.iterations.median)} iterations (max ${number(point.iterations.max)})`,
    `errors, median / p99 / max: ${errors[0]}`,
    `${errors[1]}; ${errors[2]}`,
    `no answer ${percent(point.failed)} %, off by more than 0.01° ${percent(point.off)} %, judged ${point.judged}`,
  ];
}

export const isShown = (view: View, { method, scalar }: { method: string; scalar: string }): boolean =>
  !view.hidden.has(method) && !view.hiddenScalars.has(scalar);
