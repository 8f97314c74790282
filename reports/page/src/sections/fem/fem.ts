/** The finite elements: which method's normal the force of a sub-particle analysis follows. */
import { command } from "../../commands";
import type { Fem, Report } from "../../data";
import { type Child, h, section } from "../../dom";
import { madeBy } from "../../made";
import { count, number } from "../../numbers";
import { figure } from "../../plot";
import { legend, methodName } from "../../swatch";
import { definitions } from "../../table";
import { femDrawing } from "./fem_plot";
import { anglesTable, behind, checksBlock, convergenceBlock, halfSpaceBlock, plotTable } from "./fem_tables";
import { askedWords, describeFem, methodsOf, unansweredWords } from "./fem_words";
import { marked } from "../study/study_words";

const QUESTION = "Which normal does the force have when the bodies are elastic, and how far is it from each method's?";

const WHAT =
  "Both bodies are meshed and pressed together by CalculiX until they overlap by the given ratio, linear elastic and without friction. The direction of the whole contact force is then held against the normals of the methods: CN, the common normal (auto), GP, the line between the two deepest points (geometric_potential), and others.";

const METHODS =
  "CN is what auto answers, and original_cn that solver's converged answer. The other three are no solver's answers but the certified solutions of their definitions: GP (plumb certify --problem deepest_points), geometric_potential_midway (midway) and first_touch (first_touch).";

function setting({ mode, young, poisson, held, host }: Fem): HTMLElement {
  const list = definitions([
    ["Mode", mode],
    ["Young's modulus", number(young)],
    ["Poisson's ratio", number(poisson)],
    ["Held", held],
    ...Object.entries(host).map(([name, version]): [string, Child] => [name, version]),
  ]);
  list.className = "facts";
  return list;
}

function askedList(fem: Fem): HTMLElement {
  const items = askedWords(fem).map(({ words, held, of }) =>
    h("li", {}, `${words}: in `, marked(`${count(held)} of ${count(of)} answers`, held < of), "."),
  );
  return h("ul", { class: "fem-asked" }, ...items);
}

function plotBlock(fem: Fem): Child[] {
  const hidden = new Set<string>();
  const methods = methodsOf(fem.answers);
  const shown = () => methods.filter((method) => !hidden.has(method));
  const plot = figure({
    caption: "Angle between the force and each method's normal",
    describe: () => describeFem(fem.answers, shown()),
    height: (width) => Math.min(460, Math.max(320, 0.5 * width)),
    draw: () => femDrawing(fem, hidden),
    table: () => plotTable(fem),
    longTable: true,
  });
  const note =
    "One mark for each geometry and method; marks of one overlap ratio stand side by side. Dashed: what is asked of CN.";
  return [
    h("div", { id: "fem-angles" }, legend("Methods", methods, methodName, hidden, plot.redraw), plot.element),
    h("p", { class: "note" }, note),
  ];
}

const LIMITS = (held: string): string[] => [
  "That the force comes to CN as the overlap vanishes is expected from mechanics: the patch shrinks to a point, and the pressure is normal to the surfaces there. This agreement is no discovery. What informs is the error of GP, which stays as the overlap vanishes.",
  `How large the force is depends on how the bodies are held (here: ${held}), so the magnitudes are of these runs alone. How far its direction does, the table of settings says.`,
  "The force leaves CN where the curvature changes across the patch: the pressure's centre wanders from the contact point towards the flatter side, and the normals there are others. The half-spaces' table says by how much the curvature changes.",
  "It does not set CN above midway and first touch, whose normals agree with CN's to first order of the overlap: they are about as near to the force as CN, at larger overlaps often nearer. Where both bodies have the same exponents, midway and first touch are one normal.",
  "The bodies are linear elastic and without friction. Of other materials, of friction and of geometries that are not in the table it says nothing.",
];

const limitsBlock = ({ held }: Fem): Child[] => [
  h("h3", {}, "What this does not show"),
  h("ul", { class: "fem-limits" }, ...LIMITS(held).map((text) => h("li", {}, text))),
];

const NOTES = [
  "✗ marks an angle of which what is asked above does not hold.",
  "A patch radius is nominal: of a circle of half the area in which the undeformed bodies overlap, seen along the common normal. That is Hertz's patch.",
];

function answersBlock(fem: Fem): Child[] {
  if (fem.answers.length === 0) return [h("p", { class: "empty" }, "There is no answer.")];
  return [
    askedList(fem),
    ...plotBlock(fem),
    ...limitsBlock(fem),
    h("h3", {}, "The answers"),
    anglesTable(fem),
    ...NOTES.map((text) => h("p", { class: "note" }, text)),
  ];
}

function unansweredBlock({ unanswered }: Fem): Child[] {
  if (unanswered.length === 0) return [];
  const items = unanswered.map((one) => h("li", {}, unansweredWords(one)));
  return [h("h3", {}, "Without an answer"), h("ul", { class: "fem-unanswered" }, ...items)];
}

export function femSection({ fem }: Report): HTMLElement | null {
  if (!fem) return null;
  const { checks, convergence, half_space, commit, command: text, interrupted } = fem;
  return section(
    "fem",
    "Against finite elements",
    QUESTION,
    h("p", { class: "what" }, WHAT),
    h("p", { class: "note" }, METHODS),
    ...madeBy(text, [
      ["the answers", answersBlock(fem)],
      ["what is behind them", behind(fem)],
      ["what has no answer", unansweredBlock(fem)],
      ["the checks", checksBlock(checks)],
      ["the convergence", convergenceBlock(convergence)],
      ["the half-spaces", halfSpaceBlock(half_space)],
    ]),
    h("h3", {}, "How it was made"),
    setting(fem),
    h("p", { class: "note" }, `At commit ${commit}${interrupted ? " (interrupted)" : ""}:`),
    command(text),
  );
}
