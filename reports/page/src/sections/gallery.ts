import type { Failure, Report, Run } from "../data";
import { button, checkbox, fill, h, section, select, unique } from "../dom";
import { inOrder } from "../methods";
import { count } from "../numbers";
import { perRun, type State } from "../state";
import { releaseCards } from "../view3d/cards";
import { failureCard } from "./failure_card";

const BATCH = 24;
const KEYS = ["finding", "method", "shapes", "regime", "family"] as const;
type Key = (typeof KEYS)[number];

interface Filter extends Record<Key, string> {
  ownOnly: boolean;
  text: string;
}

function passes(failure: Failure, filter: Filter, haystack: string): boolean {
  if (filter.ownOnly && !failure.own) return false;
  if (KEYS.some((key) => filter[key] !== "" && failure[key] !== filter[key])) return false;
  return filter.text
    .toLowerCase()
    .split(/\s+/)
    .every((word) => haystack.includes(word));
}

const wordsOf = (failure: Failure): string =>
  [failure.bucket, failure.family, failure.law, failure.detail, failure.file, failure.case.name ?? "", failure.kept]
    .join(" ")
    .toLowerCase();

function controls(failures: Failure[], filter: Filter, changed: () => void): HTMLElement {
  const choice = (key: Key) => {
    const words = failures.map((failure) => failure[key]);
    const names = key === "method" ? inOrder(words) : unique(words);
    const values = names.map((name): [string, string] => [name, name]);
    const title = key.charAt(0).toUpperCase() + key.slice(1);
    return select(title, [["", "all"], ...values], "", (value) => {
      filter[key] = value;
      changed();
    });
  };
  const search = h("input", {
    type: "search",
    placeholder: "words of bucket, law, detail",
    input: () => {
      filter.text = search.value;
      changed();
    },
  });
  const own = checkbox("Plumb's own only", false, (on) => {
    filter.ownOnly = on;
    changed();
  });
  return h(
    "div",
    { class: "controls", role: "search", "aria-label": "Filter the failures" },
    ...KEYS.map(choice),
    h("label", { class: "field" }, h("span", {}, "Text"), search),
    own,
  );
}

/** Cards in batches: hundreds at once would only be scrolled past. */
class Cards {
  readonly place = h("div", { class: "cards" });
  readonly more = h("div", { class: "more" });
  private rest: Failure[] = [];
  constructor(private readonly report: Report) {}

  show(failures: Failure[]): void {
    releaseCards();
    this.place.replaceChildren();
    this.rest = failures;
    this.add(BATCH);
  }

  private add(most: number): void {
    for (const failure of this.rest.splice(0, most)) this.place.append(failureCard(failure, this.report));
    const left = this.rest.length;
    if (left === 0) fill(this.more);
    else
      fill(
        this.more,
        button(`Show ${Math.min(BATCH, left)} more`, () => this.add(BATCH)),
        button(`Show all ${count(left)} others`, () => this.add(left), { class: "quiet" }),
      );
  }
}

function gallery(run: Run, report: Report): HTMLElement[] {
  if (run.failures.length === 0) return [h("p", { class: "empty" }, "This run kept no failure.")];
  const all = run.failures;
  const words = new Map(all.map((failure) => [failure, wordsOf(failure)]));
  const filter: Filter = { finding: "", method: "", shapes: "", regime: "", family: "", ownOnly: false, text: "" };
  const status = h("p", { class: "status", role: "status" });
  const cards = new Cards(report);
  const left = run.kept_failures > all.length ? ` here, of ${count(run.kept_failures)} that the run kept` : "";
  const refill = () => {
    const shown = all.filter((failure) => passes(failure, filter, words.get(failure) ?? ""));
    status.textContent = `${count(shown.length)} of ${count(all.length)} failures${left}; plumb's own first, then each method's most frequent in turn`;
    cards.show(shown);
  };
  refill();
  return [controls(all, filter, refill), key(), status, cards.place, cards.more];
}

/** What stands for what in the 3-D views; the labels there say the same. */
function key(): HTMLElement {
  const entry = (sign: string, kind: string, text: string) =>
    h("li", { class: kind }, h("span", { class: "sign", "aria-hidden": "true" }, sign), text);
  return h(
    "ul",
    { class: "key", "aria-label": "Signs in the 3-D views" },
    entry("●", "first", "body 1, solid lines; p1, its normal n1"),
    entry("■", "second", "body 2, dashed lines; p2, its normal n2"),
    entry("➝", "link", "d = p2 − p1"),
    entry("◆", "reference", "the reference's points and normal"),
  );
}

export function gallerySection(state: State): HTMLElement {
  const place = perRun(state, h("div"), (run) => gallery(run, state.report));
  return section("gallery", "Failure gallery", "What does a failure look like, and how is it replayed?", place);
}
