/** How a row of a comparison is ranked and written. */
import type { ComparisonRow } from "../../data";
import { error, NONE, number, percent } from "../../numbers";

export type Verdict = ComparisonRow["verdict"];
const RANK: Record<Verdict, number> = { worse: 0, better: 1, noise: 2, same: 3 };
export const MARKS: Record<Verdict, string> = {
  worse: "▲ worse",
  better: "▼ better",
  noise: "≈ noise",
  same: "= same",
};

/** Ten times as much weighs as ten percentage points; zero counts as a thousandth of a per cent. */
function weight({ before, after, unit }: ComparisonRow): number {
  if (before === null || after === null) return before === after ? 0 : Number.POSITIVE_INFINITY;
  const least = unit === "share" ? 1e-5 : 1e-16;
  const ratio = 10 * Math.abs(Math.log10(Math.max(after, least) / Math.max(before, least)));
  return unit === "share" ? Math.max(ratio, 100 * Math.abs(after - before)) : ratio;
}

export const worstFirst = (a: ComparisonRow, b: ComparisonRow): number =>
  RANK[a.verdict] - RANK[b.verdict] || weight(b) - weight(a) || 0;

export function show(value: number | null, unit: ComparisonRow["unit"]): string {
  if (value === null) return NONE;
  if (unit === "share") return `${percent(value)} %`;
  if (unit === "deg") return `${number(value)}°`;
  return unit === "relative" ? error(value) : number(value);
}

export function change({ before, after, unit }: ComparisonRow): string {
  if (before === null || after === null) return NONE;
  if (before === after) return "0";
  if (unit === "share") return `${after > before ? "+" : "−"}${percent(Math.abs(after - before))} points`;
  return before === 0 || after === 0
    ? `${after > before ? "+" : "−"}${number(Math.abs(after - before))}`
    : `× ${number(after / before)}`;
}
