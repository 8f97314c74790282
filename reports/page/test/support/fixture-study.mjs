// Made-up lines of plumb report-study, and the document that plumb report makes of them.
import { makeReport, stream } from "./fixture.mjs";

const METHODS = [
  "original_cn",
  "corrected_cn",
  "new_cn",
  "minimum_distance",
  "geometric_potential",
  "geometric_potential_midway",
  "first_touch",
  "auto",
];
const SYSTEMS = METHODS.slice(4, 7);
const RATIOS = [1e-4, 1e-3, 1e-2, 2e-2, 5e-2];
const FAILS = ["signs", "z", "both", "nothing"];
const EXACT = ["new_cn", "minimum_distance", "auto"];

const RUN = {
  kind: "run",
  command: "plumb report-study --out study.jsonl",
  host: { system: "Linux", machine: "x86_64", compiler: "g++ 12.2.0", flags: "-O2", commit: "24cec56" },
};

/** How far a method's normal is from the common one, in degrees. */
function offOf(random, method, ratio, fails) {
  if (EXACT.includes(method)) return random() < 0.3 ? 0 : 1e-13 * random();
  if (method === "original_cn") return fails === "nothing" ? 1e-12 : 20 + 140 * random();
  if (method === "corrected_cn") return fails === "z" || fails === "both" ? 15 + 30 * random() : 2e-13;
  if (method === "geometric_potential") return 11 + 20 * random() + 100 * ratio;
  return 12 * ratio * (0.5 + random());
}

function answer(random, group, fails, method, ratio) {
  const head = { kind: "answer", group, ratio, method };
  const lost = method === "corrected_cn" && fails === "both" && ratio > 0.03;
  if (lost)
    return {
      ...head,
      status: "no_convergence",
      points: null,
      residues: null,
      angles_deg: null,
      off_deg: null,
      certified: true,
    };
  const off = offOf(random, method, ratio, fails);
  const residue = () => (off < 1e-6 ? 1e-16 * random() : (off / 60) * (random() - 0.3));
  const points = [
    [0.4 + random(), 0.1, 0.3],
    [0.4 + random(), 0.1, 0.3 - ratio],
  ];
  return {
    ...head,
    status: "converged",
    points,
    residues: [1e-16, 0, residue(), residue(), residue()],
    angles_deg: [off * 0.8, off * 0.7, off],
    off_deg: off,
    certified: ratio < 0.04 || fails !== "both",
  };
}

function groups(random) {
  return ["G1", "G2", "G3", "G4", "S1", "S2", "S3", "S4"].flatMap((group, index) => {
    const isSpheroid = group.startsWith("G");
    const fails = FAILS[index % 4];
    const head = {
      kind: "group",
      group,
      shape: isSpheroid ? "spheroid" : "superquadric",
      fails,
      aspect: 2.5,
      exponents: isSpheroid ? [2, 2] : [4, 6],
      theta_L_deg: 35 + 5 * index,
      phi_L_deg: 0,
      euler_deg: [10 * index, 70, 0],
      drawn: 12 + index,
    };
    return [head, ...METHODS.flatMap((method) => RATIOS.map((ratio) => answer(random, group, fails, method, ratio)))];
  });
}

const steps = (most, by) => Array.from({ length: most / by + 1 }, (_, i) => by * i);

function map(random, method, aspect, ratio) {
  const [theta_L_deg, theta_deg] = [steps(90, 15), steps(180, 15)];
  const cell = (row, column) => {
    if (method === "first_touch" && random() < 0.1) return null;
    const isPlain = row === 0 || column === 0;
    return offOf(random, method, ratio, isPlain ? "nothing" : "both") * Math.sin((column + 1) / 5);
  };
  const off_deg = theta_L_deg.map((_, row) =>
    theta_deg.map((_, column) => cell(row, column)).map((x) => x && Math.abs(x)),
  );
  return {
    kind: "map",
    aspect,
    phi_deg: 45,
    ratio,
    method,
    theta_L_deg,
    theta_deg,
    off_deg,
    not_certified: ratio > 0.01 ? 3 : 0,
  };
}

function share(random, method, aspect, ratio) {
  const answers = 1000 - Math.floor(20 * random());
  const wrong = EXACT.includes(method) ? 0 : Math.floor(answers * random());
  const [low, high] = [Math.max(0, wrong / answers - 0.03), Math.min(1, wrong / answers + 0.03)];
  const median_deg = method === "first_touch" ? null : offOf(random, method, ratio, "both");
  return { kind: "share", aspect, ratio, method, pairs: 1000, answers, off: wrong, low, high, median_deg };
}

