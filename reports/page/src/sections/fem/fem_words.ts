/** The finite elements in words. */
import type { Fem, FemAnswer, FemBody, FemGeometry, Unanswered } from "../../data";
import { inOrder } from "../../methods";
import { count, error, number } from "../../numbers";

export const methodsOf = (answers: FemAnswer[]): string[] =>
  inOrder(answers.flatMap(({ angles_deg, centre_off }) => [...Object.keys(angles_deg), ...Object.keys(centre_off)]));

export const angleTo = ({ angles_deg }: FemAnswer, method: string): number | null => angles_deg[method] ?? null;

/** Whether what is asked of this method's angle does not hold. */
export function isMarked({ cn_within, gp_beyond }: FemAnswer, method: string): boolean {
  if (method === "auto") return cn_within === false;
  return method === "geometric_potential" && gp_beyond === false;
}

/** What is asked, with how many answers hold it and of how many it is asked. */
export function askedWords({ asked: { cn, gp } }: Fem): { words: string; held: number; of: number }[] {
  const bounds = cn.map(({ above, ratio, below_deg, held, of }) => ({
    words: `At overlap ratios ${above > 0 ? `above ${number(above)} ` : ""}up to ${number(ratio)} the force is less than ${number(below_deg)}° from CN`,
    held,
    of,
  }));
  const { times, apart_deg, held, of } = gp;
  const words = `Where GP is more than ${number(apart_deg)}° from CN, or has no answer, it is more than ${number(times)} times as far from the force`;
  return [...bounds, { words, held, of }];
}

function rangeWords(method: string, answers: FemAnswer[]): string {
  const angles = answers.map((answer) => angleTo(answer, method)).filter((angle) => angle !== null);
  if (angles.length === 0) return `${method} no answer`;
  return `${method} from ${error(Math.min(...angles))}° to ${error(Math.max(...angles))}°`;
}

export function unansweredWords({ kind, geometry, ratio, varied, setting, start, reason }: Unanswered): string {
  const which = [varied, setting, start].filter((word) => word !== null).join(", ");
  const of = kind === "answer" ? "" : `, ${kind.replace("_", "-")}${which ? ` (${which})` : ""}`;
  return `${geometry} at ${number(ratio)}${of}: ${reason}`;
}

export function describeFem(answers: FemAnswer[], methods: string[]): string {
  const ranges = methods.map((method) => rangeWords(method, answers));
  return `Scatter plot, both axes logarithmic: angle between the finite elements' force and each method's normal, against the overlap ratio. ${ranges.join("; ")}.`;
}

function bodyWords({ semi_axes, exponents }: FemBody): string {
  const blocky = exponents.every((n) => n === 2) ? "" : `, exponents ${exponents.map((n) => number(n)).join(" and ")}`;
  return `${semi_axes.map((axis) => number(axis)).join(" × ")}${blocky}`;
}

export function bodiesWords({ bodies }: FemGeometry): string {
  const [first, second] = bodies.map(bodyWords);
  return first === second ? `both ${first}` : `${first}; ${second}`;
}

export const femLine = ({ geometries, answers, mode, commit }: Fem): string =>
  `finite elements: ${count(geometries.length)} geometries, ${count(answers.length)} answers, ${mode} mode, commit ${commit}`;
