// The finite elements in Chromium: what is shown is what the document holds, and what is asked and does not hold is marked.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { bring } from "./support/browser.mjs";
import { makeFem, makeFemReport } from "./support/fixture-fem.mjs";
import { withPage as withReport } from "./support/tab.mjs";

const fem = makeFem();
const METHODS = 5;

const withPage = (shown, use) => withReport(makeFemReport(shown), {}, use);

const textsOf = (page, selector) =>
  page.$$eval(selector, (all) => all.map((one) => one.textContent.replaceAll("\u200b", "")));

/** The texts of the rows of the table whose caption fits. */
async function rowsOf(page, pattern) {
  const tables = await page.$$eval("#fem table", (all) =>
    all.map((one) => ({
      caption: one.caption.textContent,
      rows: [...one.tBodies[0].rows].map((row) => row.textContent),
    })),
  );
  return tables.find(({ caption }) => pattern.test(caption)).rows;
}

test("a page of the finite elements alone has its section, the machine's, and nothing of campaigns", () =>
  withPage(fem, async (page, noticed) => {
    assert.deepEqual(await textsOf(page, "nav a"), ["Elements", "Machine"]);
    const top = await page.$eval("header", (header) => header.textContent);
    assert.match(top, /finite elements: 5 geometries, 20 answers, quick mode, commit 0fe0fe0/);
    assert.equal(await page.$('[role="alert"]'), null);
    await bring(page, "#fem-angles .plot");
    assert.deepEqual(noticed, { console: [], requests: [] });
  }));

test("the plot has a mark for each geometry and method, which names it, and a box that hides the method", () =>
  withPage(fem, async (page) => {
    const box = await bring(page, "#fem-angles .plot");
    const traces = () =>
      box.evaluate((plot) =>
        plot.querySelector(".js-plotly-plot").data.map(({ x, y, hovertext }) => [x.length, y.length, hovertext[4]]),
      );
    const drawn = await traces();
    assert.equal(drawn.length, METHODS);
    for (const [x, y, words] of drawn) {
      assert.deepEqual([x, y], [fem.answers.length, fem.answers.length]);
      assert.match(words, /S02/);
    }
    assert.match(await box.evaluate((plot) => plot.ariaLabel), /original_cn from .* to /);
    await page.click("#fem-angles .legend input");
    assert.equal((await traces()).length, METHODS - 1);
  }));

test("what is asked is counted, and each answer of which it does not hold is marked, in words as well", () =>
  withPage(fem, async (page) => {
    const [first, second, third] = await textsOf(page, "#fem .fem-asked li");
    assert.match(first, /ratios up to 0.005 .* less than 0.2° from CN: in ✗ fails: 9 of 10 answers/);
    assert.match(second, /above 0.005 up to 0.02 .* less than 1° from CN: in 10 of 10 answers/);
    assert.match(third, /more than 5° from CN, or has no answer, .* 5 times .*: in ✗ fails: 14 of 16 answers/);
    const rows = await rowsOf(page, /^Angle between the force .* patch radii/);
    assert.equal(rows.length, fem.answers.length);
    assert.deepEqual(
      rows.filter((row) => row.includes("fails: ")).map((row) => row.slice(0, 3)),
      ["E01", "Q01", "S02"],
    );
    assert.ok(rows.every((row) => row.includes("centre 0.")));
    assert.equal(rows.filter((row) => row.includes("—")).length, 5);
  }));

test("what it does not show stands beside it, with how the bodies are held", () =>
  withPage(fem, async (page) => {
    const [expected, magnitudes, leaves] = await textsOf(page, "#fem .fem-limits li");
    assert.match(expected, /expected from mechanics.*error of GP, which stays/);
    assert.match(magnitudes, /depends on how the bodies are held \(here: the far half of each body\)/);
    assert.match(leaves, /where the curvature changes across the patch/);
    assert.match(await page.$eval("#fem .facts", (list) => list.textContent), /Held.*far half.*ccx2\.20.*gmsh4\.8\.4/);
  }));

test("checks, convergence and half-spaces have a row each; a check above its limit is marked", () =>
  withPage(fem, async (page) => {
    const checks = await rowsOf(page, /^2 of 3 within their limits/);
    assert.deepEqual(
      checks.map((row) => row.includes("fails: ")),
      fem.checks.map(({ within }) => !within),
    );
    const convergence = await rowsOf(page, /^One setting changed/);
    assert.equal(convergence.length, fem.convergence.length);
    assert.match(convergence.at(-1), /held.*the far quarter.*-426.5/);
    const halfSpaces = await rowsOf(page, /^Where the plane ends/);
    assert.equal(halfSpaces.length, fem.half_space.length);
    assert.match(halfSpaces.join("\n"), /^S010.002GP8.*2e-50.970.0450.920.031.2$/m);
    assert.match(halfSpaces.join("\n"), /^Q01.*2e-5—0.045——4$/m);
    const unanswered = await textsOf(page, "#fem .fem-unanswered li");
    assert.deepEqual(unanswered, ["S02 at 0.01, convergence (penalty, 1000): did not converge"]);
  }));

test("each run and the geometries unfold", () =>
  withPage(fem, async (page) => {
    for (const summary of await page.$$("#fem > details > summary")) await summary.evaluate((one) => one.click());
    await page.waitForFunction(() => document.querySelectorAll("#fem > details table").length === 2);
    assert.equal((await rowsOf(page, /^Each run/)).length, fem.answers.length);
    const geometries = await rowsOf(page, /^The geometries/);
    assert.match(geometries[0], /^S01spheroidboth 1 × 1 × 2/);
    assert.match(geometries[3], /^E01ellipsoidboth 1 × 1.5 × 2/);
    assert.match(geometries[4], /superquadric1 × 1.2 × 1, exponents 4 and 3; 1 × 1 × 1.5, exponents 4 and 3/);
  }));

const nothing = { geometries: [], checks: [], convergence: [], answers: [], half_space: [], unanswered: [] };

test("an interrupted study says so, and one without answers has no figure", () =>
  withPage({ ...fem, ...nothing, checks: fem.checks, interrupted: true }, async (page, noticed) => {
    assert.match(await page.$eval('[role="alert"]', (alarm) => alarm.textContent), /element study is incomplete/);
    assert.match(await page.$eval("#fem .empty", (note) => note.textContent), /no answer/);
    assert.equal(await page.$("#fem .plot"), null);
    assert.equal((await page.$$("#fem table")).length, 1);
    assert.deepEqual(noticed, { console: [], requests: [] });
  }));
