import type { Playback, Run } from "../data";
import { h } from "../dom";
import { count } from "../numbers";
import { perLevel, type State } from "../state";
import { headline } from "./answer_words";
import { SECTIONS } from "./sections";

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

function partCutShort(name: string): HTMLElement {
  const words = h("strong", {}, `The ${name} is incomplete. `);
  return h("div", { class: "alarm", role: "alert" }, words, "It was interrupted: it shows only what was done.");
}

export function header(state: State): HTMLElement {
  const { report } = state;
  const runs = report.runs.map(
    (run) => `${run.name}: ${count(run.cases)} cases, seed ${run.seed}, commit ${run.commit}`,
  );
  const lines = [...runs, ...SECTIONS.flatMap((section) => section.lines?.(report) ?? [])];
  const cut = SECTIONS.map((section) => section.cutShort?.(report)).filter((name) => typeof name === "string");
  return h(
    "header",
    { class: "top" },
    h("p", { class: "brand" }, "plumb report"),
    perLevel(state, h("h1", {}, "What was measured"), (run, level) => [headline(run, level)]),
    h("ul", { class: "runs" }, ...lines.map((text) => h("li", {}, text))),
    ...report.runs.map(alarm),
    ...report.playbacks.map(cutShort),
    ...cut.map(partCutShort),
  );
}
