// node time.mjs PACKAGE BIN [--pairs N] [--repeat R] [--most RATIO]: what all methods of a pair take here, beside the native `plumb solve --repeat R`.
// Each solve is timed as the smallest of R calls, cold; a line a method, then the sum of all, which may be RATIO times as long: or exit 1.
import { spawnSync } from "node:child_process";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { pairs } from "./pairs.mjs";

const { values, positionals } = parseArgs({
  options: {
    pairs: { type: "string", default: "300" },
    repeat: { type: "string", default: "15" },
    most: { type: "string", default: "Infinity" },
  },
  allowPositionals: true,
});
const [folder, bin] = positionals;
const repeat = Number(values.repeat);
const { load } = await import(pathToFileURL(resolve(folder, "plumb_contact.mjs")).href);
const plumb = await load();
const cases = [...pairs(Number(values.pairs), 1)];

const native = spawnSync(
  resolve(bin, "plumb-solve"),
  ["-", "--method", plumb.methods.map(({ name }) => name).join(","), "--json", "--repeat", values.repeat],
  {
    input: cases.map((one) => `${JSON.stringify(one)}\n`).join(""),
    encoding: "utf8",
    maxBuffer: 2 ** 30,
  },
);
const theirs = native.stdout
  .trim()
  .split("\n")
  .map((line) => JSON.parse(line));

const pairOf = ({ bodies }) => ({
  bodies: bodies.map(({ shape: { superellipsoid }, position, orientation }) => ({
    ...superellipsoid,
    position,
    quaternion: orientation.quaternion_wxyz,
  })),
});

function least(pair, method) {
  let best = Infinity;
  for (let call = 0; call < repeat; call++) {
    const before = performance.now();
    plumb.solve(pair, { method });
    best = Math.min(best, performance.now() - before);
  }
  return best * 1e6;
}

for (const one of cases) for (const { name } of plumb.methods) plumb.solve(pairOf(one), { method: name }); // compiled by then

const sums = new Map(plumb.methods.map(({ name }) => [name, { here: 0, native: 0 }]));
cases.forEach((one, index) =>
  plumb.methods.forEach(({ name }, at) => {
    const sum = sums.get(name);
    sum.here += least(pairOf(one), name);
    sum.native += theirs[index * plumb.methods.length + at].timing.ns;
  }),
);

const show = (name, { here, native }) =>
  console.log(
    `${name.padEnd(28)}${(here / cases.length / 1e3).toFixed(2).padStart(10)}${(native / cases.length / 1e3).toFixed(2).padStart(10)}${(here / native).toFixed(2).padStart(8)}`,
  );
console.log(`${cases.length} pairs, mean of a solve in us: WebAssembly, native, ratio`);
for (const [name, sum] of sums) show(name, sum);
const all = { here: 0, native: 0 };
for (const { here, native: theirTime } of sums.values()) {
  all.here += here;
  all.native += theirTime;
}
show("all methods of a pair", all);
process.exitCode = all.here / all.native > Number(values.most) ? 1 : 0;
