/** The answer in words: who fails how often, and the failure that shows it. */
import { rightAt, toLevel } from "../accuracy";
import type { Failure, MethodRow, Run } from "../data";
import { hasOtherProblem, isForeign, isOwn, plainName } from "../methods";
import { count, number, percent } from "../numbers";

/** Of a method's answers, each once. */
export interface Outcome {
  right: number;
  wrong: number;
  gaveUp: number;
  unjudged: number;
  answers: number;
}

/** Who says himself that he has no answer is right at no level. */
export function outcomeOf(row: MethodRow, level: string): Outcome {
  const gaveUp = row.findings.nonconverged?.count ?? 0;
  const right = rightAt(row, level).count;
  const { unjudged, answers } = row;
  return { right, gaveUp, wrong: Math.max(0, row.judged - right - gaveUp), unjudged, answers };
}

export function outcomeWords({ right, wrong, gaveUp, unjudged, answers }: Outcome): string {
  const judged = answers - unjudged;
  const open = unjudged > 0 ? `${count(unjudged)} not judged` : "";
  if (judged === 0) return answers === 0 ? "not asked" : `none of ${count(answers)} answers judged`;
  const none = wrong === 0 && gaveUp === 0 ? "none wrong" : "";
  const failed = [wrong > 0 && `${count(wrong)} wrong`, gaveUp > 0 && `${count(gaveUp)} without an answer`];
  const parts = [`right in ${count(right)} of ${count(judged)}`, ...failed, none, open];
  return parts.filter(Boolean).join(", ");
}

/** Of degrees: below it is rounding of what measures as much as of the answer. */
export const MEASURED = 1e-6;

export const degrees = (x: number | null): string =>
  x === null ? "unknown" : x < MEASURED ? "less than 1e-6°" : `${number(x, 2)}°`;

/** How badly: of the converged answers. */
export function offWords({ angle_error_deg: off }: MethodRow): string {
  if (off === null || off.max === null) return "";
  if (off.max < MEASURED) return "off by less than 1e-6° at worst";
  return `off by ${degrees(off.p50)} typically, ${degrees(off.max)} at worst`;
}

/** plumb's own, then those that were brought along, then the published: each with the most failures first. */
export function interestOf(method: string, own = isOwn(method)): number {
  return isForeign(method) ? 1 : own ? 0 : 2;
}

export function worstFirst(rows: MethodRow[], level: string): MethodRow[] {
  const share = (row: MethodRow) => rightAt(row, level).share ?? 2;
  return [...rows].sort((a, b) => interestOf(a.method) - interestOf(b.method) || share(a) - share(b));
}

export function headline(run: Run, level: string): string {
  const judged = run.totals.filter((row) => row.judged > 0);
  const wrong = judged.filter((row) => outcomeOf(row, level).wrong > 0).length;
  if (judged.length === 0) return "No answer could be judged";
  if (wrong === 0) return "No solver gave a wrong answer";
  return `${count(wrong)} of ${count(judged.length)} solvers give wrong answers`;
}

const rightWords = (row: MethodRow, level: string): string => {
  const right = rightAt(row, level);
  return `${plainName(row.method)} is right in ${percent(right.share)} % of ${count(right.of)}`;
};

/** "Of 400 pairs auto is right in 100 %, original_cn in 21 %." */
export function countedSentence(run: Run, level: string): string {
  const judged = run.totals.filter((row) => row.judged > 0);
  const own = judged.filter((row) => interestOf(row.method) < 2);
  const worst = worstFirst(judged, level).find((row) => interestOf(row.method) === 2);
  const named = [...own, ...(worst ? [worst] : [])].map((row) => rightWords(row, level));
  if (named.length === 0) return "None of the answers could be held against a reference.";
  return `On ${count(run.cases)} pairs, each answer held against a reference with proved bounds, ${toLevel(level)}: ${named.join("; ")}.`;
}

/** What stands for a failure: its case as simple as it could be made, or as it was found. */
export type Seen = Pick<Failure, "case" | "answer" | "reference" | "right_from" | "replay" | "file">;
export const seenOf = (failure: Failure): Seen => failure.shrunk ?? failure;

/** Below, a wrong normal and the right one are one arrow; above, it is the same line the other way round. */
const SEEN_DEG = { least: 5, most: 90 };

const angleOf = (failure: Failure): number => seenOf(failure).answer?.angle_error_deg ?? 0;
const canBeSeen = (failure: Failure): boolean => {
  const { answer, reference } = seenOf(failure);
  const isThere = answer?.status === "converged" && answer.normal && reference?.normal && reference.points;
  return Boolean(isThere) && angleOf(failure) >= MEASURED;
};

/** How little it tells who has not read the paper: 0 where two arrows part, and the method was asked for the right one. */
function obscurityOf(failure: Failure): number {
  const angle = angleOf(failure);
  if (angle < SEEN_DEG.least) return 4;
  if (angle > SEEN_DEG.most) return 3;
  if (hasOtherProblem(failure.method)) return 2;
  return failure.finding === "misaligned" ? 0 : 1;
}

/** The fewer digits, the simpler. */
const sizeOf = (failure: Failure): number => JSON.stringify(seenOf(failure).case.bodies).length;

/** The one that opens the page: an answer that is said to be right, with a normal that is seen to be wrong. */
export function simplestOf(run: Run): Failure | null {
  const before = (a: Failure, b: Failure) =>
    obscurityOf(a) - obscurityOf(b) ||
    interestOf(a.method, a.own) - interestOf(b.method, b.own) ||
    Number(!a.shrunk) - Number(!b.shrunk) ||
    sizeOf(a) - sizeOf(b);
  return run.failures.filter(canBeSeen).sort(before)[0] ?? null;
}

export const pictureSentence = (failure: Failure | null): string =>
  failure
    ? `For the two bodies here ${plainName(failure.method)} says “converged”, and its normal is ${number(angleOf(failure), 2)}° off.`
    : "No answer was kept that says “converged” with a wrong normal.";

/** A failure's sentence, and what of its numbers matters: they part at the first semicolon outside of brackets. */
export function sentenceOf(failure: Failure): [string, string] {
  const text = failure.shrunk?.explanation || failure.detail;
  let depth = 0;
  for (let at = 0; at < text.length; ++at) {
    depth += text[at] === "(" ? 1 : text[at] === ")" ? -1 : 0;
    if (depth === 0 && text[at] === ";") return [text.slice(0, at), text.slice(at + 1).trim()];
  }
  return [text, ""];
}
