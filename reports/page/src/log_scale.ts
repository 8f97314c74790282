/** A logarithmic axis that leaves no point out: 0 stands on a floor, no value at all in a gutter, both labelled. */
import type { Annotations, LayoutAxis, Shape } from "plotly.js";
import { ink } from "./theme";

export interface LogScale {
  place: (value: number | null) => number;
  /** In powers of ten. */
  range: [number, number];
  floor: number | null;
  gutter: number | null;
}

export function logScale(values: (number | null)[]): LogScale {
  const powers = values.filter((value): value is number => value !== null && value > 0).map(Math.log10);
  const low = powers.length ? Math.floor(Math.min(...powers)) : -16;
  const high = powers.length ? Math.max(low + 1, Math.ceil(Math.max(...powers))) : 0;
  const step = Math.max(1, (high - low) / 14);
  const floor = values.includes(0) ? low - step : null;
  const gutter = values.includes(null) ? high + step : null;
  const place = (value: number | null) =>
    10 ** (value === null ? (gutter ?? high + step) : value > 0 ? Math.log10(value) : (floor ?? low - step));
  return { place, range: [(floor ?? low) - step * 0.6, (gutter ?? high) + step * 0.6], floor, gutter };
}

/** The two ways in which Plotly writes a power of ten. */
const ticksOf = (power: number): string[] => [
  `1e${power < 0 ? "−" : "+"}${Math.abs(power)}`,
  power < 0 ? (10 ** power).toFixed(-power) : String(10 ** power),
];

/** Ticks beyond the floor and the gutter would be numbers of nothing. */
function silenced(scale: LogScale): Record<string, string> {
  const aliases: Record<string, string> = {};
  for (const power of [scale.floor, scale.gutter]) {
    if (power === null) continue;
    for (const near of [-1, 0, 1, 2]) {
      const tick = Math.floor(power) + near;
      const isBeyond = power === scale.floor ? tick < power + 0.5 : tick > power - 0.5;
      if (isBeyond && Math.abs(tick) < 100) for (const text of ticksOf(tick)) aliases[text] = " ";
    }
  }
  return aliases;
}

export function logAxis(scale: LogScale, title: string, mostTicks = 9): Partial<LayoutAxis> {
  const { grid } = ink();
  return {
    type: "log",
    range: [...scale.range],
    title: { text: title },
    exponentformat: "e",
    gridcolor: grid,
    zeroline: false,
    nticks: Math.max(3, Math.min(mostTicks, Math.floor((scale.range[1] - scale.range[0]) / 0.8))),
    labelalias: silenced(scale),
  } as object;
}

/** The floor's line and the gutter's band, across the plot. */
export function marginShapes(scale: LogScale, axis: "x" | "y"): Partial<Shape>[] {
  const { muted, band } = ink();
  const across = axis === "x" ? { xref: "x", yref: "paper", y0: 0, y1: 1 } : { yref: "y", xref: "paper", x0: 0, x1: 1 };
  const along = (from: number, to: number) =>
    axis === "x" ? { x0: 10 ** from, x1: 10 ** to } : { y0: 10 ** from, y1: 10 ** to };
  const shapes: Partial<Shape>[] = [];
  const add = (shape: object) => shapes.push({ ...across, layer: "below", ...shape } as Partial<Shape>);
  if (scale.floor !== null)
    add({ type: "line", ...along(scale.floor, scale.floor), line: { color: muted, width: 1, dash: "dot" } });
  if (scale.gutter !== null) {
    const half = scale.range[1] - scale.gutter;
    add({ type: "rect", ...along(scale.gutter - half, scale.gutter + half), fillcolor: band, line: { width: 0 } });
  }
  return shapes;
}

/** What floor and gutter mean, beside the axis. */
export function marginLabels(scale: LogScale, axis: "x" | "y", gutterText: string): Partial<Annotations>[] {
  const { muted } = ink();
  const beside =
    axis === "x"
      ? { xref: "x", yref: "paper", y: 0, yanchor: "top", yshift: -3 }
      : { yref: "y", xref: "paper", x: 0, xanchor: "right", xshift: -4 };
  const label = (power: number | null, text: string) =>
    power === null
      ? []
      : [
          {
            ...beside,
            [axis]: power,
            text,
            showarrow: false,
            font: { size: 11.5, color: muted },
          } as Partial<Annotations>,
        ];
  return [...label(scale.floor, "0"), ...label(scale.gutter, gutterText)];
}
