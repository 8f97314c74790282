import type { Report, Run } from "../data";
import { h } from "../dom";
import { count } from "../numbers";

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

export function header(report: Report): HTMLElement {
  const runs = report.runs.map(
    (run) => `${run.name}: ${count(run.cases)} cases, seed ${run.seed}, commit ${run.commit}`,
  );
  return h(
    "header",
    { class: "top" },
    h("p", { class: "brand" }, "plumb report"),
    h("h1", {}, "Does the contact normal stand true?"),
    h("ul", { class: "runs" }, ...runs.map((text) => h("li", {}, text))),
    ...report.runs.map(alarm),
  );
}
