/** Figures as a reader wants them: few digits, units, "1e-12". */
import type { Host, Share, Spread } from "./data";

const THIN = "\u202f";
export const DASH = "–";
export const NONE = "—";

export function count(n: number): string {
  return String(Math.round(n)).replace(/\B(?=(\d{3})+$)/g, THIN);
}

export function scientific(x: number, digits = 2): string {
  if (x === 0) return "0";
  return x
    .toExponential(digits - 1)
    .replace(/\.0+e/, "e")
    .replace("e+", "e");
}

function plain(x: number, digits: number): string {
  return Number(x.toPrecision(digits)).toString();
}

/** A number of any size: plain between 1e-3 and 1e5, else "1.2e-12". */
export function number(x: number | null | undefined, digits = 3): string {
  if (x === null || x === undefined || Number.isNaN(x)) return NONE;
  if (!Number.isFinite(x)) return x > 0 ? "infinite" : "-infinite";
  const size = Math.abs(x);
  return x === 0 || (size >= 1e-3 && size < 1e5) ? plain(x, digits) : scientific(x, Math.min(digits, 2));
}

export function error(x: number | null | undefined): string {
  if (x === null || x === undefined) return NONE;
  return scientific(x);
}

/** A share as per cent, without the sign; 100 and 0 only where they are exact. */
export function percent(share: number | null | undefined): string {
  if (share === null || share === undefined) return NONE;
  const value = 100 * share;
  if (value === 0 || value === 100) return String(value);
  if (value > 99.95) return ">99.9";
  if (value >= 10) return value.toFixed(1);
  if (value >= 1) return value.toFixed(2);
  return value >= 0.001 ? plain(value, 2) : scientific(value);
}

export function interval(low: number, high: number): string {
  return `${percent(low)}${DASH}${percent(high)}`;
}

export function shareWithInterval(share: Share): string {
  return share.share === null ? NONE : `${percent(share.share)} % (${interval(share.low, share.high)})`;
}

const TIMES: [number, string][] = [
  [1e9, "s"],
  [1e6, "ms"],
  [1e3, "µs"],
  [1, "ns"],
];

export function time(ns: number | null | undefined): string {
  if (ns === null || ns === undefined) return NONE;
  const [size, unit] = TIMES.find(([s]) => ns >= s) ?? [1, "ns"];
  return `${plain(ns / size, 3)}${THIN}${unit}`;
}

export function duration(seconds: number): string {
  if (seconds < 90) return `${plain(seconds, 3)} s`;
  const whole = Math.round(seconds);
  return `${Math.floor(whole / 60)} min ${whole % 60} s`;
}

export function spread(values: Spread, show: (x: number | null) => string, parts: ("p50" | "p99" | "max")[]): string {
  return values === null ? NONE : parts.map((part) => show(values[part])).join(" / ");
}

/** " on Linux, x86_64, g++ 12 -O2" */
export const onMachine = ({ system, machine, compiler, flags }: Host): string =>
  ` on ${system}, ${machine}, ${compiler} ${flags}`;
