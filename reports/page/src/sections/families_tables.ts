/** Two tables a family: how a method does, and what is wrong where it is not right. */
import { levelName, rightAt } from "../accuracy";
import type { Family, MethodRow, Report, Share } from "../data";
import { breakable, type Child, h } from "../dom";
import { count, interval, NONE, number, percent, spread, time } from "../numbers";
import { methodName } from "../swatch";
import { type Column, table } from "../table";

function shareCell(share: Share | undefined): Child[] {
  if (!share || share.share === null) return [NONE];
  return [percent(share.share), h("small", { class: "interval" }, interval(share.low, share.high))];
}

function answersCell(row: MethodRow): Child[] {
  const unjudged = row.unjudged > 0 && h("small", { class: "interval" }, `${count(row.unjudged)} unjudged`);
  const passed = row.not_asked > 0 && h("small", { class: "interval" }, `${count(row.not_asked)} not asked`);
  return [count(row.answers), unjudged, passed];
}

const method: Column<MethodRow> = { title: "Method", head: true, cell: (row) => methodName(row.method) };

const columnsAt = (level: string): Column<MethodRow>[] => [
  method,
  { title: "Answers", figure: true, cell: answersCell },
  {
    title: "Converged, %",
    hint: "Answers whose status is converged; says nothing about right or wrong",
    figure: true,
    cell: (row) => shareCell(row.converged),
  },
  {
    title: `Right to ${levelName(level)}, %`,
    hint: "Of the judged answers, those that break no law at the required accuracy, with the exact 95 % interval",
    figure: true,
    cell: (row) => shareCell(rightAt(row, level)),
  },
  {
    title: "> 0.01°, %",
    hint: "Of the converged answers, those more than 0.01 degrees from the common normal",
    figure: true,
    cell: (row) => shareCell(row.angle_above),
  },
  {
    title: "Angle, °",
    hint: "Of converged answers to the common normal: p50 / p99 / max",
    figure: true,
    cell: (row) => spread(row.angle_error_deg, (x) => number(x, 2), ["p50", "p99", "max"]),
  },
  {
    title: "Iterations",
    hint: "p50 / p99",
    figure: true,
    cell: (row) => spread(row.iterations, (x) => number(x, 2), ["p50", "p99"]),
  },
  {
    title: "Time",
    hint: "One solve, p50 / p99; the one column that another run need not repeat",
    figure: true,
    cell: (row) => spread(row.ns_per_solve, time, ["p50", "p99"]),
  },
];

const rowClass = (row: MethodRow) => (row.published ? "" : "is-own");

export function methodTable(family: Family, level: string): HTMLElement {
  const caption = `${family.name}: methods, with 95 % intervals; angle p50 / p99 / max, iterations and time p50 / p99`;
  return table({ caption, columns: columnsAt(level), rows: family.methods, rowClass });
}

/** Columns in the contract's order, of the findings that occur. */
export function findingsTable(family: Family, known: Report["findings"]): HTMLElement {
  const occurs = (word: string) => family.methods.some((row) => (row.findings[word]?.count ?? 0) > 0);
  const words = known.filter(({ word }) => word !== "none" && occurs(word));
  if (words.length === 0) return h("p", { class: "note" }, "No method has a finding in this family.");
  const columns = words.map(({ word, meaning }): Column<MethodRow> => ({
    title: breakable(word),
    hint: meaning,
    figure: true,
    cell: (row) =>
      (row.findings[word]?.count ?? 0) > 0 ? shareCell(row.findings[word]) : h("span", { class: "zero" }, "0"),
  }));
  const caption = `${family.name}: findings, % of the judged answers, with 95 % intervals`;
  return table({ caption, columns: [method, ...columns], rows: family.methods, rowClass });
}
