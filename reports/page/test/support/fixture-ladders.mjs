// Made-up ladders of the family hard, and what plumb report-stability would say of them.
const LADDERS = [
  ["near_touching_overlapping", "overlap_ratio", [1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-15, 1e-16]],
  ["nearly_concentric", "centre_distance", [1e-2, 1e-4, 1e-8, 1e-12, 1e-16, 1e-100, 1e-300, 5e-324, 0]],
  ["needle", "aspect", [10, 30, 100, 300, 1e3, 3e3, 1e4]],
  ["exponent_near_one", "exponent", [1.5, 1.4, 1.3, 1.2, 1.15, 1.1]],
  ["face_face", "tilt", [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-16, 0]],
  ["length_unit", "unit", [1e-3, 1e3, 1e-6, 1e6, 1e-9, 1e9, 1e-12, 1e12]],
];
const ARITHMETICS = ["double", "float", "long double", "50 digits", "up", "g++ -O0", "clang++ -O3 -march=native"];

/** From which share of the ladder a method fails, and how often at its end. */
const endurance = (index) => [1, 0.7, 0.3, 0, 0.5, 0.6, 0, 0, 0.1][index] ?? 0.4;

const firstOf = (counts) => {
  const step = counts.findIndex((n) => n > 0);
  return step < 0 ? null : step + 1;
};

function ladderRow(random, steps, method, index) {
  const from = Math.floor(endurance(index) * steps.length + 2 * (random() - 0.5) + 0.5);
  const answers = steps.map((_, step) => (step === 2 && random() < 0.1 ? 0 : 20 + Math.floor(40 * random())));
  const judged = answers.map((n) => (index === 4 && random() < 0.3 ? 0 : n));
  const failures = judged.map((n, step) =>
    method !== "auto" && step >= from ? Math.round(n * Math.min(1, 0.1 + random())) : 0,
  );
  const lost = failures.map((n) => Math.floor(n * random()));
  const wrong = failures.map((n, step) => n - lost[step]);
  const findings = {};
  if (lost.some((n) => n > 0)) findings.nonconverged = lost;
  if (wrong.some((n) => n > 0)) findings.misaligned = wrong;
  return {
    method,
    published: method !== "auto",
    answers,
    judged,
    not_converged: lost,
    lost,
    wrong,
    findings,
    lets_go: firstOf(failures),
  };
}

export const makeLadders = (random, methods) =>
  LADDERS.map(([name, knob, steps]) => ({
    name,
    knob,
    steps,
    methods: methods.map((method, index) => ladderRow(random, steps, method, index)),
  }));

function stabilityRow(random, steps, method, arithmetic, weakness) {
  const bad = steps.map((_, step) => (random() < weakness * (step / steps.length) ? 1 : 0));
  const isLost = random() < 0.5;
  const none = steps.map(() => 0);
  const epsilon = { float: 7, "50 digits": 50, "long double": 19 }[arithmetic] ?? 15.6;
  const least = (share) => Math.max(0, epsilon * share - random());
  return {
    method,
    arithmetic,
    cases: steps.map(() => 3),
    right: bad.map((n) => 3 - n),
    lost: isLost ? bad : none,
    wrong: isLost ? none : bad,
    digits: { overlap: least(1), normal: least(0.95), points: method === "new_cn" ? null : least(0.5) },
    lets_go: firstOf(bad),
  };
}

function totalsOf(ladders) {
  const totals = new Map();
  const sum = (counts) => counts.reduce((all, n) => all + n, 0);
  for (const { rows } of ladders)
    for (const { method, arithmetic, ...row } of rows) {
      const total = totals.get(`${method} ${arithmetic}`) ?? {
        method,
        arithmetic,
        cases: 0,
        right: 0,
        lost: 0,
        wrong: 0,
      };
      for (const count of ["cases", "right", "lost", "wrong"]) total[count] += sum(row[count]);
      totals.set(`${method} ${arithmetic}`, total);
    }
  return [...totals.values()];
}

export function makeStability(random, methods) {
  const ladders = LADDERS.map(([name, knob, steps]) => ({
    name,
    knob,
    steps,
    rows: [
      ...ARITHMETICS.map((word) => stabilityRow(random, steps, "auto", word, word === "float" ? 0.8 : 0)),
      ...methods.slice(1, 6).map((method) => stabilityRow(random, steps, method, "double", 0.7)),
    ],
  }));
  return {
    commit: "d8be58a",
    command: "plumb report-stability --out stability.jsonl",
    interrupted: false,
    host: { system: "Linux", machine: "x86_64", compiler: "g++ 12.2.0", flags: "-O2" },
    ladders,
    totals: totalsOf(ladders),
  };
}
