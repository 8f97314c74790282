/** The finite elements: which method's normal the force of a sub-particle analysis follows. */
import { command } from "../commands";
import type { Report } from "../data";
import type { Fem } from "../data_fem";
import { type Child, h, section } from "../dom";
import { count, number } from "../numbers";
import { figure } from "../plot";
import { legend, methodName } from "../swatch";
import { definitions } from "../table";
import { femDrawing } from "./fem_plot";
import { anglesTable, behind, checksBlock, convergenceBlock, halfSpaceBlock, plotTable } from "./fem_tables";
import { askedWords, describeFem, methodsOf, unansweredWords } from "./fem_words";
import { marked } from "./study_words";

const QUESTION = "Which normal does the force have when the bodies are elastic, and how far is it from each method's?";

const WHAT =
  "Both bodies are meshed and pressed together by CalculiX until they overlap by the given ratio, linear elastic and without friction. The direction of the whole contact force is then held against the normals of the methods: CN, the common normal (auto), GP, the line between the two deepest points (geometric_potential), and others.";

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
  `How large the force is depends on how the bodies are held (here: ${held}), so the magnitudes are of these runs alone. Its direction hardly depends on it.`,
  "The bodies are linear elastic and without friction. Of other materials, of friction and of geometries that are not in the table it says nothing.",
];

const limitsBlock = ({ held }: Fem): Child[] => [
  h("h3", {}, "What this does not show"),
  h("ul", { class: "fem-limits" }, ...LIMITS(held).map((text) => h("li", {}, text))),
];

function answersBlock(fem: Fem): Child[] {
  if (fem.answers.length === 0) return [h("p", { class: "empty" }, "There is no answer.")];
  const marks = "✗ marks an angle of which what is asked above does not hold.";
  return [
    askedList(fem),
    ...plotBlock(fem),
    ...limitsBlock(fem),
    h("h3", {}, "The answers"),
    anglesTable(fem),
    h("p", { class: "note" }, marks),
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
    ...answersBlock(fem),
    ...behind(fem),
    ...unansweredBlock(fem),
    ...checksBlock(checks),
    ...convergenceBlock(convergence),
    ...halfSpaceBlock(half_space),
    h("h3", {}, "How it was made"),
    setting(fem),
    h("p", { class: "note" }, `At commit ${commit}${interrupted ? " (interrupted)" : ""}:`),
    command(text),
  );
}
