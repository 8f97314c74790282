/** What the page opens with: who finds the right contact normal and who does not, for a reader who knows nothing of it yet. */
import { command } from "../commands";
import type { Failure, MethodRow, Run } from "../data";
import { h } from "../dom";
import { rightAt, toLevel } from "../accuracy";
import { made } from "../made";
import { interval, percent } from "../numbers";
import { perLevel, perRun, type State } from "../state";
import { methodName } from "../swatch";
import { plainView3d, releaseCards } from "../view3d/cards";
import {
  countedSentence,
  offWords,
  type Outcome,
  outcomeOf,
  outcomeWords,
  pictureSentence,
  seenOf,
  simplestOf,
  worstFirst,
} from "./answer_words";

const WHAT = "Where two bodies touch, they push each other along one direction: the contact normal.";

const KINDS: [keyof Omit<Outcome, "answers">, string][] = [
  ["right", "right"],
  ["gaveUp", "no answer"],
  ["wrong", "wrong"],
  ["unjudged", "not judged"],
];

/** All answers from left to right; what is not judged stays empty. */
function shares(outcome: Outcome): HTMLElement {
  const parts = KINDS.filter(([kind]) => outcome[kind] > 0).map(([kind]) =>
    h("i", { class: kind, style: `flex-grow: ${outcome[kind]}` }),
  );
  return h("span", { class: "shares", "aria-hidden": "true" }, ...parts);
}

function solver(row: MethodRow, level: string, publishedBy: Map<string, string>): HTMLElement {
  const outcome = outcomeOf(row, level);
  const right = rightAt(row, level);
  const from = publishedBy.get(row.method);
  const figure =
    right.share === null
      ? h("span", { class: "unknown" }, "not judged")
      : h(
          "span",
          {},
          h("strong", {}, `${percent(right.share)} %`),
          h("small", {}, ` ${interval(right.low, right.high)}`),
        );
  return h(
    "li",
    { class: row.published ? "" : "is-own" },
    h("span", { class: "who" }, methodName(row.method), from ? h("small", {}, from) : null),
    shares(outcome),
    h("span", { class: "much" }, figure),
    h("span", { class: "words" }, outcomeWords(outcome), h("small", {}, offWords(row))),
  );
}

function key(level: string): HTMLElement {
  const entry = ([kind, text]: [string, string]) =>
    h("li", {}, h("span", { class: "shares", "aria-hidden": "true" }, h("i", { class: kind })), ` ${text}`);
  return h(
    "div",
    { class: "shares-key" },
    h("ul", { "aria-label": "Colours of the bars" }, ...KINDS.map(entry)),
    h(
      "span",
      {},
      `Right: of the judged answers, ${toLevel(level)}, with the 95 % interval; “Required accuracy” changes it. Off: from the common normal, also where a method solves for another.`,
    ),
  );
}

function solvers(run: Run, level: string, state: State): HTMLElement {
  const publishedBy = new Map(state.report.methods.map(({ name, published_by }) => [name, published_by]));
  const rows = worstFirst(run.totals, level).map((row) => solver(row, level, publishedBy));
  return h("ul", { class: "solvers", "aria-label": "Solvers, and how often each is right" }, ...rows);
}

function picture(failure: Failure | null): HTMLElement | null {
  if (!failure) return null;
  const shown = seenOf(failure);
  const name = `two bodies, the right normal and the one that ${failure.method} gives`;
  return h("div", { class: "opening" }, plainView3d(shown, name), command(shown.replay, "the command that replays it"));
}

export function answerSection(state: State): HTMLElement {
  const figure = h("div");
  const failures = (run: Run) => simplestOf(run);
  const sentences = perLevel(state, h("div", { class: "sentences" }), (run, level) => [
    h("p", {}, WHAT),
    h("p", {}, pictureSentence(failures(run))),
    h("p", {}, countedSentence(run, level)),
  ]);
  perRun(state, figure, (run) => {
    releaseCards(figure);
    return [picture(failures(run))];
  });
  const list = perLevel(state, h("div"), (run, level) => [solvers(run, level, state), key(level)]);
  const commands = perRun(state, h("div"), (run) => [made(run.commands, "a command for each family of pairs")]);
  const heading = h("h2", { id: "answer-title" }, "Who fails, and how often");
  return h(
    "section",
    { id: "answer", "aria-labelledby": heading.id },
    h("div", { class: "opened" }, sentences, figure),
    heading,
    list,
    commands,
  );
}
