// node compare.mjs PACKAGE LIBRARY SCALAR [--pairs N] [--seed S] holds the package's answers against those of two programs made of
// native_door.cpp: LIBRARY with the library, and SCALAR with the library as WebAssembly can have it, whose answers are to be the same to
// the last bit.
//
// A number agrees where it differs by at most 4 epsilon: overlaps of the larger body's size, normals of 1, points of the size or of the
// place, whichever is larger. Statuses agree where they are the same. A line a method; exit 1 where one is beyond its limits.
import { spawnSync } from "node:child_process";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { pairs } from "./pairs.mjs";

const EPSILONS = 4;
/** Degrees from the native normal of `auto`, within which a common normal is right. */
const RIGHT = 0.01;
/** Of 10 000 pairs: other statuses and answers beyond EPSILONS; in epsilons, the largest difference of all and of the right ones. */
const LIMITS = {
  auto: { status: 0, number: 5, worst: 16, worstRight: 16 },
  published: { status: 100, number: 3000, worst: Infinity, worstRight: 2 ** 17 },
  exact: { status: 0, number: 0, worst: 0, worstRight: 0 },
};
/** door.cpp's inputs behind the method, and what of its outputs is compared. */
const RECORD = 28;
const ANSWER = 17;
const OVERLAP = 2;
const NORMAL = [3, 4, 5];
const POINTS = [6, 7, 8, 9, 10, 11, 12, 13, 14];

const { values, positionals } = parseArgs({
  options: {
    pairs: { type: "string", default: "10000" },
    seed: { type: "string", default: "1" },
  },
  allowPositionals: true,
});
const [folder, ...programs] = positionals;
/** Without FMA glibc's exp, log and pow round as musl's do, which are the same algorithms. */
const WITHOUT_FMA = "glibc.cpu.hwcaps=-FMA_Usable,-FMA4_Usable,-AVX2_Usable,-FMA,-FMA4,-AVX2";
const { load } = await import(pathToFileURL(resolve(folder, "plumb_contact.mjs")).href);
const plumb = await load();
const cases = [...pairs(Number(values.pairs), Number(values.seed))];
const methods = plumb.methods.map(({ name }) => name);
const AUTO = methods.indexOf("auto");
const problems = new Map(plumb.methods.map(({ name, problem }) => [name, problem]));

function pairOf({ bodies }) {
  const body = ({ shape, position, orientation }) => ({
    ...shape.superellipsoid,
    position,
    quaternion: orientation.quaternion_wxyz,
  });
  return { bodies: bodies.map(body) };
}

const numbersOf = ({ semi_axes, exponents, position, quaternion }) => [
  ...semi_axes,
  ...exponents,
  ...position,
  ...quaternion,
];

function nativeAnswers(program, isExact) {
  const given = new Float64Array(cases.length * methods.length * RECORD);
  let at = 0;
  for (const one of cases)
    for (const method of methods) {
      given.set([methods.indexOf(method), ...pairOf(one).bodies.flatMap(numbersOf)], at);
      at += RECORD;
    }
  const { status, stdout } = spawnSync(resolve(program), {
    input: new Uint8Array(given.buffer),
    maxBuffer: 2 ** 30,
    env: { ...process.env, ...(isExact ? { GLIBC_TUNABLES: WITHOUT_FMA } : {}) },
  });
  const answers = new Float64Array(new Uint8Array(stdout).buffer);
  if (status !== 0 || answers.length !== cases.length * methods.length * ANSWER)
    throw new Error(`${program}: exit ${status}, ${answers.length} numbers`);
  return answers;
}

const sizeOf = ({ bodies }) => Math.max(...bodies.flatMap(({ semi_axes }) => semi_axes));
const farthest = ({ bodies }) => Math.max(...bodies.flatMap(({ position }) => position.map(Math.abs)));

