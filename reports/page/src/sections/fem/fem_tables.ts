/** The finite elements' tables: angles and centres, what was checked, convergence, half-spaces, geometries. */
import type { Fem, FemAnswer, FemCheck, FemConvergence, FemGeometry, HalfSpace } from "../../data";
import { breakable, type Child, details, h } from "../../dom";
import { count, error, NONE, number } from "../../numbers";
import { methodName } from "../../swatch";
import { type Column, table } from "../../table";
import { angleTo, bodiesWords, isMarked, methodsOf } from "./fem_words";
import { marked } from "../study/study_words";

interface Place {
  geometry: string;
  ratio: number;
}

const GEOMETRY: Column<Place> = { title: "Geometry", head: true, cell: ({ geometry }) => geometry };
const RATIO: Column<Place> = { title: "Overlap ratio", figure: true, cell: ({ ratio }) => number(ratio) };

const byPlace = <Row extends Place>(rows: Row[]): Row[] =>
  [...rows].sort((a, b) => a.geometry.localeCompare(b.geometry, "en", { numeric: true }) || a.ratio - b.ratio);

const degrees = (angle: number | null): string => (angle === null ? NONE : number(angle));

function angleCell(answer: FemAnswer, method: string): Child[] {
  const off = answer.centre_off[method] ?? null;
  const angle = marked(degrees(angleTo(answer, method)), isMarked(answer, method));
  return [angle, off === null ? null : h("small", { class: "interval" }, `centre ${number(off, 2)}`)];
}

const APART: Column<FemAnswer> = {
  title: "CN, GP, °",
  hint: "Between the two normals",
  figure: true,
  cell: ({ cn_to_gp_deg }) => degrees(cn_to_gp_deg),
};

export function anglesTable({ answers }: Fem): HTMLElement {
  const columns = methodsOf(answers).map((method): Column<FemAnswer> => ({
    title: methodName(method),
    figure: true,
    cell: (answer) => angleCell(answer, method),
  }));
  const caption =
    "Angle between the force and each method's normal, °; below it, how far the pressure's centre is from the method's contact point, in patch radii";
  return table({ caption, columns: [GEOMETRY, RATIO, ...columns, APART], rows: byPlace(answers) });
}

/** The figures of the plot alone. */
export function plotTable({ answers }: Fem): HTMLElement {
  const columns = methodsOf(answers).map((method): Column<FemAnswer> => ({
    title: methodName(method),
    figure: true,
    cell: (answer) => error(angleTo(answer, method)),
  }));
  const caption = "Angle between the force and each method's normal, °";
  return table({ caption, columns: [GEOMETRY, RATIO, ...columns], rows: byPlace(answers), hideCaption: true });
}

const RUN_COLUMNS: Column<FemAnswer>[] = [
  GEOMETRY as Column<FemAnswer>,
  RATIO as Column<FemAnswer>,
  { title: "Force", figure: true, cell: ({ force }) => number(force) },
  { title: "Its direction", figure: true, cell: ({ direction }) => direction.map((x) => number(x, 5)).join(", ") },
  {
    title: "Patch radius",
    hint: "Nominal: of a circle of half the area in which the undeformed bodies overlap",
    figure: true,
    cell: ({ patch_radius }) => number(patch_radius),
  },
  {
    title: "Of the elements",
    hint: "Of a circle as large as the contact elements under pressure",
    figure: true,
    cell: ({ fem_patch_radius }) => number(fem_patch_radius),
  },
  {
    title: "Balance",
    hint: "Sum of the forces on the two bodies over one of them",
    figure: true,
    cell: ({ balance }) => error(balance),
  },
  { title: "Nodes", figure: true, cell: ({ nodes }) => count(nodes) },
  { title: "Iterations", figure: true, cell: ({ iterations }) => count(iterations) },
];

const GEOMETRY_COLUMNS: Column<FemGeometry>[] = [
  { title: "Geometry", head: true, cell: ({ name }) => name },
  { title: "Shape", cell: ({ shape }) => shape },
  { title: "Semi-axes", cell: bodiesWords },
  { title: "θ_L, φ_L, °", figure: true, cell: ({ line_deg }) => line_deg.map((angle) => number(angle)).join(", ") },
  {
    title: "Quaternion of body 2: w, x, y, z",
    figure: true,
    cell: ({ quaternion }) => quaternion.map((x) => number(x, 4)).join(", "),
  },
];

/** What a reader looks up: shut. */
export function behind({ answers, geometries }: Fem): Child[] {
  const runs = () => table({ caption: "Each run", columns: RUN_COLUMNS, rows: byPlace(answers), hideCaption: true });
  const pairs = () =>
    table({ caption: "The geometries", columns: GEOMETRY_COLUMNS, rows: geometries, hideCaption: true });
  return [
    answers.length > 0 && details("Each run: force, patch, balance, mesh", runs, { "data-print": "closed" }),
    geometries.length > 0 && details(`The ${count(geometries.length)} geometries`, pairs, { class: "fem-geometries" }),
  ];
}

