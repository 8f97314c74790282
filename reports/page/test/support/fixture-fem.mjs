// Made-up lines of reports/fem/run, and the document that plumb report makes of them.
import { makeReport, stream } from "./fixture.mjs";

const METHODS = ["auto", "geometric_potential", "geometric_potential_midway", "first_touch", "original_cn"];
const RATIOS = [0.002, 0.005, 0.01, 0.02];
const NAMES = ["S01", "S02", "S10", "E01", "Q01"];

const RUN = {
  kind: "run",
  command: "reports/fem/run --quick --out made_up.jsonl",
  host: { commit: "0fe0fe0", ccx: "2.20", gmsh: "4.8.4", machine: "x86_64" },
  mode: "quick",
  young: 1000,
  poisson: 0.3,
  held: "the far half of each body",
  limits: {
    cn: [
      { ratio: 0.005, below_deg: 0.2 },
      { ratio: 0.02, below_deg: 1 },
    ],
    times: 5,
    apart_deg: 5,
  },
};

const SHAPES = {
  S: ["spheroid", { semi_axes: [1, 1, 2], exponents: [2, 2] }],
  E: ["ellipsoid", { semi_axes: [1, 1.5, 2], exponents: [2, 2] }],
  Q: ["superquadric", { semi_axes: [1, 1.2, 1], exponents: [4, 3] }],
};

function geometry(name, index) {
  const [shape, body] = SHAPES[name[0]];
  return {
    kind: "geometry",
    name,
    shape,
    bodies: [body, ["S02", "Q01"].includes(name) ? { ...body, semi_axes: [1, 1, 1.5] } : body],
    line_deg: [35 + index, 10],
    quaternion: [0.8, 0.6, 0, 0],
  };
}

/**
 * S02 breaks what is asked of CN at 0.5 %, and Q01 what is asked of GP at 2 %; S10 has CN and GP near to each other, and E01 no answer of GP
 * at 1 %.
 */
function answer(random, name, ratio) {
  const cn = name === "S02" && ratio === 0.005 ? 0.31 : 20 * ratio * (0.2 + random());
  const hasGp = name !== "E01" || ratio !== 0.01;
  const gp = name === "S10" ? 2 : name === "Q01" && ratio === 0.02 ? 4 * cn : 12 + 20 * random();
  const angles_deg = {
    auto: cn,
    geometric_potential: hasGp ? gp : null,
    geometric_potential_midway: 3 * cn,
    first_touch: 60 * ratio,
    original_cn: name === "Q01" ? null : 40 + 20 * random(),
  };
  const centre_off = Object.fromEntries(
    METHODS.map((method) => [method, angles_deg[method] && angles_deg[method] / 30]),
  );
  return {
    kind: "answer",
    geometry: name,
    ratio,
    force: 0.01 * ratio,
    direction: [0, 0.6, 0.8],
    angles_deg,
    cn_to_gp_deg: !hasGp ? null : name === "S10" ? 2 : 15,
    centre_off,
    patch_radius: Math.sqrt(ratio),
    fem_patch_radius: 0.94 * Math.sqrt(ratio),
    balance: 1e-9,
    nodes: 15000,
    iterations: 31,
  };
}

const CHECKS = [
  { kind: "check", check: "hertz_force", value: 1.2, limit: 2, unit: "%" },
  { kind: "check", check: "hertz_direction", value: 0.02, limit: 0.01, unit: "degree" },
  { kind: "check", check: "balance", value: 1e-9, limit: 1e-6, unit: "relative" },
];

const UNANSWERED = {
  kind: "convergence",
  geometry: "S02",
  ratio: 0.01,
  varied: "penalty",
  setting: "1000",
  reason: "did not converge",
};