/** In epsilons of the unit; 0 where neither is a number, infinite where one is. */
function apart(x, y, unit) {
  if (Number.isNaN(x) || Number.isNaN(y)) return Number.isNaN(x) && Number.isNaN(y) ? 0 : Infinity;
  return Math.abs(x - y) / unit / Number.EPSILON;
}

/** The largest of all numbers of an answer; points also have the rounding of where they are. */
function difference(pair, mine, native) {
  const size = sizeOf(pair);
  const place = Math.max(size, farthest(pair));
  const worst = (places, unit) => Math.max(...places.map((at) => apart(mine[at], native[at], unit)));
  return Math.max(worst([OVERLAP], size), worst(NORMAL, 1), worst(POINTS, place));
}

const flat = ({ overlap, normal, points, contact_point }) => [
  NaN,
  NaN,
  overlap,
  ...normal,
  ...points.flat(),
  ...contact_point,
];

const degrees = (a, b) => {
  const cross = [0, 1, 2].map((i) => a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
  return (Math.atan2(Math.hypot(...cross), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * 180) / Math.PI;
};
const normalOf = (native) => NORMAL.map((at) => native[at]);

/** Whether both are the common normal that `auto` answers. */
const areRight = (method, mine, native, auto) =>
  problems.get(method) === "common_normal" &&
  auto[0] === 0 &&
  [mine.normal, normalOf(native)].every((normal) => degrees(normal, normalOf(auto)) <= RIGHT);

const empty = () => ({ same: 0, status: 0, number: 0, worst: 0, right: 0, worstRight: 0, first: "" });

/** The word of a status's number, as its first answer has it. */
const words = new Map([[0, "converged"]]);

function hold(row, name, pair, method, mine, native, auto) {
  const isConverged = native[0] === 0;
  if (!words.has(native[0])) words.set(native[0], mine.status);
  if (words.get(native[0]) !== mine.status) {
    row.status++;
    row.first ||= name;
    return;
  }
  const off = isConverged ? difference(pair, flat(mine), native) : 0;
  row.worst = Math.max(row.worst, off);
  if (isConverged && areRight(method, mine, native, auto)) {
    row.right++;
    row.worstRight = Math.max(row.worstRight, off);
  }
  if (off === 0) row.same++;
  if (off <= EPSILONS) return;
  row.number++;
  row.first ||= name;
}

const natives = programs.map((program, at) => ({
  program,
  isExact: at === 1,
  answers: nativeAnswers(program, at === 1),
  rows: new Map(methods.map((name) => [name, empty()])),
}));
cases.forEach((one, index) => {
  const pair = pairOf(one);
  methods.forEach((method, at) => {
    const mine = plumb.solve(pair, { method });
    for (const { answers, rows } of natives) {
      const answer = (which) => answers.subarray((index * methods.length + which) * ANSWER).subarray(0, ANSWER);
      hold(rows.get(method), one.name, pair, method, mine, answer(at), answer(AUTO));
    }
  });
});

const column = (text, width) => String(text).padStart(width);
for (const { program, isExact, rows } of natives) {
  const limitsOf = (name) => (isExact ? LIMITS.exact : (LIMITS[name] ?? LIMITS.published));
  console.log(
    `${program}: ${cases.length} pairs; equal to the last bit; another status; beyond ${EPSILONS} epsilon; largest difference in epsilons; both right; their largest`,
  );
  for (const [name, row] of rows)
    console.log(
      `${name.padEnd(28)}${[row.same, row.status, row.number].map((n) => column(n, 8)).join("")}` +
        `${column(row.worst.toPrecision(3), 12)}${column(row.right, 8)}${column(row.worstRight.toPrecision(3), 12)}  ${row.first}`,
    );
  const beyond = [...rows].filter(([name, row]) => Object.entries(limitsOf(name)).some(([what, most]) => row[what] > most));
  for (const [name] of beyond) console.log(`${name}: beyond its limits, ${JSON.stringify(limitsOf(name))}`);
  if (beyond.length > 0) process.exitCode = 1;
}
