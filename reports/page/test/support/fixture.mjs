// A report as plumb would write it, from a seed: sizes and shapes of a real campaign, contents made up.
import { contactPair } from "./fixture-geometry.mjs";
import { makeLadders, makeStability } from "./fixture-ladders.mjs";
import { LOOKS, METHODS, weakness } from "./fixture-methods.mjs";
import { makePrecision } from "./fixture-precision.mjs";

export function stream(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

export const FAMILIES = ["spheroid", "ellipsoid", "superquadric", "hard", "real"];
export const FINDINGS = [
  ["crash", "the solver threw a C++ exception"],
  ["not_finite", "holds a NaN or an infinity where it claims an answer"],
  ["nonconverged", "has another status than converged: flagged by the solver itself"],
  ["false_contact", "has the wrong verdict: they are apart"],
  ["missed_contact", "has the wrong verdict: they touch"],
  ["wrong_branch", "is a common normal, but not the one of lowest overlap"],
  ["misaligned", "is no solution of its own problem"],
  ["off_surface", "has points off their surfaces"],
  ["overlap_error", "has another overlap than the reference"],
  ["point_error", "has other points than the reference"],
  ["asymmetric", "changes when the bodies are exchanged, moved, or measured in another unit"],
  ["nondeterministic", "changes from call to call"],
  ["slow", "took more than 1000 evaluations"],
  ["none", "breaks no law"],
].map(([word, meaning]) => ({ word, meaning }));

const LAWS = FINDINGS.slice(0, -1).map(({ word, meaning }, index) => ({
  name: `law_${word}`,
  statement: `No answer ${meaning}.`,
  file: "properties/laws/laws_answer.cpp",
  line: 40 + 17 * index,
}));

export function share(count, of) {
  if (of === 0) return { count, of, share: null, low: 0, high: 1 };
  const p = count / of;
  const half = 1.96 * Math.sqrt((p * (1 - p)) / of) + 1 / of;
  return { count, of, share: p, low: Math.max(0, p - half), high: Math.min(1, p + half) };
}

const spread = (p50, factor) => ({ p50, p99: p50 * factor, max: p50 * factor * 7.3 });
const command = (family, cases) => `plumb campaign --family ${family} --cases ${cases} --seed 1 --out runs/${family}`;

function methodRow(random, method, cases, worse) {
  const unjudged = Math.floor(cases * 0.004 * random());
  const judged = cases - unjudged;
  const [usual, luck] = [weakness(method) * (0.4 + 0.6 * random()), random()];
  const base = method === "auto" && worse ? 0.031 : usual;
  const failures = Math.round(judged * (method === "auto" && !worse && luck < 0.6 ? 0 : base));
  const findings = {};
  let left = failures;
  for (const word of ["nonconverged", "misaligned", "wrong_branch", "missed_contact", "asymmetric", "overlap_error"]) {
    const part = word === "overlap_error" ? left : Math.floor(left * (0.3 + 0.5 * random()));
    if (part > 0) findings[word] = share(part, judged);
    left -= part;
  }
  findings.none = share(judged - failures, judged);
  const refused = findings.nonconverged?.count ?? 0;
  const accuracy = 10 ** (-15 + 13 * Math.min(1, base));
  return {
    method,
    published: method !== "auto",
    answers: cases,
    judged,
    unjudged,
    converged: share(cases - (findings.nonconverged?.count ?? 0), cases),
    findings,
    failures: share(failures, judged),
    right: Object.fromEntries(
      ["rounding", "1e-6rad", "0.01deg", "1deg"].map((level, i) => [
        level,
        share(judged - refused - Math.round((failures - refused) / (1 + i)), judged),
      ]),
    ),
    not_asked: method.startsWith("peer") ? Math.floor(cases / 7) : 0,
    angle_above: share(Math.round(judged * base * 0.8), judged),
    angle_error_deg: { p50: accuracy, p99: Math.min(89, accuracy * 900), max: Math.min(179.3, accuracy * 9e4) },
    overlap_error: spread(accuracy * 0.1, 40),
    iterations: method.startsWith("peer") ? null : spread(2 + Math.round(8 * random()), 6),
    evaluations: spread(12, 5),
    ns_per_solve: spread(method === "auto" ? 350 : 5e3 * (1 + 4 * random()), 9),
  };
}

function familyOf(random, name, cases, methods, worse) {
  return {
    name,
    cases,
    command: command(name, cases),
    reference: {
      unsolved: Math.floor(3 * random()),
      not_proved_lowest: Math.floor(cases * 0.003),
      beaten: 0,
      needed: { bounds: Math.floor(cases * 0.97), proof: Math.floor(cases * 0.02), digits: Math.floor(cases * 0.01) },
    },
    methods: methods.map((method) => methodRow(random, method, cases, worse)),
  };
}

const added = (rows, of) =>
  share(
    rows.reduce((sum, row) => sum + (of(row)?.count ?? 0), 0),
    rows.reduce((sum, row) => sum + row.judged, 0),
  );

/** Over all families; percentiles cannot be added, so that these are the last family's. */
function totalOf(rows) {
  const sum = (field) => rows.reduce((total, row) => total + row[field], 0);
  const words = [...new Set(rows.flatMap((row) => Object.keys(row.findings)))];
  const levels = Object.keys(rows[0].right);
  return {
    ...rows.at(-1),
    answers: sum("answers"),
    judged: sum("judged"),
    unjudged: sum("unjudged"),
    not_asked: sum("not_asked"),
    converged: share(
      rows.reduce((total, row) => total + row.converged.count, 0),
      sum("answers"),
    ),
    findings: Object.fromEntries(words.map((word) => [word, added(rows, (row) => row.findings[word])])),
    failures: added(rows, (row) => row.failures),
    right: Object.fromEntries(levels.map((level) => [level, added(rows, (row) => row.right[level])])),
    angle_above: added(rows, (row) => row.angle_above),
  };
}

const edges = (from, factor, n) => Array.from({ length: n }, (_, i) => Number((from * factor ** i).toPrecision(2)));
const labelled = (title, from, factor, n) => {
  const at = edges(from, factor, n + 1);
  return { title, labels: at.slice(0, -1).map((low, i) => `[${low}, ${at[i + 1]})`) };
};

function atlasOf(random, family, method, map) {
  const x = map === "aspect-overlap" ? labelled("aspect", 1, 1.7, 10) : labelled("greatest exponent", 1, 1.6, 10);
  const y =
    map === "aspect-overlap" ? labelled("overlap ratio", 1e-8, 10, 8) : labelled("relative tilt, °", 0.1, 2.4, 8);
  const cells = [];
  for (let i = 0; i < x.labels.length; i++)
    for (let j = 0; j < y.labels.length; j++) {
      if (random() < 0.12) continue;
      const answers = random() < 0.15 ? 1 + Math.floor(18 * random()) : Math.floor(60 + 2000 * random());
      const judged = Math.floor(answers * (0.95 + 0.05 * random()));
      const p = Math.min(1, weakness(method) * ((i + 1) / 6) * (0.6 + 0.8 * random()));
      const not_converged = Math.floor(answers * p * 0.4);
      cells.push({
        x: i,
        y: j,
        answers,
        judged,
        failures: Math.floor(judged * p),
        not_converged,
        iterations: 3 + i + 2 * p,
      });
    }
  return { family, method, map, x, y, cells };
}

const SHAPES = [
  "spheroids",
  "ellipsoids",
  "blocky_superquadrics",
  "pointed_superquadrics",
  "ellipsoids-needle",
  "ellipsoids-disc",
];
const REGIMES = ["shallow", "moderate", "deep", "touching", "shallow-far", "moderate-unequal"];
const OVERLAPS = {
  shallow: 1e-5,
  moderate: 0.04,
  deep: 0.2,
  touching: 1e-10,
  "shallow-far": 1e-4,
  "moderate-unequal": 0.03,
};

/** Of a finding in turn; who gives no answer is right at none. */
const RIGHT_FROM = [null, "1e-6rad", null, "0.01deg", null, "1deg"];
const rightFrom = (index, finding) => (finding === "nonconverged" ? null : RIGHT_FROM[index % RIGHT_FROM.length]);

const shrunkOf = (method, file, { bodies, answer, reference }, finding, right_from) => ({
  explanation: `${method} is misaligned (expected overlap 0.1; normal 12 degrees off) for a sphere of radius 1 against another; one number changed at a time, it persists at every value tried of body 2's exponent n1 from 2 to 8`,
  file: file.replace(/--\w+\.json$/, "--shrunk.json"),
  replay: `plumb replay ${file.replace(/--\w+\.json$/, "--shrunk.json")}`,
  case: { format: "plumb/case-1", name: "shrunk", bodies, expect: { method, finding } },
  answer,
  reference,
  right_from,
});

function failureOf(random, index, methods) {
  const pick = (list) => list[Math.floor(list.length * random())];
  const own = index < 3;
  const [method, finding, shapes, regime] = [
    own ? "auto" : pick(methods),
    pick(FINDINGS.slice(2, 11)).word,
    pick(SHAPES),
    pick(REGIMES),
  ];
  const bucket = `${finding}-${method}-${shapes}-${regime}`;
  const kept = pick(["simplest", "worst", "only"]);
  const size = pick([1, 1, 1, 1e-9, 1e17]);
  const pair = contactPair(random, {
    kind: shapes,
    size,
    far: regime.includes("far") ? 1e6 * size : size * random(),
    ratio: regime.includes("unequal") ? 1e-4 : 0.6 + random(),
    overlapRatio: OVERLAPS[regime],
    tilt: pick([1e-6, 0.05, 0.6]),
  });
  const unanswered = random() < 0.06;
  const right_from = unanswered ? null : rightFrom(index, finding);
  const file = `runs/hard/failures/${bucket}--${kept}.json`;
  return {
    bucket,
    kept,
    count: Math.ceil(10 ** (3.5 * random())),
    finding,
    method,
    shapes,
    regime,
    family: pick(FAMILIES.slice(0, 4)),
    own,
    severity: random() < 0.05 ? "infinite" : 10 ** (16 * random()),
    law: `law_${finding}`,
    detail: `normals are ${(180 * random()).toFixed(3)} degrees from opposite; allowed 1.2e-13`,
    file,
    replay: `plumb replay --method ${method} ${file}`,
    case: { format: "plumb/case-1", name: `pair ${index}`, bodies: pair.bodies, expect: { method, finding } },
    answer: unanswered ? null : pair.answer,
    reference: pair.reference,
    right_from,
    ...(unanswered ? { reason: "the solver threw" } : {}),
    ...(kept !== "worst" && index % 2 === 0 && !unanswered
      ? { shrunk: shrunkOf(method, file, pair, finding, right_from) }
      : {}),
  };
}

export function makeRun(options = {}) {
  const { name = "run", seed = 1, cases = 100000, failures = 500, methods = METHODS, families = FAMILIES } = options;
  const random = stream(seed * 7919);
  const each = Math.floor(cases / families.length);
  const made = families.map((family) => familyOf(random, family, each, methods, options.worse));
  return {
    name,
    folder: `runs/${name}`,
    commit: options.commit ?? "d8be58a",
    seed: String(seed),
    cases,
    incomplete: options.incomplete ?? false,
    commands: families.map((family) => command(family, each)),
    host: {
      system: "Linux 6.1.0-28-amd64",
      machine: "x86_64, Intel(R) Xeon(R) Platinum",
      processors: 2,
      compiler: "GNU 12.2.0",
      flags: "-O2 -march=x86-64-v2 -ffp-contract=off",
    },
    harness_errors: options.harnessErrors ?? {},
    timing: { seconds: 412.7, threads: 2, cases_per_second: cases / 412.7 },
    totals: made.length === 0 ? [] : methods.map((_, i) => totalOf(made.map((family) => family.methods[i]))),
    families: made,
    atlases: families.flatMap((family) =>
      methods.flatMap((method) =>
        ["aspect-overlap", "exponent-tilt"].map((map) => atlasOf(random, family, method, map)),
      ),
    ),
    ladders: families.includes("hard") ? makeLadders(stream(seed * 31), methods) : [],
    kept_failures: failures + 7,
    failures: Array.from({ length: failures }, (_, index) => failureOf(random, index, methods)),
  };
}

const verdictOf = (before, after) => (before === after ? "same" : after > before ? "worse" : "better");

/** The rows that plumb would write of two runs of the fixture. */
function compare(before, after, sameCases) {
  const rows = before.families.flatMap((family, f) =>
    family.methods.flatMap((row, m) => {
      const other = after.families[f].methods[m];
      const own = row.method === "auto";
      const of = (measure, unit, a, b, intervals = {}) => {
        const verdict = own || sameCases ? verdictOf(a, b) : "noise";
        return {
          family: family.name,
          method: row.method,
          measure,
          unit,
          before: a,
          after: b,
          ...intervals,
          p: sameCases ? null : own ? 1e-9 : 0.4,
          verdict,
        };
      };
      const ranges = {
        before_interval: [row.failures.low, row.failures.high],
        after_interval: [other.failures.low, other.failures.high],
      };
      return [
        of("misaligned", "share", row.failures.share, other.failures.share, ranges),
        of("angle_error_deg p99", "deg", row.angle_error_deg.p99, row.angle_error_deg.p99),
        of("overlap_error p99", "relative", row.overlap_error.p99, row.overlap_error.p99),
        of("iterations p50", "count", row.iterations?.p50 ?? null, row.iterations?.p50 ?? null),
      ];
    }),
  );
  return { before: before.name, after: after.name, same_cases: sameCases, rows };
}

export function makeReport(options = {}) {
  const first = makeRun({ name: "main", ...options });
  const runs = [first];
  if (options.second) {
    const planted = { ...options, name: "branch", commit: "41c9ba6", worse: true };
    runs.push(makeRun({ ...planted, failures: Math.min(40, options.failures ?? 500) }));
  }
  const precision = options.precision === false ? null : makePrecision(stream(99));
  return {
    format: "plumb/report-1",
    made: { commit: "41c9ba6", compiler: "GNU 12.2.0", flags: "-O2", command: "plumb report runs/main -o report.html" },
    runs,
    comparisons: runs.slice(1).map((run) => compare(first, run, options.sameCases ?? true)),
    precision,
    stability: options.stability === false ? null : makeStability(stream(17), METHODS),
    study: options.study ?? null,
    fem: options.fem ?? null,
    playbacks: options.playbacks ?? [],
    findings: FINDINGS,
    laws: LAWS,
    methods: LOOKS,
  };
}
