/**
 * The document that `plumb report` puts into the page and beside it (FILE.json): its one description. Written by reports/
 * (campaign/), read by this page. Lengths in the case's unit, angles as named; a figure that is not known is null.
 */
import type { Fem } from "./data_fem";

export interface Report {
  format: "plumb/report-1";
  /** What made the page. */
  made: { commit: string; compiler: string; flags: string; command: string };
  /** In the order of the command line; the page begins with the last. Empty where only scenes, a study or finite elements were given. */
  runs: Run[];
  /** The first run against each of the others. */
  comparisons: Comparison[];
  precision: Precision | null;
  stability: Stability | null;
  study: Study | null;
  fem: Fem | null;
  /** Scenes, in the order of the command line. */
  playbacks: Playback[];
  /** The contract's words with what each means, in order of precedence; "none" last. */
  findings: { word: string; meaning: string }[];
  laws: { name: string; statement: string; file: string; line: number }[];
  /** plumb's list; published_by is empty for its own. Colours on a light page and on a dark one; Plotly's name of the symbol. */
  methods: { name: string; published_by: string; light: string; dark: string; symbol: string }[];
}

/** k of n with the exact (Clopper-Pearson) 95 % interval; share is null where n is 0. */
export interface Share { count: number; of: number; share: number | null; low: number; high: number }

/** Percentiles are upper edges of bins, 20 a decade; "max" is exact; null where nothing was counted. */
export type Spread = { p50: number | null; p99: number | null; max: number | null } | null;

export interface Run {
  name: string;
  folder: string;
  commit: string;
  /** A whole number of 64 bits. */
  seed: string;
  cases: number;
  /** Interrupted, or shards are missing. */
  incomplete: boolean;
  /** One a family: repeats it. */
  commands: string[];
  host: { system: string; machine: string; processors: number; compiler: string; flags: string };
  /** Message -> how often. */
  harness_errors: Record<string, number>;
  timing: { seconds: number; threads: number; cases_per_second: number };
  families: Family[];
  atlases: Atlas[];
  /** Of the family hard; empty where it was not asked for. */
  ladders: Ladder[];
  /** In the run's folder; `failures` may hold fewer. */
  kept_failures: number;
  failures: Failure[];
}

export interface Family {
  name: string;
  cases: number;
  command: string;
  reference: { unsolved: number; not_proved_lowest: number; beaten: number; needed: Record<string, number> };
  methods: MethodRow[];
}

export interface MethodRow {
  method: string;
  /** A baseline: its findings are results, not defects of plumb. */
  published: boolean;
  answers: number;
  judged: number;
  unjudged: number;
  converged: Share;
  /** By the contract's words; "none" is right. Of the judged. */
  findings: Record<string, Share>;
  /** Answers that break a law, of the judged. */
  failures: Share;
  /** Of the judged, right at each level of accuracy, the finest first: rounding, 1e-6rad, 0.01deg, 1deg. */
  right: Record<string, Share>;
  /** Pairs that the method claims no answer to; not among the answers. */
  not_asked: number;
  /** Converged answers more than 0.01 degrees from the common normal. */
  angle_above: Share;
  angle_error_deg: Spread;
  overlap_error: Spread;
  iterations: Spread;
  evaluations: Spread;
  /** One solve, first call; not reproducible. */
  ns_per_solve: Spread;
}

/** Where a method fails, over two properties of a pair. */
export interface Atlas {
  family: string;
  method: string;
  map: "aspect-overlap" | "exponent-tilt";
  x: Axis;
  y: Axis;
  /** Only cells that hold answers. */
  cells: Cell[];
}
/** The i-th cell of an axis is labels[i]; "x in [2, 3)". */
export interface Axis { title: string; labels: string[] }
export interface Cell {
  x: number;
  y: number;
  answers: number;
  judged: number;
  failures: number;
  not_converged: number;
  /** Mean of all answers. */
  iterations: number | null;
}

/** A generator of the family hard: what it steers, from easy to the last representable value. */
export interface Ladder {
  name: string;
  knob: string;
  /** The easiest first. */
  steps: number[];
  methods: LadderRow[];
}
/** A number for each step. */
export interface LadderRow {
  method: string;
  published: boolean;
  answers: number[];
  judged: number[];
  /** By their status, of all answers. */
  not_converged: number[];
  /** Findings, of the judged: nonconverged, and all others. */
  lost: number[];
  wrong: number[];
  /** By the contract's words, those that occur; without "none". */
  findings: Record<string, number[]>;
  /** The easiest step with a finding, from 1. */
  lets_go: number | null;
}

export type Vec = [number, number, number];
export interface Body {
  shape: { superellipsoid: { semi_axes: Vec; exponents?: [number, number] } };
  position: Vec;
  orientation: { quaternion_wxyz: [number, number, number, number] };
}

