/** Every method's answer as a row: whether it is drawn, its degrees off, and in words what is wrong with it. */
import { checkbox, fill, h } from "../../page/src/dom";
import { number } from "../../page/src/numbers";
import { methodName } from "../../page/src/swatch";
import { isWrong, type Judged, SAME_OVERLAP, SEEN } from "./judge";

const ALLOWED = `Right: normals and the line through the points agree within ${SEEN}°, and no common normal has an overlap lower by more than ${SAME_OVERLAP} of the larger body's size.`;

const mark = (one: Judged): HTMLElement => {
  if (isWrong(one)) return h("strong", { class: "bad" }, "wrong");
  if (one.kind === "right") return h("span", { class: "good" }, "right");
  return h("span", { class: "muted" }, one.kind === "no_answer" ? "none" : "–");
};

function row(one: Judged, isShown: boolean, toggle: (on: boolean) => void): HTMLElement {
  const { method, contact, off, why, kind } = one;
  return h(
    "tr",
    { "data-method": method.name, "data-kind": kind },
    h("th", { scope: "row" }, checkbox(methodName(method.name), isShown, toggle)),
    h("td", {}, mark(one)),
    h("td", { class: "figure" }, contact.status === "converged" ? number(off < 1e-9 ? 0 : off, 3) : "–"),
    h("td", { class: "figure" }, contact.status === "converged" ? number(contact.overlap, 5) : "–"),
    h("td", {}, why),
  );
}

export class Answers {
  readonly hidden = new Set<string>();
  private readonly body = h("tbody");
  readonly element: HTMLElement;

  constructor(private readonly changed: () => void) {
    const heads = ["method (drawn)", "", "degrees off", "overlap", "why"].map((text) =>
      h("th", { scope: "col" }, text || h("span", { class: "unseen" }, "verdict")),
    );
    this.element = h(
      "div",
      { class: "answers", tabindex: 0, role: "region", "aria-label": "Answers of all methods" },
      h("table", {}, h("thead", {}, h("tr", {}, ...heads)), this.body),
      h("p", { class: "muted" }, ALLOWED),
    );
  }

  show(judged: Judged[]): void {
    const focused = document.activeElement?.closest("tr")?.dataset.method;
    const toggle = (name: string) => (on: boolean) => {
      if (on) this.hidden.delete(name);
      else this.hidden.add(name);
      this.changed();
    };
    fill(this.body, ...judged.map((one) => row(one, !this.hidden.has(one.method.name), toggle(one.method.name))));
    if (focused) this.body.querySelector<HTMLElement>(`[data-method="${focused}"] input`)?.focus();
  }
}
