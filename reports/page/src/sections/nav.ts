import { accuracySelect } from "../accuracy";
import { h, select, unfold } from "../dom";
import type { State } from "../state";
import { themeButton } from "../theme";
import type { Part } from "./sections";

function markCurrent(links: Map<Element, HTMLAnchorElement>): void {
  const watcher = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        if (!isIntersecting) continue;
        for (const link of links.values()) link.removeAttribute("aria-current");
        links.get(target)?.setAttribute("aria-current", "true");
      }
    },
    { rootMargin: "-20% 0px -70% 0px" },
  );
  for (const part of links.keys()) watcher.observe(part);
}

function runSelect(state: State): HTMLElement | null {
  const { runs } = state.report;
  const chosen = state.run;
  if (!chosen || runs.length < 2) return null;
  const choose = (index: string) => {
    const run = runs[Number(index)];
    if (run) chosen.value = run;
  };
  const choice = select(
    "Run",
    runs.map((run, index) => [String(index), run.name]),
    String(runs.indexOf(chosen.value)),
    choose,
  );
  choice.id = "run-choice";
  return choice;
}

export function nav(state: State, parts: Part[]): HTMLElement {
  const links = new Map(
    parts.map(({ name, element }) => [element, h("a", { href: `#${element.id}`, click: () => unfold(element) }, name)]),
  );
  markCurrent(links);
  const list = h("ul", {}, ...[...links.values()].map((link) => h("li", {}, link)));
  return h(
    "div",
    { class: "bar" },
    h("nav", { "aria-label": "Sections" }, list),
    h(
      "section",
      { class: "bar-end", "aria-label": "What is shown" },
      accuracySelect(state.report, state.accuracy),
      runSelect(state),
      themeButton(),
    ),
  );
}
