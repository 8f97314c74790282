import type { Family, Report } from "../data";
import { h, section } from "../dom";
import { made } from "../made";
import { count } from "../numbers";
import { perLevel, type State } from "../state";
import { definitions } from "../table";
import { findingsTable, methodTable } from "./families_tables";

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

function familyBlock(family: Family, report: Report, level: string): HTMLElement {
  return h(
    "section",
    { class: "family", "aria-label": `Family ${family.name}` },
    h("h3", {}, family.name, h("small", {}, ` ${count(family.cases)} cases`)),
    methodTable(family, level),
    findingsTable(family, report.findings),
    made([family.command], family.name),
    referenceLine(family),
  );
}

function words(report: Report): HTMLElement {
  const list = definitions(report.findings.map(({ word, meaning }) => [word, meaning]));
  return h("details", { class: "words" }, h("summary", {}, "What the findings mean"), list);
}

export function familiesSection(state: State): HTMLElement {
  const content = perLevel(state, h("div"), (run, level) => [
    ...run.families.map((family) => familyBlock(family, state.report, level)),
  ]);
  const question = "How often is each method right in each family of pairs, and what is wrong where it is not?";
  return section("families", "Families", question, words(state.report), content);
}
