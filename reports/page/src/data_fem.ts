/** The part `fem` of the document (data.ts): what `reports/fem/run` left. Written by reports/document/fem.cpp. */
import type { Vec } from "./data";

/**
 * Two bodies meshed and pressed together by CalculiX, at several overlap ratios: the direction of the force against each method's normal.
 * Angles in degrees; lengths in the geometry's unit, but for those in patch radii, which are FemAnswer's `patch_radius`.
 */
export interface Fem {
  commit: string;
  /** Versions: ccx, gmsh and others. */
  host: Record<string, string>;
  command: string;
  interrupted: boolean;
  mode: "quick" | "full";
  young: number;
  poisson: number;
  /** The constraint, in words. */
  held: string;
  /** What the run line's limits ask of the angles, and of how many answers it holds. CN is the method auto, GP geometric_potential. */
  asked: { cn: FemBound[]; gp: { times: number; apart_deg: number } & Counted };
  geometries: FemGeometry[];
  checks: FemCheck[];
  convergence: FemConvergence[];
  answers: FemAnswer[];
  half_space: HalfSpace[];
  /** Lines with a reason in the place of their figures. */
  unanswered: Unanswered[];
}
interface Counted {
  held: number;
  of: number;
}
/** Of overlap ratios above `above`, up to `ratio`. */
export interface FemBound extends Counted {
  above: number;
  ratio: number;
  below_deg: number;
}
export interface Unanswered {
  kind: "answer" | "convergence" | "half_space";
  geometry: string;
  ratio: number;
  varied: string | null;
  setting: string | null;
  start: string | null;
  reason: string;
}
export interface FemGeometry {
  name: string;
  /** An ellipsoid has three different semi-axes. */
  shape: "spheroid" | "ellipsoid" | "superquadric";
  bodies: [FemBody, FemBody];
  /** Of the line on which body 2 lies: zenith and azimuth. */
  line_deg: [number, number];
  /** Of body 2: w, x, y, z. */
  quaternion: [number, number, number, number];
}
export interface FemBody {
  semi_axes: Vec;
  exponents: [number, number];
}
export interface FemCheck {
  check: string;
  value: number;
  limit: number;
  unit: string;
  /** The value is not above the limit. */
  within: boolean;
}
/** One answer with one setting changed, against that with the study's own. */
export interface FemConvergence {
  geometry: string;
  ratio: number;
  varied: string;
  setting: string;
  turned_deg: number;
  /** Relative. */
  force_change: number;
  /** Of the contact elements' radius; relative. */
  patch_change: number;
  /** In patch radii. */
  centre_shift: number;
}
export interface FemAnswer {
  geometry: string;
  ratio: number;
  force: number;
  direction: Vec;
  /** From the force to the method's normal; null: no answer. */
  angles_deg: Record<string, number | null>;
  cn_to_gp_deg: number | null;
  /** From the pressure's centre to the method's contact point, in patch radii. */
  centre_off: Record<string, number | null>;
  /** Nominal: of a circle of half the area in which the undeformed bodies overlap, seen along the common normal (Hertz's patch). */
  patch_radius: number;
  /** Of a circle as large as the contact elements under pressure. */
  fem_patch_radius: number;
  /** The sum of the forces on the two bodies over one of them. */
  balance: number;
  nodes: number;
  iterations: number;
  /** CN is as near as `asked`; null where nothing is asked. */
  cn_within: boolean | null;
  /** GP is as much further off as `asked`, which it is not without an answer; null where the two are too near to each other. */
  gp_beyond: boolean | null;
}
/** Elastic half-spaces pressed together by the true gap, the plane turned until it is normal to the force. */
export interface HalfSpace {
  geometry: string;
  ratio: number;
  start: "auto" | "geometric_potential" | "centre_line";
  /** From the first plane's normal to the last's. */
  start_deg: number;
  /** How many planes were tried. */
  planes: number;
  /** From the last to CN, and to the finite elements' force. */
  cn_deg: number;
  fem_deg: number | null;
  force: number;
  patch_radius: number;
  /** The finite elements' force and patch radius over these. */
  fem_force: number | null;
  fem_patch: number | null;
  /** To the finite elements' centre, in patch radii. */
  centre_off: number | null;
  /** Of the gap along the common normal, a patch's radius on the far side, at the point, on the side to which the pressure's centre has moved. */
  curvatures: Vec | null;
  /** The first of them over the last. */
  bends: number | null;
}