function limit(random, sweep, shape, x, system) {
  const ratio = sweep === "ratio" ? x : 0.01;
  const stays = system === "geometric_potential";
  const angle = stays ? 11 + 20 * random() : 12 * ratio * (0.8 + 0.4 * random());
  const nothing = system === "first_touch" && x > 0.04 && sweep === "ratio";
  const of = (value) => (nothing ? null : value);
  const figures = {
    angle_deg: of(angle),
    angle_max_deg: of(angle * 3),
    point: of(ratio * 0.3),
    overlap: of(stays ? 0.2 : ratio),
  };
  return { kind: "limit", sweep, shape, x, system, pairs: 20, certified: nothing ? 0 : 20, ...figures };
}

function limits(random) {
  const sweeps = [
    ...["aspect 1.5", "aspect 2", "exponents 4"].map((shape) => ["ratio", shape, [1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 5e-2]]),
    ["aspect", "overlap ratio 0.01", [1.1, 1.5, 2, 3, 5, 10]],
    ["exponent", "overlap ratio 0.01", [2, 3, 4, 8, 16]],
  ];
  return sweeps.flatMap(([sweep, shape, values]) =>
    SYSTEMS.flatMap((system) => values.map((x) => limit(random, sweep, shape, x, system))),
  );
}

const orders = () =>
  ["aspect 1.5", "aspect 2", "exponents 4"].flatMap((shape) =>
    SYSTEMS.map((system) => {
      const stays = system === "geometric_potential";
      const powers = stays ? { angle: null, point: 1, overlap: null } : { angle: 1, point: 1.02, overlap: 0.98 };
      return { kind: "order", shape, system, ...powers, limit_deg: stays ? 17.3 : 1.2e-5 };
    }),
  );

const costs = () =>
  ["spheroid", "superquadric"].flatMap((set) =>
    METHODS.flatMap((method, index) =>
      [1e-2, 1e-6, 1e-10].map((target_deg, step) => {
        const reached = !(method === "first_touch" && target_deg < 1e-8);
        const found = reached
          ? { tolerance: method === "auto" ? null : target_deg / 100, evaluations: 6 + index + 3 * step, share: 0.999 }
          : { tolerance: null, evaluations: null, share: 0.41 };
        return { kind: "cost", set, method, target_deg, ...found };
      }),
    ),
  );

const root = (kind, starts, off_deg, documented) => ({
  kind,
  normal: kind === "both" ? null : [0.6, 0, 0.8],
  distance: 0.02,
  residues: kind === "common normal" ? [0, 1e-16, 0] : [0, 0.81, 1.8],
  off_deg,
  starts,
  documented,
});

function roots() {
  const counts = { kind: "roots", starts: 2000, not_converged: 31, elsewhere: 0 };
  const all = [
    root("signs", 812, 48.1, true),
    root("z", 400, 131, false),
    root("both", 300, null, false),
    root("common normal", 257, 0, false),
    root("common normal, apart", 200, 0.4, false),
  ];
  return [
    { ...counts, pair: "G1, overlap ratio 0.01", complete: true, reason: "", roots: all },
    { ...counts, pair: "S1, overlap ratio 0.01", complete: false, reason: "a box was left", roots: all.slice(2) },
  ];
}

export function studyLines() {
  const random = stream(2018);
  const maps = [1.5, 2].flatMap((aspect) =>
    [1e-3, 1e-2].flatMap((ratio) => METHODS.map((method) => map(random, method, aspect, ratio))),
  );
  const shares = [1.5, 2].flatMap((aspect) =>
    [1e-3, 1e-2].flatMap((ratio) => METHODS.map((method) => share(random, method, aspect, ratio))),
  );
  return [RUN, ...groups(random), ...maps, ...shares, ...limits(random), ...orders(), ...costs(), ...roots()];
}

/** As reports/document/study.cpp reads them. */
export function studyOf(lines) {
  const of = (wanted) => lines.filter(({ kind }) => kind === wanted).map(({ kind, ...line }) => line);
  const { commit, ...host } = lines[0].host;
  const answers = of("answer");
  const answersOf = (name) => answers.filter(({ group }) => group === name).map(({ group, ...line }) => line);
  return {
    commit,
    host,
    command: lines[0].command,
    interrupted: lines.some(({ kind }) => kind === "interrupted"),
    groups: of("group").map((group) => ({ ...group, answers: answersOf(group.group) })),
    maps: of("map"),
    shares: of("share"),
    limits: of("limit"),
    orders: of("order"),
    costs: of("cost"),
    roots: of("roots"),
  };
}

export const makeStudy = () => studyOf(studyLines());

/** Of a study alone. */
export const makeStudyReport = (study = makeStudy()) => ({
  ...makeReport({ families: [], failures: 0, precision: false, stability: false, study }),
  runs: [],
});
