import { command, copyButton, downloadButton } from "../commands";
import type { Answer, Failure, Report } from "../data";
import { breakable, type Child, details, h } from "../dom";
import { count, NONE, number } from "../numbers";
import { methodName } from "../swatch";
import { definitions, table } from "../table";
import { degrees, MEASURED, seenOf, sentenceOf } from "./answer_words";
import { view3d } from "../view3d/cards";

const KEPT: Record<Failure["kept"], string> = { simplest: "simplest", worst: "worst", only: "simplest and worst" };

function vector(values: readonly number[] | null | undefined): string {
  return values ? values.map((x) => number(x, 6)).join(", ") : NONE;
}

interface Line {
  name: string;
  of: (answer: Answer) => string;
}

const ANGLE = "angle error, °";
const LINES: Line[] = [
  { name: "status", of: (answer) => answer.status },
  { name: "verdict", of: (answer) => answer.verdict },
  { name: "overlap", of: (answer) => number(answer.overlap, 8) },
  { name: ANGLE, of: (answer) => number(answer.angle_error_deg, 4) },
  { name: "iterations", of: (answer) => number(answer.iterations) },
  { name: "normal", of: (answer) => vector(answer.normal) },
  { name: "p1", of: (answer) => vector(answer.points?.[0]) },
  { name: "p2", of: (answer) => vector(answer.points?.[1]) },
];

function comparison(failure: Failure): Child {
  const { answer, reference, reason } = failure.shrunk ?? failure;
  const missing = reason && h("p", { class: "note" }, `Not solved anew: ${reason}`);
  const hasAngle = [answer, reference].some((one) => (one?.angle_error_deg ?? null) !== null);
  const rows = LINES.filter(({ name }) => hasAngle || name !== ANGLE);
  const of = (one: Answer | null) => (line: Line) => (one ? line.of(one) : NONE);
  const columns = [
    { title: "", head: true, cell: (line: Line) => line.name },
    { title: "Answer", figure: true, cell: of(answer) },
    { title: "Reference", figure: true, cell: of(reference) },
  ];
  return h(
    "div",
    {},
    missing,
    table({ caption: `${failure.bucket}: answer and reference`, columns, rows, hideCaption: true }),
  );
}

function caseText(failure: Failure): HTMLElement {
  const shown = seenOf(failure);
  const text = JSON.stringify(shown.case);
  const code = h("code", {}, JSON.stringify(shown.case, null, 1));
  const file = shown.file.split("/").pop() || `${failure.bucket}.json`;
  return h(
    "div",
    { class: "case" },
    h("div", { class: "tools" }, copyButton(text, code, "the case"), downloadButton(text, file)),
    h("pre", { tabindex: 0, "aria-label": "The case as JSON" }, code),
  );
}

function law(failure: Failure, report: Report): HTMLElement {
  const known = report.laws.find(({ name }) => name === failure.law);
  const place = known && h("code", {}, ` ${known.file}:${known.line}`);
  return h("p", { class: "law" }, h("strong", {}, failure.law), known ? `: ${known.statement}` : null, place);
}

function facts(failure: Failure): HTMLElement {
  const list = definitions([
    ["Severity", number(failure.severity === "infinite" ? Number.POSITIVE_INFINITY : failure.severity)],
    ["In the bucket", count(failure.count)],
    ["Kept", KEPT[failure.kept]],
    ["Shapes", breakable(failure.shapes)],
    ...(failure.regime ? [["Regime", failure.regime] as [string, Child]] : []),
    ["Family", failure.family],
  ]);
  list.className = "facts small";
  return list;
}

/** "12.3° off", or what else it is that is wrong. */
function howFar(failure: Failure): HTMLElement | null {
  const angle = seenOf(failure).answer?.angle_error_deg ?? null;
  if (angle === null || angle < MEASURED || seenOf(failure).answer?.status !== "converged") return null;
  return h("p", { class: "how-far" }, h("strong", {}, degrees(angle)), " off the right normal");
}

function behind(failure: Failure, report: Report, matters: string): HTMLElement {
  return h(
    "div",
    { class: "behind" },
    matters ? h("p", {}, matters) : null,
    comparison(failure),
    law(failure, report),
    failure.shrunk ? h("p", { class: "detail" }, failure.detail) : null,
    facts(failure),
  );
}

export function failureCard(failure: Failure, report: Report): HTMLElement {
  const name = [`${failure.finding} of ${failure.method}`, failure.shapes, failure.regime].filter(Boolean).join(", ");
  const [sentence, matters] = sentenceOf(failure);
  const shown = seenOf(failure);
  const title = h(
    "h3",
    {},
    h("span", { class: "finding" }, failure.finding.replaceAll("_", " ")),
    methodName(failure.method),
  );
  return h(
    "article",
    { class: failure.own ? "card is-own" : "card", "aria-label": name },
    view3d(shown, name),
    h(
      "div",
      { class: "card-text" },
      title,
      howFar(failure),
      h("p", { class: "sentence" }, sentence),
      command(shown.replay, `the command that replays ${failure.bucket}`),
      details("Answer, reference and law", () => behind(failure, report, matters)),
      details("The case as JSON", () => caseText(failure), { "data-print": "closed" }),
    ),
  );
}
