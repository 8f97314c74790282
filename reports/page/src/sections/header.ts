import type { Playback, Report, Run, Study } from "../data";
import { h } from "../dom";
import { count, number } from "../numbers";
import { femLine } from "./fem/fem_words";

function alarm(run: Run): HTMLElement | null {
  const errors = Object.entries(run.harness_errors);
  if (!run.incomplete && errors.length === 0) return null;
  const items = errors.map(([message, times]) => h("li", {}, h("code", {}, message), ` (${count(times)} times)`));
  return h(
    "div",
    { class: "alarm", role: "alert" },
    h("strong", {}, run.incomplete ? `${run.name} is incomplete. ` : `The harness itself failed in ${run.name}. `),
    run.incomplete ? "It was interrupted, or shards are missing: its figures cover only what was done. " : null,
    errors.length > 0 && "Errors of the harness, which no figure below accounts for:",
    items.length > 0 && h("ul", {}, ...items),
  );
}

function cutShort({ name, end }: Playback): HTMLElement | null {
  if (end) return null;
  const words = h("strong", {}, `The scene ${name} is incomplete. `);
  return h("div", { class: "alarm", role: "alert" }, words, "Its run did not reach its end.");
}

const sceneLine = ({ name, scene, bodies, times }: Playback): string =>
  `${name}: scene ${scene}, ${count(bodies.length)} bodies, ${count(times.length)} frames to t = ${number(times.at(-1))}`;

function studyLine({ groups, commit }: Study): string {
  const words = groups.length > 0 ? `${count(groups.length)} groups of pairs, ` : "";
  return `study: ${words}commit ${commit}`;
}

function partCutShort(name: string, part: { interrupted: boolean } | null): HTMLElement | null {
  if (!part?.interrupted) return null;
  const words = h("strong", {}, `The ${name} is incomplete. `);
  return h("div", { class: "alarm", role: "alert" }, words, "It was interrupted: it shows only what was done.");
}

export function header(report: Report): HTMLElement {
  const runs = report.runs.map(
    (run) => `${run.name}: ${count(run.cases)} cases, seed ${run.seed}, commit ${run.commit}`,
  );
  const { playbacks, study, fem } = report;
  const parts = [study && studyLine(study), fem && femLine(fem)].filter((line) => line !== null);
  const lines = [...runs, ...playbacks.map(sceneLine), ...parts];
  return h(
    "header",
    { class: "top" },
    h("p", { class: "brand" }, "plumb report"),
    h("h1", {}, "Does the contact normal stand true?"),
    h("ul", { class: "runs" }, ...lines.map((text) => h("li", {}, text))),
    ...report.runs.map(alarm),
    ...report.playbacks.map(cutShort),
    partCutShort("study", report.study),
    partCutShort("finite element study", report.fem),
  );
}
