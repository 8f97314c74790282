// node compare.mjs PACKAGE BIN [--pairs N] [--seed S] holds the package's answers against those of the native `plumb solve` in BIN.
//
// A number agrees where it differs by at most 4 epsilon: overlaps of the larger body's size, normals of 1, points of the size or of the
// place, whichever is larger. Statuses agree where they are the same word. A line a method; exit 1 where any answer differs.
import { spawn } from "node:child_process";
import { createInterface } from "node:readline";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { pairs } from "./pairs.mjs";

const EPSILONS = 4;

const { values, positionals } = parseArgs({
  options: { pairs: { type: "string", default: "10000" }, seed: { type: "string", default: "1" } },
  allowPositionals: true,
});
const [folder, bin] = positionals;
const { load } = await import(pathToFileURL(resolve(folder, "plumb_contact.mjs")).href);
const plumb = await load();
const cases = [...pairs(Number(values.pairs), Number(values.seed))];

function pairOf({ bodies, motion }) {
  const body = ({ shape: { superellipsoid: s }, position, orientation }) => ({
    semi_axes: s.semi_axes,
    exponents: s.exponents ?? [2, 2],
    position,
    quaternion: orientation.quaternion_wxyz,
  });
  return { bodies: bodies.map(body), ...(motion && { motion }) };
}

const sizeOf = ({ bodies }) => Math.max(...bodies.flatMap(({ semi_axes }) => semi_axes));
const farthest = ({ bodies }) => Math.max(...bodies.flatMap(({ position }) => position.map(Math.abs)));

/** What `plumb solve` leaves out is not a number here. */
const numbers = (given, count) => (given === undefined ? Array(count).fill(NaN) : [given].flat(2));

/** In epsilons of the unit; 0 where neither is a number, infinite where one is. */
function apart(x, y, unit) {
  if (Number.isNaN(x) || Number.isNaN(y)) return Number.isNaN(x) && Number.isNaN(y) ? 0 : Infinity;
  return Math.abs(x - y) / unit / Number.EPSILON;
}

/** The largest of all numbers of an answer; points also have the rounding of where they are. */
function difference(pair, mine, native) {
  const size = sizeOf(pair);
  const place = Math.max(size, farthest(pair));
  const units = { overlap: size, normal: 1, points: place, contact_point: place };
  return Math.max(
    ...Object.entries(units).flatMap(([field, unit]) => {
      const here = numbers(mine[field]);
      const there = numbers(native[field], here.length);
      return here.map((x, at) => apart(x, there[at], unit));
    }),
  );
}

const rows = new Map(plumb.methods.map(({ name }) => [name, { answers: 0, same: 0, status: 0, number: 0, worst: 0, first: "" }]));

const native = spawn(resolve(bin, "plumb-solve"), ["-", "--method", plumb.methods.map(({ name }) => name).join(","), "--json"], { stdio: ["pipe", "pipe", "inherit"] });
native.stdin.end(`${cases.map((one) => JSON.stringify(one)).join("\n")}\n`);

let line = 0;
for await (const text of createInterface({ input: native.stdout })) {
  const one = cases[Math.floor(line++ / plumb.methods.length)];
  const theirs = JSON.parse(text);
  if (theirs.name !== one.name) throw new Error(`answers of ${one.name} expected, not of ${theirs.name}`);
  hold(one, pairOf(one), theirs);
}
if (line !== cases.length * plumb.methods.length) throw new Error(`${line} answers to ${cases.length} pairs`);

function hold(one, pair, theirs) {
  const row = rows.get(theirs.method);
  const mine = plumb.solve(pair, { method: theirs.method });
  const converged = mine.status === "converged" && theirs.status === "converged";
  const off = converged ? difference(pair, mine, theirs) : 0;
  row.answers++;
  row.worst = Math.max(row.worst, off);
  if (mine.status !== theirs.status) row.status++;
  else if (off === 0) row.same++;
  else if (!(off <= EPSILONS)) row.number++;
  if (mine.status !== theirs.status || !(off <= EPSILONS)) row.first ||= one.name;
}

const column = (text, width) => String(text).padStart(width);
console.log(`${cases.length} pairs; equal to the last bit; another status; beyond ${EPSILONS} epsilon; largest difference in epsilons`);
for (const [name, row] of rows)
  console.log(
    `${name.padEnd(28)}${[row.answers, row.same, row.status, row.number].map((n) => column(n, 8)).join("")}` +
      `${column(row.worst.toPrecision(3), 12)}  ${row.first}`,
  );
process.exitCode = [...rows.values()].some(({ status, number }) => status + number > 0) ? 1 : 0;