/** One kept case of a bucket. */
export interface Failure {
  bucket: string;
  /** "only": the simplest is the worst. */
  kept: "simplest" | "worst" | "only";
  /** Failures in the bucket. */
  count: number;
  finding: string;
  method: string;
  shapes: string;
  regime: string;
  family: string;
  /** Of plumb's own method, a foreign solver or the reference: a defect, and not a result. */
  own: boolean;
  /** Error over what the condition number allows; "infinite" where it is no number. */
  severity: number | "infinite";
  law: string;
  detail: string;
  file: string;
  replay: string;
  case: { format: string; name?: string; bodies: [Body, Body]; [field: string]: unknown };
  /** Solved anew by the report; null with a reason in its place where that was not possible. */
  answer: Answer | null;
  reference: Answer | null;
  reason?: string;
}
export interface Answer {
  status: string;
  verdict: string;
  overlap: number | null;
  normal: Vec | null;
  points: [Vec, Vec] | null;
  /** Outward unit normals of the two surfaces at the points. */
  normals: [Vec, Vec] | null;
  iterations: number | null;
  /** Of `answer`: to the reference's normal. */
  angle_error_deg: number | null;
}

export interface Comparison {
  before: string;
  after: string;
  /** The same cases: no difference is chance. */
  same_cases: boolean;
  rows: ComparisonRow[];
}
export interface ComparisonRow {
  family: string;
  method: string;
  /** "misaligned", "converged", "angle_error_deg p99", "iterations p50", ... */
  measure: string;
  unit: "share" | "deg" | "relative" | "count";
  before: number | null;
  after: number | null;
  before_interval?: [number, number];
  after_interval?: [number, number];
  /** Two-sided, adjusted for the number of rows that differ (Holm); null where the cases are the same. */
  p: number | null;
  verdict: "better" | "worse" | "same" | "noise";
}

/** From `plumb report-precision`. */
export interface Precision {
  commit: string;
  host: { system: string; machine: string; compiler: string; flags: string } | null;
  command: string;
  /** Sets that Ctrl-C left out. */
  without: string[];
  sets: PrecisionSet[];
}
export interface PrecisionSet {
  name: string;
  of: string;
  pairs: number;
  /** The least error of the normal (rad), of the overlap and of the points (relative to the size) that the condition numbers allow, by scalar. */
  envelopes: { scalar: string; normal: Quantiles; overlap: Quantiles; points: Quantiles }[];
  points: PrecisionPoint[];
  /** Error against iterations, of methods that iterate. */
  paths: { method: string; scalar: string; command: string; steps: { iterations: number; normal: Quantiles; overlap: Quantiles }[] }[];
  /** Whether `auto` is on the front, in words; what beats it where it is not. */
  auto_on_front: boolean;
  front_note: string;
}
export interface Quantiles { median: number | null; p99: number | null; max: number | null }
export interface PrecisionPoint {
  method: string;
  scalar: string;
  /** 0: all that rounding allows. */
  tolerance: number;
  /** "" or residual, bounds, proof, digits: what is asked for beside the answer. */
  certificate: string;
  problem: string;
  command: string;
  median_ns: number;
  p99_ns: number;
  iterations: { median: number; max: number };
  /** Shares, 0..1. */
  failed: number;
  off: number | null;
  judged: number;
  overlap: Quantiles;
  /** rad */
  normal: Quantiles;
  points: Quantiles;
  pareto: boolean;
}

/** From `plumb report-stability`. */
export interface Stability {
  commit: string;
  host: { system: string; machine: string; compiler: string; flags: string } | null;
  command: string;
  interrupted: boolean;
  ladders: { name: string; knob: string; steps: number[]; rows: StabilityRow[] }[];
  /** Over all ladders, by method and arithmetic. */
  totals: { method: string; arithmetic: string; cases: number; right: number; lost: number; wrong: number }[];
}
/** A number for each step, of one method in one arithmetic. */
export interface StabilityRow {
  method: string;
  /** "double", "float", "up", "g++ -O0", ... */
  arithmetic: string;
  cases: number[];
  right: number[];
  lost: number[];
  wrong: number[];
  /** The fewest significant digits of all answers given; null where there are none. */
  digits: { overlap: number | null; normal: number | null; points: number | null };
  /** From 1. */
  lets_go: number | null;
}

/**
 * From `plumb report-study`: ways to define and to find a contact between two bodies, after Kildashti, Dong and Samali (2018). Angles
 * in degrees; `off_deg`, of a contact normal, is to the common normal that the reference found.
 */
