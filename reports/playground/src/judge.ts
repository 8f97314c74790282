/** What is said of an answer. Held against `auto`, which gives no answer where it cannot show that its normal is the lowest. */
import type { Bounds, Contact, Method, Plumb } from "../../plumb-contact/plumb_contact.mjs";
import type { Vec } from "../../page/src/data";
import { dot, length, cross } from "../../page/src/view3d/vector";
import { number } from "../../page/src/numbers";
import { pairOf, type Setting, sizeOf } from "./pair";

/** As solver/diagnosis.hpp names what original_cn's answer lacks, and what else there is. */
export type Kind =
  "right" | "signs" | "z" | "both" | "not_opposite" | "not_lowest" | "lower" | "no_answer" | "unjudged" | "other";

export interface Judged {
  method: Method;
  contact: Contact;
  /** Degrees to auto's normal; NaN where either is missing. */
  off: number;
  kind: Kind;
  why: string;
}

/** Degrees; below them two directions look the same, and rounding is no failure. */
export const SEEN = 0.01;
/** Of the larger body. */
export const SAME_OVERLAP = 1e-6;
/** Closer points, of the larger body, have no line to speak of. */
const LINE = 1e-9;

const QUESTIONS: Record<Method["problem"], string> = {
  common_normal: "the common normal",
  deepest_points: "the deepest points",
  midway: "the point midway",
  first_touch: "the first touch",
};

export const angle = (a: Vec, b: Vec): number => (Math.atan2(length(cross(a, b)), dot(a, b)) * 180) / Math.PI;

export const isWrong = ({ kind }: Judged): boolean =>
  ["signs", "z", "both", "not_opposite", "not_lowest"].includes(kind);

/** What its points lack of a common normal; null where nothing. */
function lacking({ diagnosis, overlap }: Contact, size: number): [Kind, string] | null {
  if (!diagnosis) return null;
  const { d_n1, d_n2, n1_n2 } = diagnosis.angles_deg;
  const isLine = Math.abs(overlap) > LINE * size;
  const worst = Math.max(isLine ? Math.max(d_n1, d_n2) : 0, n1_n2);
  if (!(worst > SEEN)) return null;
  const [, , r3, r4, r5] = diagnosis.residues;
  const { fails } = diagnosis;
  const lineOff = `the line through its points is ${number(Math.max(d_n1, d_n2))}° off their normals`;
  if (n1_n2 > SEEN)
    return [
      fails === "both" ? "both" : "not_opposite",
      `the normals at its points are ${number(n1_n2)}° from opposite`,
    ];
  if (fails === "both")
    return ["both", `${lineOff}: signs are lost (R3 ${number(r3)}, R4 ${number(r4)}), and so is z (R5 ${number(r5)})`];
  if (fails === "signs")
    return ["signs", `${lineOff}: an equation has lost a sign (R3 ${number(r3)}, R4 ${number(r4)})`];
  return ["z", `${lineOff}: no equation asks for z (R5 ${number(r5)})`];
}

function judge(contact: Contact, { problem }: Method, auto: Contact, size: number): [Kind, string] {
  if (contact.status !== "converged") return ["no_answer", `no answer: ${contact.status.replace("_", " ")}`];
  if (problem !== "common_normal") return ["other", `answers another question: ${QUESTIONS[problem]}`];
  const lacks = lacking(contact, size);
  if (lacks) return lacks;
  if (auto.status !== "converged") return ["unjudged", "a common normal; auto has no answer to hold it against"];
  const excess = (contact.overlap - auto.overlap) / size;
  if (excess > SAME_OVERLAP)
    return [
      "not_lowest",
      `a common normal, but not the lowest: overlap ${number(contact.overlap, 4)}, auto has ${number(auto.overlap, 4)}`,
    ];
  if (excess < -SAME_OVERLAP) return ["lower", "a common normal of lower overlap than auto's: please report the case"];
  return ["right", contact === auto ? "shown to be the lowest" : "the common normal"];
}

/** Every method once. */
export function judgeAll(plumb: Plumb, setting: Setting): Judged[] {
  const pair = pairOf(setting);
  const contacts = plumb.methods.map(({ name }) => plumb.solve(pair, { method: name, diagnosed: true }));
  const auto = contacts[plumb.methods.findIndex(({ name }) => name === "auto")] as Contact;
  const size = sizeOf(setting);
  return plumb.methods.map((method, index) => {
    const contact = contacts[index] as Contact;
    const [kind, why] = judge(contact, method, auto, size);
    return { method, contact, off: angle(contact.normal, auto.normal), kind, why };
  });
}

/** Methods asked for the common normal whose overlap cannot be the lowest. */
export function outside(judged: Judged[], { lower, upper }: Bounds, setting: Setting): string[] {
  const slack = SAME_OVERLAP * sizeOf(setting);
  return judged
    .filter(({ method, contact }) => method.problem === "common_normal" && contact.status === "converged")
    .filter(({ contact }) => contact.overlap < lower - slack || contact.overlap > upper + slack)
    .map(({ method }) => method.name);
}

/** How far apart the centres are at first touch, by the answer of `first_touch` along their line; NaN where it has none. */
export function touchDistance(setting: Setting, judged: Judged[]): number {
  const touch = judged.find(({ method }) => method.name === "first_touch")?.contact;
  if (touch?.status !== "converged" || !(setting.distance > 0)) return Number.NaN;
  const [p, q] = touch.points;
  const way = length([q[0] - p[0], q[1] - p[1], q[2] - p[2]]);
  return setting.distance + (touch.overlap < 0 ? -way : way);
}