const CHECK_COLUMNS: Column<FemCheck>[] = [
  { title: "Check", head: true, cell: ({ check }) => breakable(check) },
  { title: "Value", figure: true, cell: ({ value, within }) => marked(number(value), !within) },
  { title: "Limit", figure: true, cell: ({ limit }) => number(limit) },
  { title: "Unit", cell: ({ unit }) => unit },
];

export function checksBlock(checks: FemCheck[]): Child[] {
  if (checks.length === 0) return [];
  const within = checks.filter((check) => check.within).length;
  const caption = `${count(within)} of ${count(checks.length)} within their limits`;
  return [h("h3", {}, "Checked before any claim"), table({ caption, columns: CHECK_COLUMNS, rows: checks })];
}

const CONVERGENCE_COLUMNS: Column<FemConvergence>[] = [
  GEOMETRY as Column<FemConvergence>,
  RATIO as Column<FemConvergence>,
  { title: "Varied", cell: ({ varied }) => breakable(varied) },
  { title: "Setting", cell: ({ setting }) => breakable(setting) },
  { title: "Force turned, °", figure: true, cell: ({ turned_deg }) => number(turned_deg, 2) },
  { title: "Force changed, %", figure: true, cell: ({ force_change }) => number(100 * force_change, 2) },
  {
    title: "Patch changed, %",
    hint: "The radius of the contact elements under pressure",
    figure: true,
    cell: ({ patch_change }) => number(100 * patch_change, 2),
  },
  {
    title: "Centre shifted",
    hint: "In patch radii",
    figure: true,
    cell: ({ centre_shift }) => number(centre_shift, 2),
  },
];

export function convergenceBlock(convergence: FemConvergence[]): Child[] {
  if (convergence.length === 0) return [];
  const caption = "One setting changed, against the study's own; the centre's shift in patch radii";
  return [h("h3", {}, "Convergence"), table({ caption, columns: CONVERGENCE_COLUMNS, rows: convergence })];
}

const STARTS: Record<string, string> = {
  auto: "CN",
  geometric_potential: "GP",
  centre_line: "line of the centres",
};

const HALF_SPACE_COLUMNS: Column<HalfSpace>[] = [
  GEOMETRY as Column<HalfSpace>,
  RATIO as Column<HalfSpace>,
  { title: "Plane from", cell: ({ start }) => STARTS[start] ?? start },
  { title: "Start to end, °", figure: true, cell: ({ start_deg }) => number(start_deg) },
  { title: "Planes", hint: "How many were tried", figure: true, cell: ({ planes }) => count(planes) },
  { title: "End to CN, °", figure: true, cell: ({ cn_deg }) => number(cn_deg) },
  {
    title: "End to the force, °",
    hint: "Of the finite elements",
    figure: true,
    cell: ({ fem_deg }) => number(fem_deg),
  },
  { title: "Force", figure: true, cell: ({ force }) => number(force) },
  {
    title: "FEM's force",
    hint: "Over that of the half-spaces",
    figure: true,
    cell: ({ fem_force }) => number(fem_force),
  },
  { title: "Patch radius", figure: true, cell: ({ patch_radius }) => number(patch_radius) },
  {
    title: "FEM's patch",
    hint: "Its radius over that of the half-spaces",
    figure: true,
    cell: ({ fem_patch }) => number(fem_patch),
  },
  {
    title: "Centre off",
    hint: "To the finite elements' centre, in patch radii",
    figure: true,
    cell: ({ centre_off }) => number(centre_off, 2),
  },
  {
    title: "Bends",
    hint: "The gap's curvature a patch's radius away on the far side over that on the side to which the pressure's centre has moved",
    figure: true,
    cell: ({ bends }) => number(bends),
  },
];

const HALF_SPACE = [
  "A second reference, of another kind: two elastic half-spaces pressed together by the true gap between the bodies. Its plane is an input. So it begins with the normal of CN, with that of GP and with the line of the centres; each time the plane is turned to the pressure's force, until it stays.",
  "It shares no mesh, solver or constraint with the finite elements, only the formulas of the surfaces. FEM's force and FEM's patch are theirs over those of the half-spaces; the force hangs on what holds the bodies, of which the half-spaces know nothing, and the patch of the contact elements on mesh and penalty.",
  "Bends: how many times the gap along the common normal is as curved a patch's radius away on the far side of the contact point as on the side to which the pressure's centre has moved. Where it is far from 1 the force leaves the common normal: the centre wanders towards the flatter side, and the normals there are others.",
];

export function halfSpaceBlock(rows: HalfSpace[]): Child[] {
  if (rows.length === 0) return [];
  const caption = "Where the plane ends, from each start";
  return [
    h("h3", {}, "Elastic half-spaces"),
    ...HALF_SPACE.map((text) => h("p", { class: "note" }, text)),
    table({ caption, columns: HALF_SPACE_COLUMNS, rows: byPlace(rows) }),
  ];
}
