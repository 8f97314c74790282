// What plumb report itself writes, in Chromium: PLUMB_BIN is the folder of the programs; without it there is nothing to ask.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { bring, launch, open } from "./support/browser.mjs";
import { withFolder } from "./support/pages.mjs";

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

test("a report of plumb's own is shown whole, without a complaint or a request", { skip }, () =>
  withFolder(async (folder) => {
    const url = makePage(folder);
    const browser = await launch();
    try {
      const { page, noticed } = await open(browser, url);
      for (const id of ["summary", "precision", "atlas", "compare"]) await bring(page, `#${id} .plot`);
      await bring(page, "#gallery canvas");
      assert.deepEqual(noticed, { console: [], requests: [] });
      const figures = await page.$$eval("td, dd, svg text", (all) => all.map((one) => one.textContent));
      assert.ok(figures.length > 100);
      for (const figure of figures) assert.doesNotMatch(figure, /undefined|\[object|^-?NaN|Infinity/);
    } finally {
      await browser.close();
    }
  }),
);
