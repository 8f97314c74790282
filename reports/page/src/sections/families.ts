import type { Family, Report, Run } from "../data";
import { h, section } from "../dom";
import { count, duration, percent } from "../numbers";
import { perRun, type State } from "../state";
import { methodName } from "../swatch";
import { definitions } from "../table";
import { failureIntervals } from "./intervals";
import { findingsTable, methodTable } from "./summary_tables";

interface OwnTotal {
  method: string;
  judged: number;
  failures: number;
}

/** What plumb itself answers for, over all families. */
function ownTotals(run: Run): OwnTotal[] {
  const totals = new Map<string, OwnTotal>();
  for (const row of run.families.flatMap((family) => family.methods)) {
    if (row.published) continue;
    const total = totals.get(row.method) ?? { method: row.method, judged: 0, failures: 0 };
    total.judged += row.judged;
    total.failures += row.failures.count;
    totals.set(row.method, total);
  }
  return [...totals.values()];
}

function ownLine(total: OwnTotal): HTMLElement {
  const share = total.judged > 0 ? ` (${percent(total.failures / total.judged)} %)` : "";
  const words = `${count(total.failures)} of ${count(total.judged)} judged answers break a law${share}.`;
  return h("p", { class: `verdict ${total.failures > 0 ? "bad" : "good"}` }, methodName(total.method), " ", words);
}

function keyFigures(run: Run): HTMLElement {
  const methods = new Set(run.families.flatMap((family) => family.methods.map((row) => row.method)));
  const list = definitions([
    ["Cases", count(run.cases)],
    ["Families", count(run.families.length)],
    ["Methods", count(methods.size)],
    ["Kept failures", count(run.kept_failures)],
    ["Took", duration(run.timing.seconds)],
  ]);
  list.className = "figures";
  return list;
}

function referenceLine(family: Family): HTMLElement {
  const { unsolved, not_proved_lowest, beaten, needed } = family.reference;
  const dearest = Object.entries(needed).map(([step, times]) => `${step} ${count(times)}`);
  const text = [
    `Reference: ${count(unsolved)} unsolved, ${count(not_proved_lowest)} not proved to be the lowest`,
    dearest.length > 0 && `; judged by ${dearest.join(", ")}`,
    ".",
  ];
  const beat = h("strong", { class: "bad" }, ` Reference BEATEN ${count(beaten)} times: the harness is wrong.`);
  return h("p", { class: "note" }, ...text, beaten > 0 && beat);
}

function familyBlock(family: Family, report: Report): HTMLElement {
  return h(
    "section",
    { class: "family", "aria-label": `Family ${family.name}` },
    h("h3", {}, family.name, h("small", {}, ` ${count(family.cases)} cases`)),
    methodTable(family),
    findingsTable(family, report.findings),
    referenceLine(family),
  );
}

function words(report: Report): HTMLElement {
  const list = definitions(report.findings.map(({ word, meaning }) => [word, meaning]));
  return h("details", { class: "words" }, h("summary", {}, "What the findings mean"), list);
}

export function summarySection(state: State): HTMLElement {
  const content = perRun(state, h("div"), (run) => [
    keyFigures(run),
    h("div", { class: "verdicts" }, ...ownTotals(run).map(ownLine)),
    run.families.some((family) => family.methods.length > 0) ? failureIntervals(run) : null,
    words(state.report),
    ...run.families.map((family) => familyBlock(family, state.report)),
  ]);
  return section("summary", "Summary", "How often is each method right, and how sure is that?", content);
}
