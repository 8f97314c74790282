import type { Comparison, ComparisonRow, Run } from "../../data";
import { button, fill, h, section, select, unique } from "../../dom";
import { made } from "../../made";
import { inOrder } from "../../methods";
import { count, DASH, number } from "../../numbers";
import type { State } from "../../state";
import { methodName } from "../../swatch";
import { type Column, table } from "../../table";
import { comparisonFigure } from "./compare_plot";
import { change, MARKS, show, type Verdict, worstFirst } from "./compare_words";

const QUESTION = "What got better, what got worse, and what is noise?";
const FIRST_ROWS = 30;

function withInterval(value: number | null, range: [number, number] | undefined, row: ComparisonRow) {
  const small =
    range && h("small", { class: "interval" }, `${show(range[0], row.unit)} ${DASH} ${show(range[1], row.unit)}`);
  return [show(value, row.unit), small];
}

function columns(sameCases: boolean): Column<ComparisonRow>[] {
  const p: Column<ComparisonRow> = { title: "p (Holm)", figure: true, cell: (row) => number(row.p, 2) };
  return [
    { title: "Verdict", cell: (row) => h("span", { class: `mark ${row.verdict}` }, MARKS[row.verdict]) },
    { title: "Family", cell: (row) => row.family },
    { title: "Method", head: true, cell: (row) => methodName(row.method) },
    { title: "Measure", cell: (row) => row.measure },
    { title: "Before", figure: true, cell: (row) => withInterval(row.before, row.before_interval, row) },
    { title: "After", figure: true, cell: (row) => withInterval(row.after, row.after_interval, row) },
    { title: "Change", figure: true, cell: change },
    ...(sameCases ? [] : [p]),
  ];
}

interface Filter {
  verdict: string;
  family: string;
  method: string;
}

const passes = (row: ComparisonRow, { verdict, family, method }: Filter): boolean =>
  (verdict === "" ||
    row.verdict === verdict ||
    (verdict === "changed" && row.verdict !== "same" && row.verdict !== "noise")) &&
  (family === "" || row.family === family) &&
  (method === "" || row.method === method);

function controls(comparison: Comparison, filter: Filter, changed: () => void): HTMLElement {
  const choice = (label: string, key: keyof Filter, values: [string, string][]) =>
    select(label, values, filter[key], (value) => {
      filter[key] = value;
      changed();
    });
  const named = (names: string[]): [string, string][] => [
    ["", "all"],
    ...names.map((name): [string, string] => [name, name]),
  ];
  const verdicts: [string, string][] = [["", "all"], ["changed", "better or worse"], ...Object.entries(MARKS)];
  return h(
    "div",
    { class: "controls" },
    choice("Verdict", "verdict", verdicts),
    choice("Family", "family", named(unique(comparison.rows.map((row) => row.family)))),
    choice("Method", "method", named(inOrder(comparison.rows.map((row) => row.method)))),
  );
}

function tally(comparison: Comparison): HTMLElement {
  const list = h("ul", { class: "tally" });
  for (const verdict of Object.keys(MARKS) as Verdict[]) {
    const times = comparison.rows.filter((row) => row.verdict === verdict).length;
    list.append(h("li", { class: `mark ${verdict}` }, `${count(times)} ${MARKS[verdict]}`));
  }
  return list;
}

const NOTHING_IN_COMMON = "These runs have no family with a method in common: there is nothing to compare.";
const SAME_CASES =
  "Both runs drew the same cases: no difference is chance: each is of the code, the compiler or the machine.";
const OTHER_CASES =
  "The runs drew different cases: shares are compared by Fisher's exact test, other figures by Mann and Whitney's, p adjusted by Holm for the number of rows; what may be chance is called noise.";

/** The worst rows, and the others on request. */
function rowsTable(comparison: Comparison, rows: ComparisonRow[]): HTMLElement {
  const caption = `${comparison.before} against ${comparison.after}`;
  const of = (shown: ComparisonRow[]) =>
    table({ caption, columns: columns(comparison.same_cases), rows: shown, rowClass: (row) => row.verdict });
  if (rows.length <= FIRST_ROWS) return of(rows);
  const place = h("div", {}, of(rows.slice(0, FIRST_ROWS)));
  place.append(button(`Show all ${count(rows.length)} rows`, () => fill(place, of(rows)), { class: "more-rows" }));
  return place;
}

function comparisonBlock(comparison: Comparison, runs: Run[]): HTMLElement {
  const title = h("h3", {}, `${comparison.before} → ${comparison.after}`);
  if (comparison.rows.length === 0) return h("div", {}, title, h("p", { class: "empty" }, NOTHING_IN_COMMON));
  const compared = runs.filter(({ name }) => name === comparison.before || name === comparison.after);
  const commands = compared.flatMap((run) => run.commands);
  const sorted = [...comparison.rows].sort(worstFirst);
  const changed = sorted.some((row) => row.verdict === "worse" || row.verdict === "better");
  const filter: Filter = { verdict: changed ? "changed" : "", family: "", method: "" };
  const status = h("p", { class: "status", role: "status" });
  const place = h("div");
  const rows = () => sorted.filter((row) => passes(row, filter));
  const plot = comparisonFigure(comparison, rows);
  const refill = () => {
    const kept = rows();
    status.textContent = `${count(kept.length)} of ${count(sorted.length)} rows, the worst first`;
    fill(place, rowsTable(comparison, kept));
    plot.redraw();
  };
  refill();
  return h(
    "div",
    { class: "comparison" },
    title,
    h("p", { class: "note" }, comparison.same_cases ? SAME_CASES : OTHER_CASES),
    tally(comparison),
    controls(comparison, filter, refill),
    status,
    place,
    plot.element,
    made(commands, "both runs"),
  );
}

export function compareSection({ report: { comparisons, runs } }: State): HTMLElement | null {
  if (comparisons.length === 0) return null;
  return section("compare", "Comparison", QUESTION, ...comparisons.map((one) => comparisonBlock(one, runs)));
}
