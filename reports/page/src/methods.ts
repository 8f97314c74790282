/** One colour and one symbol a method, the same in every plot; colours after Okabe and Ito, darkened to 3:1 on white. */
import type { Report, Study } from "./data";
import { theme } from "./theme";

interface Look {
  light: string;
  dark: string;
  symbol: string;
}

const LOOKS: [string, Look][] = [
  ["auto", { light: "#0072b2", dark: "#56b4f5", symbol: "circle" }],
  ["new_cn", { light: "#00795a", dark: "#27c39a", symbol: "square" }],
  ["corrected_cn", { light: "#a86d00", dark: "#f0b030", symbol: "diamond" }],
  ["original_cn", { light: "#c44e00", dark: "#ff8a45", symbol: "triangle-up" }],
  ["geometric_potential", { light: "#b0508a", dark: "#e79bc8", symbol: "triangle-down" }],
  ["geometric_potential_midway", { light: "#6a51a3", dark: "#b7a1ef", symbol: "pentagon" }],
  ["minimum_distance", { light: "#5f6b14", dark: "#c3cf5a", symbol: "hexagon" }],
  ["first_touch", { light: "#9b1d3f", dark: "#ff7d93", symbol: "star-diamond" }],
  ["peer_libccd_epa", { light: "#5a5f66", dark: "#b4bac2", symbol: "x" }],
  ["peer_libccd_mpr", { light: "#7d5a2f", dark: "#cfa878", symbol: "cross" }],
  ["peer_fcl", { light: "#2f7d86", dark: "#63cad6", symbol: "star" }],
];

/** For methods that are not named above, in the order in which they come. */
const OTHERS: Look[] = [
  { light: "#8a4a8f", dark: "#d79fdb", symbol: "triangle-left" },
  { light: "#4a6b4f", dark: "#9cc7a2", symbol: "triangle-right" },
  { light: "#8a3b3b", dark: "#ea9a94", symbol: "hourglass" },
  { light: "#3b5b8a", dark: "#94b4ea", symbol: "bowtie" },
];

const looks = new Map(LOOKS);
const order: string[] = LOOKS.map(([name]) => name);
const own = new Set<string>();

function meet(method: string): void {
  if (looks.has(method)) return;
  const other = OTHERS[(order.length - LOOKS.length) % OTHERS.length] as Look;
  looks.set(method, other);
  order.push(method);
}

function studyMethods(study: Study): string[] {
  const { groups, maps, shares, limits, orders, costs } = study;
  const named = [...groups.flatMap(({ answers }) => answers), ...maps, ...shares, ...costs];
  return [...named.map(({ method }) => method), ...[...limits, ...orders].map(({ system }) => system)];
}

export function meetMethods(report: Report): void {
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
  own.add("auto");
}

function look(method: string): Look {
  meet(method);
  return looks.get(method) as Look;
}

export const colourOf = (method: string): string => look(method)[theme.value];
/** The same for a style sheet, which knows the theme itself. */
export const cssColourOf = (method: string): string => `light-dark(${look(method).light}, ${look(method).dark})`;
export const symbolOf = (method: string): string => look(method).symbol;
export const isOwn = (method: string): boolean => own.has(method);
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
