// For every reader: a screen reader, a phone, paper, a page from someone else's data, a page with little in it.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { test } from "node:test";
import { bring, SCREEN } from "./support/browser.mjs";
import { makeReport } from "./support/fixture.mjs";
import { makeFem } from "./support/fixture-fem.mjs";
import { makePlayback } from "./support/fixture-playback.mjs";
import { makeStudy } from "./support/fixture-study.mjs";
import { views, withPage } from "./support/tab.mjs";

const axe = await readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

const small = (options) => makeReport({ failures: 8, cases: 1000, ...options });
const scenes = () => [makePlayback({ bodies: 8, frames: 5 }), makePlayback({ name: "cut", frames: 5, ended: false })];
const whole = () => ({ second: true, playbacks: scenes(), study: makeStudy(), fem: makeFem() });

for (const { width, dark } of views)
  test(`axe finds nothing, ${width} pixels, ${dark ? "dark" : "light"}`, () =>
    withPage(small(whole()), { width, dark }, async (page) => {
      await page.evaluate(() => {
        for (const closed of document.querySelectorAll("details")) closed.open = true;
      });
      await bring(page, "#precision .plot");
      await bring(page, "#study .plot");
      await bring(page, "#fem .plot");
      await bring(page, "#answer canvas");
      await bring(page, "#gallery canvas");
      await bring(page, "#playback canvas");
      await page.evaluate(axe);
      const found = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
      assert.deepEqual(
        found.violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 160)).slice(0, 5)}`),
        [],
      );
    }));

for (const width of [400, 1400])
  test(`nothing is wider than a page of ${width} pixels`, () =>
    withPage(small(whole()), { width }, async (page) => {
      await page.evaluate(() => {
        for (const closed of document.querySelectorAll("details")) closed.open = true;
      });
      const { scroll, client } = await page.evaluate(() => ({
        scroll: document.documentElement.scrollWidth,
        client: document.documentElement.clientWidth,
      }));
      assert.ok(scroll <= client, `${scroll} > ${client}`);
    }));

for (const width of [400, 1400])
  for (const dark of [false, true])
    test(`a page of ${width} pixels opens short and whole, ${dark ? "dark" : "light"}`, () =>
      withPage(makeReport({ second: true, ...whole() }), { width, dark }, async (page, noticed) => {
        await bring(page, "#answer canvas");
        const seen = await page.evaluate(() => ({
          height: document.documentElement.scrollHeight,
          open: [...document.querySelectorAll(".fold")].filter((fold) => fold.open).length,
          h1: document.querySelector("h1").textContent,
          sentences: document.querySelectorAll("#answer .sentences p").length,
          out: [...document.querySelectorAll("nav a, .bar select, .bar button, #answer *, #gallery .card *")]
            .filter((part) => part.checkVisibility() && !part.closest("pre, .scroll, .unseen"))
            .filter((part) => part.getBoundingClientRect().right > innerWidth + 1)
            .map((part) => part.outerHTML.slice(0, 80)),
          cut: [...document.querySelectorAll("#answer :is(p, span), #gallery .card :is(p, dd, h3)")]
            .filter((part) => part.checkVisibility() && part.clientWidth > 0 && part.scrollWidth > part.clientWidth + 1)
            .map((part) => part.outerHTML.slice(0, 80)),
        }));
        assert.deepEqual({ open: seen.open, out: seen.out, cut: seen.cut }, { open: 0, out: [], cut: [] });
        assert.match(seen.h1, /^\d+ of \d+ solvers give wrong answers/);
        assert.equal(seen.sentences, 3);
        if (width === 1400) assert.ok(seen.height <= 6 * SCREEN, `${seen.height} pixels`);
        assert.deepEqual(noticed, { console: [], requests: [] });
      }));

const HOSTILE = '</script><script>window.hurt=1</script><img src=x onerror="window.hurt=2"><!--<script>';

const PACKED = [
  "positions",
  "orientations",
  "wall_points",
  "wall_orientations",
  "triangles",
  "boxes",
  "pairs",
  "points",
  "normals",
  "forces",
];

/** Every text and every name of an energy, a share or an angle of the document, but its format and what is looked up by name. */
function poisoned(value, key = "") {
  const kept = [
    "format",
    "verdict",
    "measure",
    "unit",
    "map",
    "kept",
    "scalar",
    "problem",
    "certificate",
    "word",
    ...PACKED,
  ];
  if (typeof value === "string") return kept.includes(key) ? value : `${value}${HOSTILE}`;
  if (Array.isArray(value)) return value.map((item) => poisoned(item, typeof item === "string" ? key : ""));
  if (value === null || typeof value !== "object") return value;
  const isNamed = ["energy", "shares", "angles_deg", "centre_off"].includes(key);
  return Object.fromEntries(
    Object.entries(value).map(([name, item]) => [isNamed ? `${name}${HOSTILE}` : name, poisoned(item, name)]),
  );
}

test("hostile words in the data are words", () =>
  withPage(poisoned(small({ ...whole(), harnessErrors: { [`failed ${HOSTILE}`]: 2 } })), {}, async (page, noticed) => {
    for (const id of ["precision", "atlas", "playback", "compare"]) await bring(page, `#${id} .plot`);
    for (const id of ["study-angles", "study-maps", "study-limits", "fem-angles"]) await bring(page, `#${id} .plot`);
    for (const id of ["gallery", "playback"]) await bring(page, `#${id} canvas`);
    await page.evaluate(() => {
      for (const closed of document.querySelectorAll("details")) closed.open = true;
    });
    assert.equal(await page.evaluate(() => window.hurt), undefined);
    assert.equal(await page.$("#page img"), null);
    assert.equal(await page.$("#page script"), null);
    assert.match(await page.$eval("header", (top) => top.textContent), /onerror/);
    assert.deepEqual(noticed, { console: [], requests: [] });
  }));

