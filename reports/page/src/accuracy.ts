/** Required accuracy: how far from the reference an answer may be and still count as right. The campaign counts at each level. */
import type { MethodRow, Report, Share } from "./data";
import { select } from "./dom";
import type { Watched } from "./watched";

/** `properties/laws/accuracy.hpp` says what each level allows. */
const LEVELS: [string, string][] = [
  ["rounding", "rounding"],
  ["1e-6rad", "1e-6 rad"],
  ["0.01deg", "0.01 degree"],
  ["1deg", "1 degree"],
];

/** What a simulation needs: a solver that stops at a tolerance is not wrong by that alone. */
export const USUAL_LEVEL = "0.01deg";

export const levelName = (level: string): string => LEVELS.find(([name]) => name === level)?.[1] ?? level;

const NOTHING: Share = { count: 0, of: 0, share: null, low: 0, high: 1 };
export const rightAt = (row: MethodRow, level: string): Share => row.right[level] ?? NOTHING;

/** Whether what is right from a level on is right at that one. */
export function isRightFrom(from: string | null, level: string): boolean {
  const at = LEVELS.findIndex(([name]) => name === from);
  return at >= 0 && at <= LEVELS.findIndex(([name]) => name === level);
}

/** "to 0.01 degree" */
export const toLevel = (level: string): string => (level === "rounding" ? "up to rounding" : `to ${levelName(level)}`);

export function accuracySelect({ runs }: Report, accuracy: Watched<string>): HTMLElement | null {
  if (runs.length === 0) return null;
  const choice = select("Required accuracy", LEVELS, accuracy.value, (level) => {
    accuracy.value = level;
  });
  choice.id = "accuracy";
  return choice;
}
