/**
 * Contacts of two superellipsoids by plumb's methods, in WebAssembly.
 *
 * World frame throughout; a body's quaternion takes body axes to world axes. Lengths in your own unit.
 * overlap > 0: the bodies penetrate by that length; < 0: they are -overlap apart. The normal points from body 1 to body 2.
 */
export type Vec3 = [number, number, number];

/** (|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1 = 1 in body axes. */
export interface Body {
  semi_axes: Vec3;
  /** n1, n2, both above 1; absent: 2, 2, an ellipsoid. */
  exponents?: [number, number];
  /** Absent: the origin. */
  position?: Vec3;
  /** w, x, y, z, of any length but 0; absent: not turned. */
  quaternion?: [number, number, number, number];
}

export interface Pair {
  bodies: [Body, Body];
  /** Velocity of body 2 relative to body 1, for `first_touch`; absent: the line of centres. */
  motion?: Vec3;
}

export type Status = "converged" | "iteration_limit" | "stalled" | "singular" | "not_finite" | "invalid_input";
export type Verdict = "undecided" | "overlapping" | "separated";
export type Problem = "common_normal" | "deepest_points" | "midway" | "first_touch";

/** What the points say of themselves; degrees are 0 for a true common normal. */
export interface Diagnosis {
  /** R1..R5 as published (Lin & Ng, Eqs. 5, 6; Kildashti et al. 2018, Eqs. 7-9). */
  residues: [number, number, number, number, number];
  /** Between the line through the points and the normal of each surface there, and between the two normals; degrees. */
  angles_deg: { d_n1: number; d_n2: number; n1_n2: number };
  /** Outward, at the points. */
  normals: [Vec3, Vec3];
  /** What Lin & Ng's equations have missed: a sign (R3, R4), z (R5, or the normals' z), both, or nothing; each beyond 1e-6. */
  fails: "signs" | "z" | "both" | "nothing";
}

/** The lowest overlap of all directions lies between the two, by interval arithmetic. */
export interface Bounds {
  lower: number;
  upper: number;
}

/** Its numbers are an answer with the status "converged" alone; otherwise they are NaN. */
export interface Contact {
  method: string;
  status: Status;
  verdict: Verdict;
  overlap: number;
  normal: Vec3;
  points: [Vec3, Vec3];
  contact_point: Vec3;
  iterations: number;
  evaluations: number;
  /** With `diagnosed`, of a converged answer. */
  diagnosis?: Diagnosis;
}

export interface Method {
  name: string;
  problem: Problem;
  /** Authors and year; empty: plumb's own. */
  published_by: string;
  summary: string;
  light: string;
  dark: string;
  symbol: string;
}

export interface Options {
  /** Default: "auto". */
  method?: string;
  /** Also what the points say of themselves. Default: false. */
  diagnosed?: boolean;
  /** Of each local solve. Default: 100. */
  iteration_limit?: number;
  /** Residual, relative to the pair's size, at which a method may stop; 0: all that rounding allows. */
  tolerance?: number;
}

export interface Plumb {
  /** All methods, in plumb's order. */
  methods: Method[];
  /** Throws RangeError where there is no such method or an option is out of its range. An illegal pair is an answer: "invalid_input". */
  solve(pair: Pair, options?: Options): Contact;
  /**
   * Bounds of the pair's lowest overlap. The upper one is the overlap along the contact's normal: an answer that is higher is not the
   * lowest. At most `cells` of directions are looked at, 1 to 10 000; default 2000, about a millisecond. Throws RangeError where the
   * pair is illegal or the contact did not converge.
   */
  bounds(pair: Pair, contact: Contact, options?: { cells?: number }): Bounds;
  /** "bodies[1].shape.superellipsoid.semi_axes[0]: must be finite and above 0"; empty where the pair is legal. */
  describeInput(pair: Pair): string;
}

/** Compiles the module, once. It asks for no file and no network. */
export function load(): Promise<Plumb>;
