/** The source's study in words. */
import type { Study, StudyAnswer, StudyGroup, StudyLimit, StudyMap } from "../../data";
import { type Child, h } from "../../dom";
import { count, error, NONE, number } from "../../numbers";

/** A normal further than this from the common one is off: the harness's own limit, in degrees. */
const OFF_DEG = 0.01;
/** A residue is about the sine of an angle. */
const OFF_RESIDUE = Math.sin((OFF_DEG * Math.PI) / 180);

export const isOff = (deg: number | null): boolean => deg !== null && deg > OFF_DEG;

/** Not by its colour alone. */
export function marked(text: string, fails: boolean): Child {
  if (!fails) return text;
  const sign = h("span", { "aria-hidden": "true" }, "✗ ");
  return h("span", { class: "flag wrong figure" }, sign, h("span", { class: "unseen" }, "fails: "), text);
}

export const residueCell = (residue: number | null | undefined): Child =>
  residue === null || residue === undefined ? NONE : marked(number(residue, 2), Math.abs(residue) > OFF_RESIDUE);

export const angleCell = (deg: number | null | undefined): Child =>
  deg === null || deg === undefined ? NONE : marked(number(deg), isOff(deg));

export const largestAngle = ({ angles_deg }: StudyAnswer): number | null =>
  angles_deg === null ? null : Math.max(...angles_deg);

const FAILS: Record<string, string> = {
  signs: "the signs fail",
  z: "the z component fails",
  both: "signs and z component fail",
  nothing: "nothing fails",
};
export const failsWords = ({ fails }: StudyGroup): string => FAILS[fails] ?? fails;

export const shapeWords = ({ shape, aspect, exponents }: StudyGroup): string =>
  `${shape}, aspect ${number(aspect)}${exponents.every((n) => n === 2) ? "" : `, exponents ${exponents.map((n) => number(n)).join(" and ")}`}`;

export function groupWords(group: StudyGroup): string {
  const { answers } = group;
  const off = answers.filter(({ off_deg }) => isOff(off_deg)).length;
  const none = answers.filter(({ off_deg }) => off_deg === null).length;
  const without = none > 0 ? `, ${count(none)} none` : "";
  return `${group.group}: ${shapeWords(group)}; ${failsWords(group)}; ${count(off)} of ${count(answers.length)} answers more than ${OFF_DEG}° off${without}`;
}

export function describeAngles(group: StudyGroup, answers: StudyAnswer[]): string {
  const methods = [...new Set(answers.map(({ method }) => method))];
  const reached = methods.map((method) => {
    const angles = answers.filter((answer) => answer.method === method).map(largestAngle);
    const known = angles.filter((angle) => angle !== null);
    return known.length > 0 ? `${method} at most ${error(Math.max(...known))}°` : `${method} no answer`;
  });
  return `Line plot, both axes logarithmic: the largest of the three angles against the overlap ratio, ${group.group}. ${reached.join("; ")}.`;
}

export const offsOf = ({ off_deg }: StudyMap): number[] => off_deg.flat().filter((deg) => deg !== null);

export function mapWords(map: StudyMap): string {
  const offs = offsOf(map);
  const cells = map.off_deg.flat().length;
  const most = offs.length > 0 ? `, at most ${number(Math.max(...offs))}°` : "";
  const none = cells > offs.length ? `; ${count(cells - offs.length)} without an answer` : "";
  const unproved = map.not_certified > 0 ? `; ${count(map.not_certified)} normals not proved` : "";
  return `${count(offs.filter(isOff).length)} of ${count(cells)} cells more than ${OFF_DEG}° off${most}${none}${unproved}`;
}

export const describeMap = (map: StudyMap): string =>
  `Heat map, logarithmic colours: angle between the normal of ${map.method} and the common one, over theta and theta_L. ${mapWords(map)}.`;

export type Quantity = "angle_deg" | "point" | "overlap";
export const QUANTITIES: [Quantity, string][] = [
  ["angle_deg", "angle to the common normal, degrees"],
  ["point", "distance of the contact points over the size"],
  ["overlap", "difference of the overlap, relative"],
];
export const quantityName = (quantity: Quantity): string =>
  QUANTITIES.find(([name]) => name === quantity)?.[1] ?? quantity;

const SWEEPS: Record<string, string> = { ratio: "overlap ratio", aspect: "aspect", exponent: "exponent" };
export const sweepName = (sweep: string): string => SWEEPS[sweep] ?? sweep;

export function describeLimits(rows: StudyLimit[], quantity: Quantity): string {
  const first = rows[0];
  const systems = [...new Set(rows.map(({ system }) => system))];
  const ends = systems.map((system) => {
    const least = rows.filter((row) => row.system === system).sort((a, b) => a.x - b.x)[0];
    return least ? `${system} ${error(least[quantity])} at ${number(least.x)}` : system;
  });
  return `Line plot, both axes logarithmic: median ${quantityName(quantity)}, against ${sweepName(first?.sweep ?? "")}, ${first?.shape ?? ""}. At the least: ${ends.join("; ")}.`;
}

const KINDS: Record<string, string> = { signs: "wrong signs", z: "wrong z component", both: "wrong signs and z" };
export const kindWords = (kind: string): string => KINDS[kind] ?? kind;

/** What the head says of it. */
export const studyLine = ({ groups, commit }: Study): string =>
  `study: ${groups.length > 0 ? `${count(groups.length)} groups of pairs, ` : ""}commit ${commit}`;
