/** One colour and one symbol a method, the same in every plot. Those of plumb's own stand in solver/method/method_rows.inc. */
import type { Report, Study } from "./data";
import { theme } from "./theme";

type Look = Pick<Report["methods"][number], "light" | "dark" | "symbol">;

/** Of foreign solvers that are often there. plumb's own methods bring their looks in the document. */
const PEERS: [string, Look][] = [
  ["peer_libccd_epa", { light: "#5a5f66", dark: "#b4bac2", symbol: "x" }],
  ["peer_libccd_mpr", { light: "#7d5a2f", dark: "#cfa878", symbol: "cross" }],
  ["peer_fcl", { light: "#2f7d86", dark: "#63cad6", symbol: "star" }],
];

/** For other foreign solvers, in the order in which they come. */
const OTHERS: Look[] = [
  { light: "#8a4a8f", dark: "#d79fdb", symbol: "triangle-left" },
  { light: "#4a6b4f", dark: "#9cc7a2", symbol: "triangle-right" },
  { light: "#8a3b3b", dark: "#ea9a94", symbol: "hourglass" },
  { light: "#3b5b8a", dark: "#94b4ea", symbol: "bowtie" },
];

const looks = new Map<string, Look>();
const order: string[] = [];
const own = new Set<string>();
const ofOtherProblems = new Set<string>();
let others = 0;

function add(method: string, look: Look): void {
  looks.set(method, look);
  order.push(method);
}

function meet(method: string): void {
  if (!looks.has(method)) add(method, OTHERS[others++ % OTHERS.length] as Look);
}

function studyMethods(study: Study): string[] {
  const { groups, maps, shares, limits, orders, costs } = study;
  const named = [...groups.flatMap(({ answers }) => answers), ...maps, ...shares, ...costs];
  return [...named.map(({ method }) => method), ...[...limits, ...orders].map(({ system }) => system)];
}

export function meetMethods(report: Report): void {
  for (const { name, published_by, problem, light, dark, symbol } of report.methods) {
    add(name, { light, dark, symbol });
    if (!published_by) own.add(name);
    if (problem !== "common_normal") ofOtherProblems.add(name);
  }
  for (const [peer, look] of PEERS) add(peer, look);
  for (const run of report.runs)
    for (const family of run.families)
      for (const row of family.methods) {
        meet(row.method);
        if (!row.published) own.add(row.method);
      }
  for (const ladder of report.stability?.ladders ?? []) for (const row of ladder.rows) meet(row.method);
  for (const set of report.precision?.sets ?? []) for (const point of set.points) meet(point.method);
  if (report.study) studyMethods(report.study).forEach(meet);
  for (const { angles_deg, centre_off } of report.fem?.answers ?? [])
    [...Object.keys(angles_deg), ...Object.keys(centre_off)].forEach(meet);
  for (const comparison of report.comparisons) for (const row of comparison.rows) meet(row.method);
}

function look(method: string): Look {
  meet(method);
  return looks.get(method) as Look;
}

export const colourOf = (method: string): string => look(method)[theme.value];
/** The same for a style sheet, which knows the theme itself. */
export const cssColourOf = (method: string): string => `light-dark(${look(method).light}, ${look(method).dark})`;
export const symbolOf = (method: string): string => look(method).symbol;
const FOREIGN = "solver:";
/** Brought along (--solver); it goes by the name that it gives itself. */
export const isForeign = (method: string): boolean => method.startsWith(FOREIGN);
export const plainName = (method: string): string => (isForeign(method) ? method.slice(FOREIGN.length) : method);
export const isOwn = (method: string): boolean => own.has(method);
/** It is asked for another normal than the common one, so that far from that is not wrong yet. */
export const hasOtherProblem = (method: string): boolean => ofOtherProblems.has(method);
export const inOrder = (methods: string[]): string[] =>
  [...new Set(methods)].sort((a, b) => order.indexOf(a) - order.indexOf(b));

const SCALARS = ["float", "double", "long double"];
const rankOf = (scalar: string): number => (SCALARS.includes(scalar) ? SCALARS.indexOf(scalar) : SCALARS.length);
/** From the coarsest; what is not known, after the others. */
export const scalarsInOrder = (scalars: string[]): string[] =>
  [...new Set(scalars)].sort((a, b) => rankOf(a) - rankOf(b));

export const DASHES: Record<string, string> = { double: "solid", "long double": "dash", float: "dot" };
export const dashOf = (scalar: string): string => DASHES[scalar] ?? "dashdot";
/** Filled for double, open for the others. */
export const symbolIn = (method: string, scalar: string): string =>
  scalar === "double" ? symbolOf(method) : `${symbolOf(method)}-open`;
