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

async function inProject(use) {
  const folder = await mkdtemp(join(tmpdir(), "plumb-contact-"));
  const run = (command, ...args) =>
    execFileSync(command, args, { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "inherit"] });
  try {
    await writeFile(join(folder, "package.json"), '{ "type": "module" }');
    run("npm", "install", "--offline", "--no-audit", "--no-fund", "--silent", PACKAGE);
    return await use(folder, run);
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}

test("installed into an empty project it solves a pair in five lines", () =>
  inProject(async (folder, run) => {
    await writeFile(join(folder, "main.mjs"), FIVE_LINES);
    const contact = JSON.parse(run(process.execPath, "main.mjs"));
    assert.equal(contact.status, "converged");
    assert.ok(Math.abs(Math.hypot(...contact.normal) - 1) < 1e-15);
  }));

test("illegal input is an answer, and says what is wrong; a wrong method is an error", () =>
  inProject(async (folder, run) => {
    await writeFile(
      join(folder, "main.mjs"),
      `import { load } from "plumb-contact";
const plumb = await load();
const bodies = [{ semi_axes: [1, 1, 1] }, { semi_axes: [1, -1, 1] }];
let error = "";
try { plumb.solve({ bodies }, { method: "none" }); } catch (e) { error = e.name; }
console.log(JSON.stringify([plumb.solve({ bodies }).status, plumb.describeInput({ bodies }), error]));
`,
    );
    const [status, text, error] = JSON.parse(run(process.execPath, "main.mjs"));
    assert.equal(status, "invalid_input");
    assert.match(text, /^bodies\[1\].*semi_axes\[1\]/);
    assert.equal(error, "RangeError");
  }));

test("too few or too many numbers are an error that names the field", () =>
  inProject(async (folder, run) => {
    await writeFile(
      join(folder, "main.mjs"),
      `import { load } from "plumb-contact";
const plumb = await load();
const ball = { semi_axes: [1, 1, 1] };
plumb.solve({ bodies: [ball, { ...ball, position: [1, 0, 0] }] });
const told = [[ball], [ball, ball, ball], [ball, { semi_axes: [1, 1] }], [ball, { ...ball, position: [1, 0] }]].map((bodies) => {
  try { return plumb.solve({ bodies }).status; } catch (error) { return error.message; }
});
console.log(JSON.stringify(told));
`,
    );
    const two = "bodies must be two";
    assert.deepEqual(JSON.parse(run(process.execPath, "main.mjs")), [
      two,
      two,
      "bodies[1].semi_axes must be 3 numbers",
      "bodies[1].position must be 3 numbers",
    ]);
  }));
