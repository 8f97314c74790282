/** What a ladder's strips say: where a method lets go, and what a step holds. */
import type { Ladder, LadderRow } from "../../data";
import { count, number, percent } from "../../numbers";

/** Of one figure a step each; a step that is not there has none. */
const at = (figures: number[], step: number): number => figures[step] ?? 0;

export const stepName = (ladder: Pick<Ladder, "steps">, step: number): string =>
  `${number(ladder.steps[step - 1])} (step ${step} of ${ladder.steps.length})`;

/** As the strips have room for: whole per cent, 0 and 100 only where they are exact. */
export function wholePercent(part: number, of: number): string {
  const share = (100 * part) / of;
  if (share > 0 && share < 0.5) return "<1";
  return share < 100 && share >= 99.5 ? ">99" : String(Math.round(share));
}

/** The findings on a step (from 0), the most frequent first. */
function findingsOn(row: LadderRow, step: number): [string, number][] {
  return Object.entries(row.findings)
    .map(([word, counts]): [string, number] => [word, at(counts, step)])
    .filter(([, n]) => n > 0)
    .sort((a, b) => b[1] - a[1]);
}

/** What a method does first where it lets go: "misaligned". */
export const firstFinding = (row: LadderRow): string =>
  row.lets_go === null ? "" : (findingsOn(row, row.lets_go - 1)[0]?.[0] ?? "");

/** On which steps a method holds: a step without a judged answer says nothing. */
export function holdsOn(row: LadderRow): string {
  const judged = row.judged.filter((n) => n > 0).length;
  return judged === row.judged.length ? `all ${judged} steps` : `${judged} of ${row.judged.length} steps judged`;
}

/** A step (from 0) in a sentence. */
export function describeStep(ladder: Ladder, row: LadderRow, step: number): string {
  const head = `${row.method}, ${ladder.knob} ${stepName(ladder, step + 1)}`;
  const [answers, judged] = [at(row.answers, step), at(row.judged, step)];
  if (answers === 0) return `${head}: no case`;
  if (judged === 0) return `${head}: ${count(answers)} answers, none judged`;
  const kinds = findingsOn(row, step).map(([word, n]) => `${word} ${count(n)}`);
  const shares = `${percent(at(row.wrong, step) / judged)} % wrong, ${percent(at(row.lost, step) / judged)} % lost`;
  return `${head}: of ${count(judged)} judged answers ${shares}${kinds.length > 0 ? ` (${kinds.join(", ")})` : ""}`;
}

/** How far a method gets, for sorting: the part of the ladder before it lets go. */
export function heldPart(ladder: Ladder, method: string): number {
  const row = ladder.methods.find((one) => one.method === method);
  return !row || row.lets_go === null ? 1 : (row.lets_go - 1) / ladder.steps.length;
}
