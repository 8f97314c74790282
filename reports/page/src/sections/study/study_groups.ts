/** The groups of pairs, every method's answers to them, and the angles of these by overlap ratio. */
import type { StudyAnswer, StudyGroup } from "../../data";
import { breakable, type Child, details, fill, h } from "../../dom";
import { inOrder } from "../../methods";
import { error, NONE, number } from "../../numbers";
import { figure } from "../../plot";
import { legend, methodName } from "../../swatch";
import { type Column, table } from "../../table";
import { anglesDrawing, angleScale } from "./study_plot";
import {
  angleCell,
  describeAngles,
  failsWords,
  groupWords,
  largestAngle,
  residueCell,
  shapeWords,
} from "./study_words";

const degrees = (...angles: number[]): string => angles.map((angle) => number(angle)).join(", ");

const GROUP_COLUMNS: Column<StudyGroup>[] = [
  { title: "Group", head: true, cell: ({ group }) => group },
  { title: "Bodies", cell: shapeWords },
  { title: "Of the original equations", cell: failsWords },
  { title: "θ_L, φ_L, °", figure: true, cell: ({ theta_L_deg, phi_L_deg }) => degrees(theta_L_deg, phi_L_deg) },
  { title: "Euler φ, θ, ψ, °", figure: true, cell: ({ euler_deg }) => degrees(...euler_deg) },
  {
    title: "Drawn",
    hint: "How many pairs were drawn until this one",
    figure: true,
    cell: ({ drawn }) => String(drawn),
  },
];

const METHOD: Column<StudyAnswer> = { title: "Method", head: true, cell: ({ method }) => methodName(method) };
const RATIO: Column<StudyAnswer> = { title: "Overlap ratio", figure: true, cell: ({ ratio }) => number(ratio) };

const residue = (index: number): Column<StudyAnswer> => ({
  title: `R${index + 1}`,
  figure: true,
  cell: ({ residues }) => residueCell(residues?.[index]),
});

const angle = (title: string, index: number): Column<StudyAnswer> => ({
  title: `${title}, °`,
  figure: true,
  cell: ({ angles_deg }) => angleCell(angles_deg?.[index]),
});

const offCell = ({ off_deg, certified }: StudyAnswer): Child[] => [
  angleCell(off_deg),
  certified ? null : h("small", { class: "interval" }, "not proved"),
];

const ANSWER_COLUMNS: Column<StudyAnswer>[] = [
  METHOD,
  RATIO,
  {
    title: "Status",
    cell: ({ status }) => (status === "converged" ? status : h("span", { class: "flag lost" }, breakable(status))),
  },
  ...[0, 1, 2, 3, 4].map(residue),
  angle("d, n1", 0),
  angle("d, n2", 1),
  angle("n1, n2", 2),
  { title: "Off, °", hint: "To the certified common normal", figure: true, cell: offCell },
];

const place = (answer: StudyAnswer, body: 0 | 1): string =>
  answer.points ? answer.points[body].map((x) => number(x, 6)).join(", ") : NONE;

const POINT_COLUMNS: Column<StudyAnswer>[] = [
  METHOD,
  RATIO,
  { title: "Point of body 1", figure: true, cell: (answer) => place(answer, 0) },
  { title: "Point of body 2", figure: true, cell: (answer) => place(answer, 1) },
];

function inRows({ answers }: StudyGroup): StudyAnswer[] {
  const order = inOrder(answers.map(({ method }) => method));
  return [...answers].sort((a, b) => order.indexOf(a.method) - order.indexOf(b.method) || a.ratio - b.ratio);
}

function answersOf(group: StudyGroup): HTMLElement {
  const rows = inRows(group);
  const caption = `${group.group}: residues R1 to R5, angles between the line through the points d and the normals n1, n2`;
  const points = () => table({ caption: `Points, ${group.group}`, columns: POINT_COLUMNS, rows, hideCaption: true });
  return h(
    "div",
    {},
    table({ caption, columns: ANSWER_COLUMNS, rows }),
    details(`Points of ${group.group}`, points, { "data-print": "closed" }),
  );
}

export function groupsBlock(groups: StudyGroup[]): Child[] {
  if (groups.length === 0) return [];
  const caption = "The groups: body 1 at the origin, body 2 on the line of θ_L and φ_L, turned by Euler angles";
  return [
    h("h3", {}, "The answers"),
    table({ caption, columns: GROUP_COLUMNS, rows: groups }),
    h(
      "p",
      { class: "note" },
      "✗ marks what tells an answer from the certified common normal: an angle of more than 0.01°, a residue above its sine.",
    ),
    ...groups.map((group, index) =>
      details(groupWords(group), () => answersOf(group), { class: "study-group", open: index === 0 }),
    ),
  ];
}

interface RatioRow {
  ratio: number;
  answers: StudyAnswer[];
}

/** A row for each ratio, a column for each method. */
function anglesTable({ group }: StudyGroup, answers: StudyAnswer[]): HTMLElement {
  const ratios = [...new Set(answers.map(({ ratio }) => ratio))].sort((a, b) => a - b);
  const rows = ratios.map((ratio): RatioRow => ({ ratio, answers: answers.filter((one) => one.ratio === ratio) }));
  const columns = inOrder(answers.map(({ method }) => method)).map((method): Column<RatioRow> => ({
    title: methodName(method),
    figure: true,
    cell: (row) => {
      const found = row.answers.find((one) => one.method === method);
      return found ? error(largestAngle(found)) : NONE;
    },
  }));
  const ratio: Column<RatioRow> = { title: "Overlap ratio", head: true, cell: (row) => number(row.ratio) };
  return table({ caption: `Largest angle, ${group}, °`, columns: [ratio, ...columns], rows, hideCaption: true });
}

export function anglesBlock(groups: StudyGroup[]): Child[] {
  const answers = groups.flatMap((group) => group.answers);
  if (answers.length === 0) return [];
  const hidden = new Set<string>();
  const scale = angleScale(answers);
  const shown = (group: StudyGroup) => group.answers.filter(({ method }) => !hidden.has(method));
  const answered = groups.filter((group) => group.answers.length > 0);
  const panels = answered.map((group) =>
    figure({
      caption: `${group.group}: ${failsWords(group)}`,
      describe: () => describeAngles(group, shown(group)),
      height: (width) => Math.min(330, Math.max(260, 0.8 * width)),
      draw: () => anglesDrawing(shown(group), scale),
      table: () => anglesTable(group, group.answers),
      zoom: false,
    }),
  );
  const methods = inOrder(answers.map(({ method }) => method));
  const redraw = () => panels.forEach((panel) => panel.redraw());
  const grid = h("div", { class: "panels" });
  fill(grid, ...panels.map(({ element }) => element));
  const note =
    "The largest of the three angles, 0 for a common normal. Dashed: 0.01°. On the line “0” it is exactly 0.";
  return [
    h("h3", {}, "Angles against the overlap ratio"),
    h("div", { id: "study-angles" }, legend("Methods", methods, methodName, hidden, redraw), grid),
    h("p", { class: "note" }, note),
  ];
}
