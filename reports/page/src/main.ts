import type { Report } from "./data";
import { USUAL_LEVEL } from "./accuracy";
import { h, unfold } from "./dom";
import { meetMethods } from "./methods";
import { preparePaper } from "./paper";
import { loadPlotly } from "./plot";
import { footer } from "./sections/footer";
import { header } from "./sections/header";
import { nav } from "./sections/nav";
import { partsOf } from "./sections/sections";
import type { State } from "./state";
import { startTheme } from "./theme";
import { load3d } from "./view3d/cards";
import { Watched } from "./watched";

function readReport(): Report | null {
  const text = document.getElementById("plumb-data")?.textContent;
  return text ? (JSON.parse(text) as Report) : null;
}

function show(report: Report, page: HTMLElement): void {
  meetMethods(report);
  const newest = report.runs.at(-1);
  const state: State = { report, run: newest ? new Watched(newest) : null, accuracy: new Watched(USUAL_LEVEL) };
  const parts = partsOf(state);
  if (parts.every(({ isAbout }) => isAbout)) {
    page.append(h("p", { class: "notice" }, "The report holds no run, no scene, no study and no finite elements."));
    return;
  }
  const skip = h("a", { class: "skip", href: "#main" }, "Skip to the report");
  const main = h("main", { id: "main", tabindex: -1 }, ...parts.map(({ element }) => element));
  page.append(skip, header(state), nav(state, parts), main, footer(report));
  if (location.hash) openTarget();
}

/** A link may lead into a section that is folded. */
function openTarget(): void {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  unfold(target);
  target?.scrollIntoView();
}

/** The page can be read, and the figures in view are drawn. What is further down gets its libraries when nothing else is to do. */
function tellReady(): void {
  requestAnimationFrame(() =>
    requestAnimationFrame(async () => {
      await loadPlotly();
      performance.mark("ready");
      document.documentElement.dataset.ready = "true";
      const idle = globalThis.requestIdleCallback ?? ((work: () => void) => setTimeout(work, 200));
      idle(() => void load3d());
    }),
  );
}

const page = document.getElementById("page") as HTMLElement;
const report = readReport();
startTheme();
if (report) show(report, page);
else page.append(h("p", { class: "notice" }, "This is the empty template of plumb report: it holds no data."));
preparePaper();
tellReady();
