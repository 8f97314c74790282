// node --test: the packed package in an empty project. PLUMB_PACKAGE names the .tgz.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { test } from "node:test";

const PACKAGE = resolve(process.env.PLUMB_PACKAGE);

const FIVE_LINES = `import { load } from "plumb-contact";
const plumb = await load();
const bodies = [{ semi_axes: [1, 0.7, 0.5] }, { semi_axes: [0.5, 0.5, 0.4], exponents: [8, 8], position: [0.9, 0.2, 0.7] }];
const contact = plumb.solve({ bodies });
console.log(JSON.stringify(contact));
`;

/** What the program prints, as JSON, in an empty project with the package installed. */
async function printed(program) {
  const folder = await mkdtemp(join(tmpdir(), "plumb-contact-"));
  const run = (command, ...args) =>
    execFileSync(command, args, { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "inherit"] });
  try {
    await writeFile(join(folder, "package.json"), '{ "type": "module" }');
    run("npm", "install", "--offline", "--no-audit", "--no-fund", "--silent", PACKAGE);
    await writeFile(join(folder, "main.mjs"), program);
    return JSON.parse(run(process.execPath, "main.mjs"));
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}

test("installed into an empty project it solves a pair in five lines", () =>
  printed(FIVE_LINES).then((contact) => {
    assert.equal(contact.status, "converged");
    assert.ok(Math.abs(Math.hypot(...contact.normal) - 1) < 1e-15);
  }));

test("illegal input is an answer, and says what is wrong; a wrong method is an error", () =>
  printed(`import { load } from "plumb-contact";
const plumb = await load();
const bodies = [{ semi_axes: [1, 1, 1] }, { semi_axes: [1, -1, 1] }];
let error = "";
try { plumb.solve({ bodies }, { method: "none" }); } catch (e) { error = e.name; }
console.log(JSON.stringify([plumb.solve({ bodies }).status, plumb.describeInput({ bodies }), error]));
`).then(([status, text, error]) => {
    assert.equal(status, "invalid_input");
    assert.match(text, /^bodies\[1\].*semi_axes\[1\]/);
    assert.equal(error, "RangeError");
  }));

test("bounds enclose what is known; bad input is an error", () =>
  printed(`import { load } from "plumb-contact";
const plumb = await load();
const ball = { semi_axes: [1, 1, 1] };
const cube = { semi_axes: [1, 0.8, 0.6], exponents: [9, 12], quaternion: [1, 1e-9, 0.2, 0] };
const pairs = [{ bodies: [ball, { ...ball, position: [0, 1.5, 0] }] }, { bodies: [ball, { ...ball, position: [0, 2.5, 0] }] },
  { bodies: [cube, { ...cube, position: [0.1, 0.2, 1], quaternion: [1, 0, 0, 0] }] }];
const found = pairs.map((pair) => { const contact = plumb.solve(pair); return [contact.overlap, plumb.bounds(pair, contact, { cells: 10000 })]; });
const contact = plumb.solve(pairs[0]);
const misled = plumb.bounds(pairs[0], { ...contact, normal: [1, 0, 0] });
const told = [() => plumb.bounds(pairs[0], contact, { cells: 0 }), () => plumb.bounds(pairs[0], { ...contact, status: "stalled" }),
  () => plumb.bounds({ bodies: [ball, { semi_axes: [1, -1, 1] }] }, contact)].map((call) => {
  try { call(); return ""; } catch (error) { return error.name + ": " + error.message; }
});
console.log(JSON.stringify({ found, misled, told }));
`).then(({ found, misled, told }) => {
    for (const [overlap, { lower, upper }] of found) {
      assert.ok(lower - 1e-15 <= overlap && overlap <= upper + 1e-15, `${lower} ${overlap} ${upper}`);
      assert.ok(upper - lower < 1e-7, `${lower} ${upper}`);
    }
    assert.ok(misled.lower <= 0.5 && misled.upper >= 2, `${misled.lower} ${misled.upper}`);
    assert.match(told[0], /^RangeError: cells must be a whole number/);
    assert.match(told[1], /^RangeError: bounds are about a contact that converged/);
    assert.match(told[2], /^RangeError: bodies\[1\].*semi_axes\[1\]/);
  }));

test("too few or too many numbers are an error that names the field", () =>
  printed(`import { load } from "plumb-contact";
const plumb = await load();
const ball = { semi_axes: [1, 1, 1] };
plumb.solve({ bodies: [ball, { ...ball, position: [1, 0, 0] }] });
const told = [[ball], [ball, ball, ball], [ball, { semi_axes: [1, 1] }], [ball, { ...ball, position: [1, 0] }]].map((bodies) => {
  try { return plumb.solve({ bodies }).status; } catch (error) { return error.message; }
});
console.log(JSON.stringify(told));
`).then((told) => {
    const two = "bodies must be two";
    assert.deepEqual(told, [
      two,
      two,
      "bodies[1].semi_axes must be 3 numbers",
      "bodies[1].position must be 3 numbers",
    ]);
  }));
