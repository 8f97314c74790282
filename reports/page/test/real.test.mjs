// What plumb report itself writes, in Chromium: PLUMB_BIN is the folder of the programs; without it there is nothing to ask.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { bring, SCREEN } from "./support/browser.mjs";
import { femLines, femOf } from "./support/fixture-fem.mjs";
import { playbackLines, playbackOf, withShapedWalls } from "./support/fixture-playback.mjs";
import { studyLines, studyOf } from "./support/fixture-study.mjs";
import { withFolder } from "./support/pages.mjs";
import { withUrl } from "./support/tab.mjs";

const bin = process.env.PLUMB_BIN;
const skip = bin ? false : "PLUMB_BIN is not set";

function run(folder, program, ...args) {
  return execFileSync(join(bin, program), args, { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] });
}

/** Two campaigns and, where it was built, a sweep of work and precision. */
function makePage(folder) {
  for (const seed of ["1", "2"])
    run(folder, "plumb", "campaign", "--family", "all", "--cases", "12", "--seed", seed, "--out", `seed${seed}`);
  if (existsSync(join(bin, "plumb-report-precision"))) {
    const few = ["--set", "spheroid", "--method", "auto,new_cn", "--cases", "3", "--repeat", "1"];
    run(folder, "plumb", "report-precision", ...few, "--out", "seed2/precision.jsonl");
  }
  run(folder, "plumb", "report", "seed1", "seed2", "-o", "page.html");
  return pathToFileURL(join(folder, "page.html")).href;
}

/** Twice the same campaign, but half of what new_cn had right is misaligned in the second. */
function makePlanted(folder) {
  for (const name of ["before", "after"])
    run(folder, "plumb", "campaign", "--family", "spheroid", "--cases", "20", "--method", "new_cn", "--out", name);
  const file = join(folder, "after", "campaign.bins");
  const bins = JSON.parse(readFileSync(file, "utf8"));
  const { findings } = bins.families.spheroid.methods.new_cn;
  const [misaligned, none] = [6, 13];
  const half = Math.floor(findings[none] / 2);
  findings[none] -= half;
  findings[misaligned] += half;
  writeFileSync(file, JSON.stringify(bins));
  run(folder, "plumb", "report", "before", "after", "-o", "planted.html");
  return pathToFileURL(join(folder, "planted.html")).href;
}

test("a regression planted in a campaign is the first row of the comparison", { skip }, () =>
  withFolder(async (folder) => {
    const url = makePlanted(folder);
    await withUrl(url, {}, async (page) => {
      const rows = await page.$$eval("#compare tbody tr", (all) => all.map((row) => row.textContent));
      assert.match(rows[0], /worse.*spheroid.*new_.?cn/);
      assert.ok(rows.slice(0, 2).some((row) => /misaligned/.test(row)));
      assert.ok(rows.slice(2).every((row) => !/worse/.test(row)));
    });
  }),
);

test("a report of plumb's own is shown whole, without a complaint or a request", { skip }, () =>
  withFolder(async (folder) => {
    const url = makePage(folder);
    await withUrl(url, { width: 1400 }, async (page, noticed) => {
      await bring(page, "#answer canvas");
      const height = await page.evaluate(() => document.documentElement.scrollHeight);
      assert.ok(height <= 6 * SCREEN, `${height} pixels`);
      for (const id of ["precision", "atlas", "compare"]) await bring(page, `#${id} .plot`);
      for (const id of ["answer", "gallery"]) await bring(page, `#${id} canvas`);
      assert.deepEqual(noticed, { console: [], requests: [] });
      const figures = await page.$$eval("td, dd, svg text", (all) => all.map((one) => one.textContent));
      assert.ok(figures.length > 100);
      for (const figure of figures) assert.doesNotMatch(figure, /undefined|\[object|^-?NaN|Infinity/);
    });
  }),
);

test("a scene's lines are packed as the made-up data are, and shown", { skip }, () =>
  withFolder(async (folder) => {
    const lines = withShapedWalls(playbackLines({ bodies: 30, frames: 11 }));
    mkdirSync(join(folder, "pile"));
    writeFileSync(join(folder, "pile", "playback.jsonl"), lines.map((line) => `${JSON.stringify(line)}\n`).join(""));
    run(folder, "plumb", "report", "pile", "-o", "page.html");
    const { playbacks } = JSON.parse(readFileSync(join(folder, "page.json"), "utf8"));
    assert.deepEqual(playbacks, [{ ...playbackOf(lines), folder: "pile" }]);
    await withUrl(pathToFileURL(join(folder, "page.html")).href, {}, async (page, noticed) => {
      await bring(page, "#playback canvas");
      await bring(page, "#playback .plot");
      assert.deepEqual(noticed, { console: [], requests: [] });
    });
  }),
);

test("a study's lines become the document that the made-up data are, and are shown alone", { skip }, () =>
  withFolder(async (folder) => {
    const lines = [...studyLines(), { kind: "interrupted" }];
    writeFileSync(join(folder, "study.jsonl"), lines.map((line) => `${JSON.stringify(line)}\n`).join(""));
    run(folder, "plumb", "report", "--study", "study.jsonl", "-o", "page.html");
    assert.deepEqual(JSON.parse(readFileSync(join(folder, "page.json"), "utf8")).study, studyOf(lines));
    await withUrl(pathToFileURL(join(folder, "page.html")).href, {}, async (page, noticed) => {
      for (const id of ["study-angles", "study-maps", "study-limits"]) await bring(page, `#${id} .plot`);
      assert.match(await page.$eval('[role="alert"]', (alarm) => alarm.textContent), /study is incomplete/);
      assert.deepEqual(noticed, { console: [], requests: [] });
    });
  }),
);

test("the lines of finite elements become the document that the made-up data are, and are shown alone", { skip }, () =>
  withFolder(async (folder) => {
    const lines = [...femLines(), { kind: "interrupted" }];
    writeFileSync(join(folder, "fem.jsonl"), lines.map((line) => `${JSON.stringify(line)}\n`).join(""));
    run(folder, "plumb", "report", "--fem", "fem.jsonl", "-o", "page.html");
    assert.deepEqual(JSON.parse(readFileSync(join(folder, "page.json"), "utf8")).fem, femOf(lines));
    await withUrl(pathToFileURL(join(folder, "page.html")).href, {}, async (page, noticed) => {
      await bring(page, "#fem-angles .plot");
      assert.match(await page.$eval('[role="alert"]', (alarm) => alarm.textContent), /element study is incomplete/);
      assert.deepEqual(noticed, { console: [], requests: [] });
    });
  }),
);
