import { toLevel } from "../accuracy";
import type { Failure, Report, Run } from "../data";
import { button, checkbox, fill, h, section, select, unique } from "../dom";
import { inOrder } from "../methods";
import { count } from "../numbers";
import { perRun, type State } from "../state";
import { releaseCards } from "../view3d/cards";
import type { Watched } from "../watched";
import { failureCard } from "./failure_card";
import { byInterest, grouped } from "./gallery_order";

const FIRST = 6;
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
    const names = (key === "method" ? inOrder(words) : unique(words)).filter(Boolean);
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
  private readonly place = h("div", { class: "cards" });
  private readonly more = h("div", { class: "more" });
  readonly element = h("div", {}, this.place, this.more);
  private rest: Failure[] = [];
  constructor(private readonly report: Report) {}

  show(failures: Failure[]): void {
    releaseCards(this.place);
    this.place.replaceChildren();
    this.rest = [...failures];
    this.add(FIRST);
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

/** Cards behind a line that says how many they are. */
class Folded {
  private readonly summary = h("summary");
  private readonly cards: Cards;
  readonly element: HTMLElement;
  constructor(report: Report, kind: string) {
    this.cards = new Cards(report);
    this.element = h("details", { class: `folded-cards ${kind}` }, this.summary, this.cards.element);
  }

  show(failures: Failure[], words: string): void {
    this.element.hidden = failures.length === 0;
    this.summary.textContent = `${count(failures.length)} of them ${words}`;
    this.cards.show(failures);
  }
}

interface Gallery {
  parts: HTMLElement[];
  /** At another accuracy. */
  refill: (level: string) => void;
}

function gallery(run: Run, report: Report, accuracy: Watched<string>): Gallery {
  const all = run.failures;
  const words = new Map(all.map((failure) => [failure, wordsOf(failure)]));
  const filter: Filter = { finding: "", method: "", shapes: "", regime: "", family: "", ownOnly: false, text: "" };
  const status = h("p", { class: "status", role: "status" });
  const wrong = new Cards(report);
  const [rightEnough, refused] = [new Folded(report, "right-enough"), new Folded(report, "refusals")];
  const left = run.kept_failures > all.length ? ` here, of ${count(run.kept_failures)} that the run kept` : "";
  const refill = (level: string) => {
    const shown = all.filter((failure) => passes(failure, filter, words.get(failure) ?? ""));
    const groups = grouped(shown, level);
    const ordered = (group: Failure[]) => byInterest(group, run.totals, level);
    status.textContent = `${count(shown.length)} of ${count(all.length)} failures${left}; plumb's own first, then each method's most frequent in turn, who is least often right ${toLevel(level)} first`;
    wrong.show(ordered(groups.wrong));
    rightEnough.show(ordered(groups.right), `are right ${toLevel(level)}, and wrong only where more is asked for`);
    refused.show(ordered(groups.refused), "are refusals: the solver says itself that it has no answer");
  };
  refill(accuracy.value);
  const filters = controls(all, filter, () => refill(accuracy.value));
  return { parts: [filters, status, wrong.element, rightEnough.element, refused.element, key()], refill };
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
    entry("⬭", "patch", "patch: what both bodies have in common, up to the rim where their surfaces cross"),
  );
}

export function gallerySection(state: State): HTMLElement {
  const { report, accuracy } = state;
  const place = h("div");
  let refill = (_level: string) => {};
  accuracy.watch((level) => refill(level));
  perRun(state, place, (run) => {
    releaseCards(place);
    if (run.failures.length === 0) {
      refill = () => {};
      return [h("p", { class: "empty" }, "This run kept no failure.")];
    }
    const made = gallery(run, report, accuracy);
    refill = made.refill;
    return made.parts;
  });
  return section("gallery", "Failures", "What does a failure look like, and how is it replayed?", place);
}
