/** Which failures are shown, and in which order, at the required accuracy. */
import { isRightFrom, rightAt } from "../accuracy";
import type { Failure, MethodRow } from "../data";
import { interestOf, seenOf } from "./answer_words";

/** The finding of an answer that says itself that it is none. */
const REFUSED = "nonconverged";

export interface Groups {
  wrong: Failure[];
  refused: Failure[];
  /** At that accuracy: at a finer one they are not. */
  right: Failure[];
}

export function grouped(failures: Failure[], level: string): Groups {
  const groups: Groups = { wrong: [], refused: [], right: [] };
  for (const failure of failures) {
    const { right_from } = seenOf(failure);
    const group = failure.finding === REFUSED ? "refused" : isRightFrom(right_from, level) ? "right" : "wrong";
    groups[group].push(failure);
  }
  return groups;
}

/**
 * Plumb's own first, then those that were brought along, then the published: of these each method's most frequent in turn, so that
 * none fills the gallery, and in each turn who is least often right first. Of each bucket the simplest before the worst.
 */
export function byInterest(failures: Failure[], totals: MethodRow[], level: string): Failure[] {
  const shares = new Map(totals.map((row) => [row.method, rightAt(row, level).share ?? 1]));
  const turns = new Map<string, number>();
  const late = (failure: Failure) => Number(failure.kept === "worst");
  const ranked = [...failures].sort((a, b) => late(a) - late(b) || b.count - a.count);
  const placed = ranked.map((failure) => {
    const turn = turns.get(failure.method) ?? 0;
    turns.set(failure.method, turn + 1);
    const interest = interestOf(failure.method, failure.own);
    return { failure, interest, turn: failure.own ? 0 : turn, right: shares.get(failure.method) ?? 1 };
  });
  placed.sort((a, b) => a.interest - b.interest || a.turn - b.turn || a.right - b.right);
  return placed.map(({ failure }) => failure);
}
