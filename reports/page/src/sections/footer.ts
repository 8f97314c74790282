import plotlyLicence from "../../node_modules/plotly.js-cartesian-dist-min/LICENSE";
import threeLicence from "../../node_modules/three/LICENSE";
import type { Report } from "../data";
import { h } from "../dom";

const SIDECARS: [string, string][] = [
  [".json", "everything on this page"],
  [".md", "a summary to read"],
];
const OF_CAMPAIGNS: [string, string][] = [
  [".csv", "the summary's rows"],
  [".ladders.csv", "the hard cases, ladder by ladder"],
  [".sarif", "findings, for code hosts"],
  [".junit.xml", "results, for CI"],
];

/** The page's own name without .html. */
function stem(): string {
  const name = decodeURIComponent(location.pathname.split("/").pop() ?? "");
  return name.replace(/\.html?$/, "") || "report";
}

function sidecar([ending, what]: [string, string]): HTMLElement {
  const file = `${stem()}${ending}`;
  return h("li", {}, h("a", { href: `./${encodeURIComponent(file)}` }, file), ` ${what}`);
}

function licence(name: string, text: string): HTMLElement {
  const words = h("pre", { tabindex: 0, "aria-label": `The licence of ${name}` }, text);
  return h("details", { "data-print": "closed" }, h("summary", {}, `${name}, MIT licence`), words);
}

export function footer(report: Report): HTMLElement {
  const files = report.runs.length > 0 ? [...SIDECARS, ...OF_CAMPAIGNS] : SIDECARS;
  return h(
    "footer",
    {},
    h("h2", {}, "The same as data"),
    h("p", { class: "note" }, "Written beside this page:"),
    h("ul", { class: "files" }, ...files.map(sidecar)),
    h("h2", {}, "Licences"),
    h("p", { class: "note" }, `plumb: BSD-3-Clause, commit ${report.made.commit}. Inside this page:`),
    licence("plotly.js", plotlyLicence),
    licence("three.js", threeLicence),
  );
}
