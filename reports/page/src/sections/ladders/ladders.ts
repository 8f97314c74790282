import type { Ladder, LadderRow, Run } from "../../data";
import { breakable, type Child, fill, h, section, select } from "../../dom";
import { made } from "../../made";
import { inOrder } from "../../methods";
import { NONE, number } from "../../numbers";
import { perRun, type State } from "../../state";
import { legend, methodName } from "../../swatch";
import { type Column, table } from "../../table";
import { LADDER_NAME } from "./ladder_name";
import { describeStep, firstFinding, heldPart, holdsOn, wholePercent } from "./ladder_words";
import { stabilityBlock } from "../stability";

const QUESTION = "How far does each method get, from easy to the last representable value, and what does it do there?";

interface LaddersView {
  hidden: Set<string>;
  /** The method whose first ladders to give way come first; "" keeps the order of `plumb families`. */
  order: string;
}

const methodsOf = (run: Run): string[] =>
  inOrder(run.ladders.flatMap((ladder) => ladder.methods.map((row) => row.method)));

const rowOf = (ladder: Ladder, method: string): LadderRow | undefined =>
  ladder.methods.find((row) => row.method === method);

/** Green only where every step is judged. */
function holds(row: LadderRow): Child[] {
  const judged = row.judged.filter((n) => n > 0).length;
  const word = judged === 0 ? "not judged" : "holds";
  return [h("span", { class: judged === row.judged.length ? "holds" : "" }, word), " ", h("small", {}, holdsOn(row))];
}

/** "1e-8", and below it which step that is. */
function letsGo(ladder: Ladder, row: LadderRow | undefined): Child[] {
  if (!row) return [NONE];
  if (row.lets_go === null) return holds(row);
  const step = h("small", {}, `step ${row.lets_go} of ${ladder.steps.length}`);
  return [h("strong", {}, number(ladder.steps[row.lets_go - 1])), " ", step];
}

function overview(run: Run, view: LaddersView): HTMLElement {
  const methods = methodsOf(run).filter((method) => !view.hidden.has(method));
  const held = (method: string) => run.ladders.filter((ladder) => rowOf(ladder, method)?.lets_go === null).length;
  const columns: Column<Ladder>[] = [
    LADDER_NAME,
    ...methods.map((method): Column<Ladder> => ({
      title: h("span", {}, methodName(method), h("small", {}, `holds on ${held(method)} of ${run.ladders.length}`)),
      cell: (ladder) => letsGo(ladder, rowOf(ladder, method)),
    })),
  ];
  const caption = "The easiest step of each ladder on which a method has a finding";
  return h("div", { class: "stacked" }, table({ caption, columns, rows: sorted(run, view) }));
}

/** Coloured from below: so much is wrong, and above it so much is lost. */
function rung(ladder: Ladder, row: LadderRow, step: number): HTMLElement {
  const judged = row.judged[step] ?? 0;
  const [wrong, lost] = [row.wrong[step] ?? 0, row.lost[step] ?? 0];
  const words = describeStep(ladder, row, step);
  const kind = judged === 0 ? "unknown" : row.lets_go === step + 1 ? "first" : wrong + lost === 0 ? "right" : "";
  const style = judged > 0 ? `--wrong: ${(100 * wrong) / judged}%; --lost: ${(100 * lost) / judged}%` : "";
  const text =
    judged === 0
      ? [(row.answers[step] ?? 0) > 0 ? "?" : ""]
      : [
          lost > 0 && h("i", {}, wholePercent(lost, judged)),
          (wrong > 0 || lost === 0) && h("span", {}, wholePercent(wrong, judged)),
        ];
  return h("span", { class: `rung ${kind}`, role: "img", "aria-label": words, title: words, style }, ...text);
}

function strips(ladder: Ladder, view: LaddersView): HTMLElement {
  const columns: Column<LadderRow>[] = [
    { title: "Method", head: true, cell: (row) => methodName(row.method) },
    {
      title: "Lets go at",
      cell: (row) => [...letsGo(ladder, row), h("small", { class: "what" }, firstFinding(row))],
    },
    ...ladder.steps.map((value, step): Column<LadderRow> => ({
      title: number(value),
      hint: `${ladder.knob}, step ${step + 1} of ${ladder.steps.length}`,
      cell: (row) => rung(ladder, row, step),
    })),
  ];
  const rows = inOrder(ladder.methods.map((row) => row.method))
    .filter((method) => !view.hidden.has(method))
    .map((method) => rowOf(ladder, method) as LadderRow);
  const caption = `${ladder.name}: findings in % of the judged answers, by ${ladder.knob}`;
  return h(
    "div",
    { class: "ladder" },
    h("h4", {}, breakable(ladder.name), " ", h("small", {}, `by ${ladder.knob}`)),
    table({ caption, columns, rows, rowClass: (row) => (row.published ? "" : "is-own"), hideCaption: true }),
  );
}

function sorted(run: Run, view: LaddersView): Ladder[] {
  if (view.order === "") return run.ladders;
  return [...run.ladders].sort((a, b) => heldPart(a, view.order) - heldPart(b, view.order));
}

const sample = (kind: string, shares: string, text: Child, words: string): HTMLElement =>
  h("li", {}, h("span", { class: `rung sample ${kind}`, style: shares, "aria-hidden": "true" }, text), ` ${words}`);

function key(): HTMLElement {
  const lost = "% are lost: the method says that it did not converge (italic, hatched)";
  return h(
    "ul",
    { class: "rung-key" },
    sample("", "--wrong: 30%", "30", "% of the judged answers are wrong"),
    sample("", "--lost: 30%", h("i", {}, "30"), lost),
    sample("first", "", "", "the step at which it lets go"),
    sample("unknown", "", "?", "no answer judged"),
  );
}

function content(run: Run, view: LaddersView): HTMLElement[] {
  if (run.ladders.length === 0) {
    const how = h("code", {}, "plumb campaign --family hard");
    return [h("p", { class: "empty" }, "This run holds no ladders: ", how, " climbs them.")];
  }
  const methods = methodsOf(run);
  const [table, all] = [h("div"), h("div", { class: "ladders" })];
  const redraw = () => {
    fill(table, overview(run, view));
    fill(all, ...sorted(run, view).map((ladder) => strips(ladder, view)));
  };
  const orders = methods.map((method): [string, string] => [method, `where ${method} lets go first`]);
  const pickOrder = (order: string) => {
    view.order = order;
    redraw();
  };
  redraw();
  return [
    h(
      "div",
      { class: "controls" },
      select("Order", [["", "by what makes them hard"], ...orders], view.order, pickOrder),
    ),
    legend("Methods", methods, methodName, view.hidden, redraw),
    table,
    made(
      run.families.filter(({ name }) => name === "hard").map((family) => family.command),
      "the ladders",
    ),
    h("h3", {}, "Step by step"),
    key(),
    all,
  ];
}

/** null where neither a run nor the report holds ladders. */
export function laddersSection(state: State): HTMLElement | null {
  const { runs, stability } = state.report;
  if (!stability && runs.every((run) => run.ladders.length === 0)) return null;
  const view: LaddersView = { hidden: new Set(), order: "" };
  const place = perRun(state, h("div"), (run) => content(run, view));
  const blocks = stability ? stabilityBlock(stability) : [];
  return section("ladders", "Hard cases, ladder by ladder", QUESTION, place, ...blocks);
}