test("an incomplete run and errors of the harness are announced", () =>
  withPage(small({ incomplete: true, harnessErrors: { "reference beaten": 3 } }), {}, async (page) => {
    const alarm = await page.$eval('[role="alert"]', (element) => element.textContent);
    assert.match(alarm, /incomplete/);
    assert.match(alarm, /reference beaten \(3 times\)/);
  }));

test("a run without failures, precision or a second run says so", () =>
  withPage(small({ failures: 0, precision: false }), {}, async (page, noticed) => {
    assert.match(await page.$eval("#gallery .empty", (note) => note.textContent), /kept no failure/);
    for (const id of ["precision", "compare"]) assert.equal(await page.$(`#${id}`), null);
    assert.equal(await page.$("#answer canvas"), null);
    assert.deepEqual(noticed, { console: [], requests: [] });
  }));

test("a run without ladders says so beside one that has them, and alone has no section for them", async () => {
  const report = small({ second: true, stability: false, precision: false });
  report.runs.at(-1).ladders = [];
  await withPage(report, {}, async (page) => {
    assert.match(await page.$eval("#ladders .empty", (note) => note.textContent), /holds no ladders/);
    await page.select("#run-choice select", "0");
    assert.ok((await page.$$("#ladders .ladder")).length > 0);
  });
  report.runs[0].ladders = [];
  await withPage(report, {}, async (page, noticed) => {
    assert.equal(await page.$("#ladders"), null);
    assert.equal(await page.$('nav a[href="#ladders"]'), null);
    assert.deepEqual(noticed, { console: [], requests: [] });
  });
});

test("two runs with nothing in common say so", () => {
  const report = small({ second: true, precision: false });
  report.comparisons[0].rows = [];
  return withPage(report, {}, async (page, noticed) => {
    assert.match(await page.$eval("#compare", (part) => part.textContent), /nothing to compare/);
    assert.deepEqual(noticed, { console: [], requests: [] });
  });
});

test("a run of nothing at all", () =>
  withPage(makeReport({ cases: 0, failures: 0, families: [], precision: false }), {}, async (_page, noticed) => {
    assert.deepEqual(noticed, { console: [], requests: [] });
  }));

test("answers that could not be solved anew are shown without them", () => {
  const report = small({ precision: false });
  for (const failure of report.runs[0].failures)
    Object.assign(failure, {
      answer: null,
      reference: null,
      reason: "the peer is not installed",
      severity: "infinite",
      shrunk: undefined,
    });
  return withPage(report, {}, async (page, noticed) => {
    await bring(page, "#gallery canvas");
    await page.$eval("#gallery .card details summary", (summary) => summary.click());
    const note = await page.waitForSelector("#gallery .card details .note");
    assert.match(await note.evaluate((line) => line.textContent), /the peer is not installed/);
    assert.deepEqual(noticed, { console: [], requests: [] });
  });
});

test("paper is light, with everything open", () =>
  withPage(small({ study: makeStudy(), fem: makeFem() }), { dark: true }, async (page) => {
    await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
    const state = await page.evaluate(() => ({
      closed: document.querySelectorAll("details:not([open]):not([data-print=closed])").length,
      undrawn: document.querySelectorAll(".plot:not([data-drawn])").length,
      ink: document.querySelector("#study .plot text").style.fill,
    }));
    assert.deepEqual(state, { closed: 0, undrawn: 0, ink: "rgb(28, 33, 39)" });
  }));
