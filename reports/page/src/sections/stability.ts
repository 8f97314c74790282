/** The frozen cases of the ladders, by every method and in every arithmetic. */
import { command } from "../commands";
import type { Stability, StabilityRow } from "../data";
import { type Child, h } from "../dom";
import { inOrder } from "../methods";
import { count, NONE, onMachine } from "../numbers";
import { methodName } from "../swatch";
import { type Column, table } from "../table";
import { LADDER_NAME } from "./ladders/ladder_name";
import { stepName } from "./ladders/ladder_words";

type Rungs = Stability["ladders"][number];

/** What the library is built for; all else is held against it. */
const USUAL = "double";
const OWN = "auto";

const sum = (counts: number[]): number => counts.reduce((total, n) => total + n, 0);
const digits = (x: number | null): string => (x === null ? NONE : x.toFixed(1));

const rowOf = (ladder: Rungs, method: string, arithmetic: string): StabilityRow | undefined =>
  ladder.rows.find((row) => row.method === method && row.arithmetic === arithmetic);

/** "2 wrong, 1 lost", so that it is seen. */
function mistakes(row: StabilityRow): Child[] {
  const [wrong, lost] = [sum(row.wrong), sum(row.lost)];
  return [
    wrong > 0 && h("span", { class: "flag wrong" }, `${count(wrong)} wrong`),
    lost > 0 && h("span", { class: "flag lost" }, `${count(lost)} lost`),
  ];
}

function methodCell(ladder: Rungs, row: StabilityRow | undefined): Child[] {
  if (!row) return [NONE];
  const { overlap, normal, points } = row.digits;
  const none = sum(row.cases) === 0;
  const where = none ? "no case" : row.lets_go === null ? "holds" : `at ${stepName(ladder, row.lets_go)}`;
  return [
    h("span", {}, `${count(sum(row.right))} of ${count(sum(row.cases))}`),
    h("small", {}, `${digits(overlap)} / ${digits(normal)} / ${digits(points)}`),
    h("small", { class: row.lets_go === null && !none ? "holds" : "" }, where),
  ];
}

function arithmeticCell(row: StabilityRow | undefined): Child[] {
  if (!row) return [NONE];
  const { overlap, normal, points } = row.digits;
  return [h("span", {}, digits(overlap)), h("small", {}, `${digits(normal)} / ${digits(points)}`), ...mistakes(row)];
}

function methodsTable(stability: Stability): HTMLElement | null {
  const rows = stability.ladders.flatMap((ladder) => ladder.rows).filter((row) => row.arithmetic === USUAL);
  const methods = inOrder(rows.map((row) => row.method));
  if (methods.length === 0) return null;
  const columns = methods.map((method): Column<Rungs> => ({
    title: methodName(method),
    cell: (ladder) => methodCell(ladder, rowOf(ladder, method, USUAL)),
  }));
  const caption =
    "In double: right of the cases; the fewest significant digits of overlap / normal / points; where it lets go";
  return h(
    "div",
    { class: "stacked" },
    table({ caption, columns: [LADDER_NAME, ...columns], rows: stability.ladders }),
  );
}

function arithmeticsTable(stability: Stability): HTMLElement | null {
  const rows = stability.ladders.flatMap((ladder) => ladder.rows).filter((row) => row.method === OWN);
  const arithmetics = [...new Set(rows.map((row) => row.arithmetic))];
  if (arithmetics.length < 2) return null;
  const columns = arithmetics.map((arithmetic): Column<Rungs> => ({
    title: arithmetic,
    cell: (ladder) => arithmeticCell(rowOf(ladder, OWN, arithmetic)),
  }));
  const caption = "auto in each arithmetic: the fewest significant digits of the overlap, below it of normal / points";
  return h(
    "div",
    { class: "stacked" },
    table({ caption, columns: [LADDER_NAME, ...columns], rows: stability.ladders }),
  );
}

/** "auto is right in double in 891 of 891 cases, in float in 702 of 891." */
function summary({ totals }: Stability): HTMLElement | null {
  const own = totals.filter((total) => total.method === OWN);
  if (own.length === 0) return null;
  const parts = own.map(
    ({ arithmetic, right, cases }, index) =>
      `in ${arithmetic} ${count(right)} of ${count(cases)}${index === 0 ? " cases" : ""}`,
  );
  const usual = own.find(({ arithmetic }) => arithmetic === USUAL);
  const kind = !usual || usual.cases === 0 ? "" : usual.right === usual.cases ? "good" : "bad";
  return h("p", { class: `verdict ${kind}` }, `auto is right ${parts.join(", ")}.`);
}

export function stabilityBlock(stability: Stability): (HTMLElement | null)[] {
  const { host, commit, interrupted } = stability;
  return [
    h("h3", {}, "The same ladders in other arithmetic"),
    summary(stability),
    methodsTable(stability),
    arithmeticsTable(stability),
    h("p", { class: "note" }, `Measured at commit ${commit}${onMachine(host)}${interrupted ? " (interrupted)" : ""}:`),
    command(stability.command),
  ];
}
