// node compare.mjs PACKAGE NATIVE [--pairs N] [--seed S] holds the package's answers against those of NATIVE, the program made of
// native_door.cpp and the library.
//
// A number agrees where it differs by at most 4 epsilon: overlaps of the larger body's size, normals of 1, points of the size or of the
// place, whichever is larger. A line a method; exit 1 where a status differs, where numbers of more than --may answers of one method do, or
// one by more than --worst epsilon.
import { spawnSync } from "node:child_process";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { pairs } from "./pairs.mjs";

const EPSILONS = 4;
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
    may: { type: "string", default: "0" },
    worst: { type: "string", default: "4" },
    method: { type: "string" },
  },
  allowPositionals: true,
});
const [folder, program] = positionals;
const { load } = await import(pathToFileURL(resolve(folder, "plumb_contact.mjs")).href);
const plumb = await load();
const cases = [...pairs(Number(values.pairs), Number(values.seed))];
const methods = plumb.methods.map(({ name }) => name);
const judged = values.method ? [values.method] : methods;

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

function nativeAnswers() {
  const given = new Float64Array(cases.length * judged.length * RECORD);
  let at = 0;
  for (const one of cases)
    for (const method of judged) {
      given.set([methods.indexOf(method), ...pairOf(one).bodies.flatMap(numbersOf)], at);
      at += RECORD;
    }
  const { status, stdout } = spawnSync(resolve(program), { input: new Uint8Array(given.buffer), maxBuffer: 2 ** 30 });
  const answers = new Float64Array(new Uint8Array(stdout).buffer);
  if (status !== 0 || answers.length !== cases.length * judged.length * ANSWER)
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

const rows = new Map(judged.map((name) => [name, { same: 0, status: 0, number: 0, worst: 0, first: "" }]));

/** The word of a status's number, as its first answer has it. */
const words = new Map([[0, "converged"]]);

function hold(row, name, pair, method, native) {
  const mine = plumb.solve(pair, { method });
  const isConverged = native[0] === 0;
  if (!words.has(native[0])) words.set(native[0], mine.status);
  if (words.get(native[0]) !== mine.status) {
    row.status++;
    row.first ||= name;
    return;
  }
  const off = isConverged ? difference(pair, flat(mine), native) : 0;
  row.worst = Math.max(row.worst, off);
  if (off === 0) row.same++;
  if (off <= EPSILONS) return;
  row.number++;
  row.first ||= name;
}

const answers = nativeAnswers();
cases.forEach((one, index) =>
  judged.forEach((method, at) => {
    const from = (index * judged.length + at) * ANSWER;
    hold(rows.get(method), one.name, pairOf(one), method, answers.subarray(from, from + ANSWER));
  }),
);

const column = (text, width) => String(text).padStart(width);
console.log(
  `${cases.length} pairs; equal to the last bit; another status; beyond ${EPSILONS} epsilon; largest difference in epsilons`,
);
for (const [name, row] of rows)
  console.log(
    `${name.padEnd(28)}${[row.same, row.status, row.number].map((n) => column(n, 8)).join("")}` +
      `${column(row.worst.toPrecision(3), 12)}  ${row.first}`,
  );
const differs = ({ status, number, worst }) => status > 0 || number > Number(values.may) || worst > Number(values.worst);
process.exitCode = [...rows.values()].some(differs) ? 1 : 0;
