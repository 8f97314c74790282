/** All real solutions of the six published equations, and what an answer costs. */
import type { StudyCost, StudyRoot, StudyRoots } from "../../data";
import { type Child, details, h } from "../../dom";
import { inOrder } from "../../methods";
import { count, error, NONE, number, percent } from "../../numbers";
import { methodName } from "../../swatch";
import { type Column, table } from "../../table";
import { angleCell, kindWords, residueCell } from "./study_words";

const startsCell = (root: StudyRoot, { starts }: StudyRoots): string =>
  starts > 0 ? `${count(root.starts)} (${percent(root.starts / starts)} %)` : count(root.starts);

const columnsOf = (pair: StudyRoots): Column<StudyRoot>[] => [
  { title: "Kind", head: true, cell: ({ kind }) => kindWords(kind) },
  { title: "Off, °", figure: true, cell: ({ off_deg }) => angleCell(off_deg) },
  { title: "Starts that end here", figure: true, cell: (root) => startsCell(root, pair) },
  {
    title: "Documented",
    hint: "The method's own start ends here",
    cell: ({ documented }) => (documented ? "yes" : ""),
  },
  { title: "Normal", figure: true, cell: ({ normal }) => normal?.map((x) => number(x)).join(", ") ?? NONE },
  { title: "Distance", figure: true, cell: ({ distance }) => number(distance) },
  ...[0, 1, 2].map((index): Column<StudyRoot> => ({
    title: `R${index + 3}`,
    figure: true,
    cell: ({ residues }) => residueCell(residues?.[index]),
  })),
];

/** Dozens of rows a pair: the first is open. */
function pairBlock(pair: StudyRoots, index: number): HTMLElement {
  const all = pair.complete ? "all are here" : `not all may be here${pair.reason ? `: ${pair.reason}` : ""}`;
  const ends = `of ${count(pair.starts)} random starts ${count(pair.not_converged)} did not converge, ${count(pair.elsewhere)} ended elsewhere`;
  const caption = `${count(pair.roots.length)} real solutions, ${all}; ${ends}`;
  const solutions = () => table({ caption, columns: columnsOf(pair), rows: pair.roots });
  const common = pair.roots.filter(({ kind }) => kind === "common normal").length;
  const heading = `${pair.pair}: ${count(pair.roots.length)} real solutions, ${count(common)} of them common normals`;
  return details(heading, solutions, { class: "study-pair", open: index === 0 });
}

export function rootsBlock(roots: StudyRoots[]): Child[] {
  if (roots.length === 0) return [];
  const note =
    "Lin and Ng's equations have several real solutions at one pair. Which of them Newton's iteration finds is up to its start; documented is that of the method itself.";
  return [h("h3", {}, "The solutions of the six equations"), h("p", { class: "note" }, note), ...roots.map(pairBlock)];
}

function costCell(cost: StudyCost | undefined): Child[] {
  if (!cost) return [NONE];
  if (cost.evaluations === null)
    return [h("span", {}, "not reached"), h("small", {}, `${percent(cost.share)} % of the pairs`)];
  return [
    h("span", {}, number(cost.evaluations)),
    cost.tolerance !== null && h("small", {}, `tolerance ${error(cost.tolerance)}`),
    h("small", {}, `${percent(cost.share)} % of the pairs`),
  ];
}

function costTable(set: string, costs: StudyCost[]): HTMLElement {
  const targets = [...new Set(costs.map(({ target_deg }) => target_deg))].sort((a, b) => b - a);
  const columns = targets.map((target): Column<string> => ({
    title: `to ${number(target)}°`,
    cell: (method) => costCell(costs.find((cost) => cost.method === method && cost.target_deg === target)),
  }));
  const head: Column<string> = { title: "Method", head: true, cell: methodName };
  const rows = inOrder(costs.map(({ method }) => method));
  const caption = `${set}: evaluations at the cheapest tolerance that comes that near to the method's own solution`;
  return h("div", { class: "stacked" }, table({ caption, columns: [head, ...columns], rows }));
}

export function costsBlock(costs: StudyCost[]): Child[] {
  if (costs.length === 0) return [];
  const sets = [...new Set(costs.map(({ set }) => set))];
  return [
    h("h3", {}, "What an answer costs"),
    ...sets.map((set) =>
      costTable(
        set,
        costs.filter((cost) => cost.set === set),
      ),
    ),
  ];
}