export interface Study {
  commit: string;
  host: { system: string; machine: string; compiler: string; flags: string } | null;
  command: string;
  interrupted: boolean;
  groups: StudyGroup[];
  maps: StudyMap[];
  shares: StudyShare[];
  limits: StudyLimit[];
  orders: StudyOrder[];
  costs: StudyCost[];
  roots: StudyRoots[];
}
/** Two bodies on one line, at several overlap ratios. */
export interface StudyGroup {
  group: string;
  shape: string;
  /** What the answer of the original equations misses at this pair. */
  fails: "signs" | "z" | "both" | "nothing";
  aspect: number;
  exponents: [number, number];
  /** Of the line on which body 2 lies: zenith and azimuth. */
  theta_L_deg: number;
  phi_L_deg: number;
  /** Of body 2: phi, theta, psi. */
  euler_deg: Vec;
  /** How many pairs were drawn until this one. */
  drawn: number;
  answers: StudyAnswer[];
}
export interface StudyAnswer {
  ratio: number;
  method: string;
  status: string;
  points: [Vec, Vec] | null;
  /** R1 to R5 of the source. */
  residues: [number, number, number, number, number] | null;
  /** d and n1, d and n2, n1 and n2; 0 for a common normal. */
  angles_deg: Vec | null;
  off_deg: number | null;
  /** The normal that `off_deg` is to is proved. */
  certified: boolean;
}
/** off_deg over two angles of the pair. */
export interface StudyMap {
  aspect: number;
  phi_deg: number;
  ratio: number;
  method: string;
  /** Ascending. */
  theta_L_deg: number[];
  theta_deg: number[];
  /** Rows by theta_L, columns by theta; null: no answer. */
  off_deg: (number | null)[][];
  not_certified: number;
}
/** Of random pairs, how many answers are more than 0.01 degrees off; low and high: the share's 95 % interval. */
export interface StudyShare {
  aspect: number;
  ratio: number;
  method: string;
  pairs: number;
  answers: number;
  off: number;
  low: number;
  high: number;
  median_deg: number | null;
}
/** How far another definition of the contact is from the common normal's, as one thing of the pair changes. */
export interface StudyLimit {
  sweep: "ratio" | "aspect" | "exponent";
  shape: string;
  x: number;
  system: string;
  pairs: number;
  certified: number;
  /** Medians; point in units of the size, overlap relative. */
  angle_deg: number | null;
  angle_max_deg: number | null;
  point: number | null;
  overlap: number | null;
}
/** The power of the overlap ratio with which each difference vanishes. */
export interface StudyOrder {
  shape: string;
  system: string;
  angle: number | null;
  point: number | null;
  overlap: number | null;
  /** The angle at the least ratio. */
  limit_deg: number | null;
}
/** The cheapest tolerance at which a method's answers are that near to the solution of its own problem; `share`: of the pairs that are. */
export interface StudyCost {
  set: string;
  method: string;
  target_deg: number;
  tolerance: number | null;
  evaluations: number | null;
  share: number;
}
/** All real solutions of the six published equations at one pair, and which of them random starts end at. */
export interface StudyRoots {
  pair: string;
  /** All were found; else `reason` says why that is not known. */
  complete: boolean;
  reason: string;
  starts: number;
  not_converged: number;
  elsewhere: number;
  roots: StudyRoot[];
}
export interface StudyRoot {
  /** What it misses of a common normal; "apart": of the bodies as if they were apart. */
  kind: "signs" | "z" | "both" | "common normal" | "common normal, apart";
  normal: Vec | null;
  distance: number | null;
  /** R3 to R5. */
  residues: Vec | null;
  off_deg: number | null;
  starts: number;
  /** The method's own start ends here. */
  documented: boolean;
}

/**
 * From `plumb scene --out DIR`: DIR/playback.jsonl. What is packed is base64 of little-endian numbers, frame by frame; lengths in it
 * are from `origin`, in units of `size`.
 */
export interface Playback {
  name: string;
  folder: string;
  scene: string;
  time_step: number;
  accuracy: number;
  effects: { name: string; on: boolean; why: string }[];
  shapes: { semi_axes: Vec; exponents: [number, number] }[];
  /** Of each body, the index of its shape. */
  bodies: number[];
  /** Indices of bodies that do not move. */
  fixed: number[];
  /** Unit normals. */
  walls: Vec[];
  origin: Vec;
  /** The largest semi-axis. */
  size: number;
  /** Of each frame; they do not decrease. */
  times: number[];
  /** float32, three a body. */
  positions: string;
  /** int16 of 32767ths, four a body: w, x, y, z, of length 1. */
  orientations: string;
  /** float32, three a wall: a point of its plane. */
  wall_points: string;
  contacts: PackedContacts;
  /** By kind, a number for each frame. */
  energy: Record<string, (number | null)[]>;
  /** null: the run did not reach its end. */
  end: PlaybackEnd | null;
}
export interface PackedContacts {
  /** For each frame, how many; and their deepest overlap, in the scene's unit. */
  counts: number[];
  deepest: (number | null)[];
  largest_force: number;
  /** float32, six a frame: the least corner of a box around the frame's points, and its sides. */
  boxes: string;
  /** uint16, or uint32 of more than 65536 bodies and walls, two a contact: i < j; from the number of bodies on, walls. */
  pairs: string;
  /** uint16, three a contact: 65535ths of the box. */
  points: string;
  /** int16 of 32767ths, three a contact: from i to j. */
  normals: string;
  /** int16, one a contact: 32767ths of `largest_force`. */
  forces: string;
}
export interface PlaybackEnd {
  steps: number;
  time: number;
  hash: string;
  solves: number;
  failed: number;
  /** Of the time that the run took, by part. */
  shares: Record<string, number>;
}