const convergence = () =>
  ["mesh", "order", "penalty", "increments", "swap", "held"].map((varied, index) => ({
    kind: "convergence",
    geometry: "S01",
    ratio: 0.01,
    varied,
    setting: varied === "held" ? "the far quarter" : `${2 ** index}`,
    turned_deg: 0.004 * index,
    force_change: varied === "held" ? -0.42 : 0.003 * index,
    patch_change: 0.013 * index,
    centre_shift: 0.001 * index,
  }));

const halfSpaces = () =>
  ["auto", "geometric_potential", "centre_line"].flatMap((start, index) =>
    ["S01", "Q01"].map((name) => ({
      kind: "half_space",
      geometry: name,
      ratio: 0.002,
      start,
      start_deg: 8 * index,
      planes: 3 + index,
      cn_deg: 0.02,
      fem_deg: name === "Q01" ? null : 0.05,
      force: 2e-5,
      patch_radius: 0.045,
      fem_force: name === "Q01" ? null : 0.97,
      fem_patch: name === "Q01" ? null : 0.92,
      centre_off: name === "Q01" ? null : 0.03,
      curvatures: name === "Q01" ? [3, 2, 0.75] : [1.2, 1.1, 1],
    })),
  );

export function femLines() {
  const random = stream(2020);
  const answers = NAMES.flatMap((name) => RATIOS.map((ratio) => answer(random, name, ratio)));
  return [RUN, ...NAMES.map(geometry), ...CHECKS, ...convergence(), ...answers, ...halfSpaces(), UNANSWERED];
}

const cnWithin = ({ cn }, { ratio, angles_deg }) =>
  angles_deg.auto < cn.find((bound) => ratio <= bound.ratio).below_deg;

function gpBeyond({ times, apart_deg }, { cn_to_gp_deg, angles_deg }) {
  if (cn_to_gp_deg === null) return false;
  return cn_to_gp_deg > apart_deg ? angles_deg.geometric_potential > times * angles_deg.auto : null;
}

const counted = (verdicts) => ({
  held: verdicts.filter((verdict) => verdict === true).length,
  of: verdicts.filter((verdict) => verdict !== null).length,
});

/** As reports/document/fem.cpp reads them. */
export function femOf(lines) {
  const whole = lines.filter(({ reason }) => reason === undefined);
  const of = (wanted) => whole.filter(({ kind }) => kind === wanted).map(({ kind, ...line }) => line);
  const [{ host: all, command, mode, young, poisson, held, limits }] = of("run");
  const { commit, ...host } = all;
  const answers = of("answer").map((one) => ({
    ...one,
    cn_within: cnWithin(limits, one),
    gp_beyond: gpBeyond(limits, one),
  }));
  const within = (above, most) =>
    counted(answers.filter(({ ratio }) => ratio > above && ratio <= most).map(({ cn_within }) => cn_within));
  return {
    commit,
    host,
    command,
    interrupted: of("interrupted").length > 0,
    mode,
    young,
    poisson,
    held,
    asked: {
      cn: limits.cn.map((bound, index) => {
        const above = limits.cn[index - 1]?.ratio ?? 0;
        return { above, ...bound, ...within(above, bound.ratio) };
      }),
      gp: { times: limits.times, apart_deg: limits.apart_deg, ...counted(answers.map(({ gp_beyond }) => gp_beyond)) },
    },
    geometries: of("geometry"),
    checks: of("check").map((check) => ({ ...check, within: check.value <= check.limit })),
    convergence: of("convergence"),
    answers,
    half_space: of("half_space").map((plane) => ({ ...plane, bends: plane.curvatures[0] / plane.curvatures[2] })),
    unanswered: lines
      .filter(({ reason }) => reason !== undefined)
      .map((line) => ({ varied: null, setting: null, start: null, ...line })),
  };
}

export const makeFem = () => femOf(femLines());

/** Of finite elements alone. */
export const makeFemReport = (fem = makeFem()) => ({
  ...makeReport({ families: [], failures: 0, precision: false, stability: false, fem }),
  runs: [],
});
