// The source's study in Chromium: what is shown is what the document holds, and what fails is marked.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { bring } from "./support/browser.mjs";
import { makeStudy, makeStudyReport } from "./support/fixture-study.mjs";
import { withPage as withReport } from "./support/tab.mjs";

const study = makeStudy();

const withPage = (shown, use, options) => withReport(makeStudyReport(shown), options, use);

const plain = (text) => text.replaceAll("\u200b", "");
const textsOf = (element, selector) =>
  element.$$eval(selector, (all) => all.map((one) => one.textContent.replaceAll("\u200b", "")));

/** Its table, which is built when it is opened. */
async function opened(page, index) {
  const group = (await page.$$("#study .study-group"))[index];
  await group.evaluate((element) => {
    element.open = true;
  });
  await group.waitForSelector("table");
  return group;
}

test("a page of the study alone has its section, the machine's, and nothing of campaigns", () =>
  withPage(study, async (page, noticed) => {
    assert.deepEqual(await textsOf(page, "nav a"), ["Study", "Machine"]);
    assert.match(await page.$eval("header", (top) => top.textContent), /study: 8 groups of pairs, commit 24cec56/);
    assert.equal(await page.$(".notice"), null);
    for (const id of ["study-angles", "study-maps", "study-limits"]) await bring(page, `#${id} .plot`);
    assert.deepEqual(noticed, { console: [], requests: [] });
  }));

test("a group's table has every answer, and marks each residue and angle that fails, in words as well", () =>
  withPage(study, async (page) => {
    const index = study.groups.findIndex(({ group }) => group === "G3");
    const { answers } = study.groups[index];
    const group = await opened(page, index);
    assert.equal((await group.$$("tbody tr")).length, answers.length);
    const limit = Math.sin((0.01 * Math.PI) / 180);
    const failing = answers.flatMap(({ residues, angles_deg, off_deg }) => [
      ...(residues ?? []).filter((residue) => Math.abs(residue) > limit),
      ...[...(angles_deg ?? []), off_deg ?? 0].filter((deg) => deg > 0.01),
    ]);
    const marks = await textsOf(group, "td .flag.wrong");
    assert.equal(marks.length, failing.length);
    assert.ok(marks.every((mark) => /^✗ fails: /.test(mark)));
    const unproved = answers.filter(({ certified }) => !certified).length;
    assert.ok(unproved > 0);
    assert.equal((await textsOf(group, "td small")).filter((text) => text === "not proved").length, unproved);
    assert.deepEqual(await textsOf(group, "td .flag.lost"), ["no_convergence"]);
  }));

test("a group's heading counts its answers that are off, and its points unfold", () =>
  withPage(study, async (page) => {
    const [{ answers }] = study.groups;
    const off = answers.filter(({ off_deg }) => off_deg > 0.01).length;
    const group = await opened(page, 0);
    const heading = await group.$eval("summary", (summary) => summary.textContent);
    assert.match(heading, new RegExp(`^G1: spheroid, aspect 2.5; the signs fail; ${off} of ${answers.length} answers`));
    await group.$eval("details summary", (summary) => summary.click());
    await group.waitForSelector("details table");
    assert.equal((await group.$$("details tbody tr")).length, answers.length);
  }));

test("the angles have a panel for each group and a line for each method, which its box hides", () =>
  withPage(study, async (page) => {
    const box = await bring(page, "#study-angles .plot");
    const lines = () => box.evaluate((plot) => plot.querySelector(".js-plotly-plot").data.length);
    assert.equal((await page.$$("#study-angles .plot")).length, study.groups.length);
    assert.equal(await lines(), 8);
    await page.click("#study-angles .legend input");
    assert.equal(await lines(), 7);
  }));

test("panels side by side have one scale", () =>
  withPage(study, async (page) => {
    const ranges = [];
    for (const box of (await page.$$("#study-angles .plot")).slice(0, 3)) {
      await box.evaluate((element) => element.scrollIntoView());
      await page.waitForFunction((element) => element.dataset.drawn, {}, box);
      ranges.push(await box.evaluate((plot) => plot.querySelector(".js-plotly-plot")._fullLayout.yaxis.range.join()));
    }
    assert.equal(new Set(ranges).size, 1);
  }));

test("the maps follow the three choices, and cells without an answer are crossed", () =>
  withPage(study, async (page) => {
    const chosen = study.maps.filter(({ aspect, ratio }) => aspect === 2 && ratio === 0.01);
    const [aspect, , ratio] = await page.$$("#study-maps select");
    await aspect.select("2");
    await ratio.select("0.01");
    const names = await textsOf(page, "#study-maps figcaption");
    assert.deepEqual([...names].sort(), chosen.map(({ method }) => method).sort());
    const place = names.indexOf("first_touch");
    const box = (await page.$$("#study-maps .plot"))[place];
    await box.evaluate((element) => element.scrollIntoView());
    await page.waitForFunction((element) => element.dataset.drawn, {}, box);
    const [cells, crosses] = await box.evaluate((plot) =>
      plot.querySelector(".js-plotly-plot").data.map(({ z, x }) => (z ? z.length : x.length)),
    );
    const { theta_L_deg, off_deg } = chosen.find(({ method }) => method === "first_touch");
    assert.equal(cells, theta_L_deg.length);
    assert.equal(crosses, off_deg.flat().filter((deg) => deg === null).length);
    assert.ok(crosses > 0);
  }));

test("a map's table has its numbers, in rows by theta_L", () =>
  withPage(study, async (page) => {
    await page.$eval("#study-maps figure details summary", (summary) => summary.click());
    await page.waitForSelector("#study-maps figure table");
    const [map] = study.maps.filter(({ method }) => method === "auto");
    assert.equal((await page.$$("#study-maps figure tbody tr")).length, map.theta_L_deg.length);
    assert.equal((await page.$$("#study-maps figure tbody td")).length, map.off_deg.flat().length);
  }));

test("a choice without a map says so", () => {
  const few = { ...study, maps: study.maps.filter(({ aspect, ratio }) => aspect === 2 || ratio === 0.01) };
  return withPage(few, async (page) => {
    const [aspect, , ratio] = await page.$$("#study-maps select");
    await aspect.select("1.5");
    await ratio.select("0.001");
    assert.match(await page.$eval("#study-maps .empty", (note) => note.textContent), /no map/);
  });
});

test("the limits have a panel for each sweep and shape, and show the difference that is chosen", () =>
  withPage(study, async (page) => {
    const sweeps = new Set(study.limits.map(({ sweep, shape }) => `${sweep} ${shape}`));
    const box = await bring(page, "#study-limits .plot");
    assert.equal((await page.$$("#study-limits .plot")).length, sweeps.size);
    const title = () => box.evaluate((plot) => plot.querySelector(".js-plotly-plot")._fullLayout.yaxis.title.text);
    assert.equal(await title(), "angle, °");
    await page.select("#study-limits select", "overlap");
    assert.equal(await title(), "overlap, relative");
    assert.match(await box.evaluate((plot) => plot.ariaLabel), /median difference of the overlap/);
  }));

test("solutions, orders, shares and costs have a row each", () =>
  withPage(study, async (page) => {
    await page.$$eval("#study .study-pair", (all) => {
      for (const pair of all) pair.open = true;
    });
    await page.waitForFunction(() => document.querySelectorAll("#study .study-pair:not(:has(table))").length === 0);
    const tables = await page.$$eval("#study table", (all) =>
      all.map((one) => ({ caption: one.caption.textContent, rows: one.tBodies[0].rows.length })),
    );
    const rowsOf = (pattern) => tables.filter(({ caption }) => pattern.test(caption)).map(({ rows }) => rows);
    assert.deepEqual(
      rowsOf(/real solutions/),
      study.roots.map(({ roots }) => roots.length),
    );
    assert.deepEqual(rowsOf(/^The power of the overlap ratio/), [study.orders.length]);
    assert.deepEqual(rowsOf(/random pairs/), [4]);
    assert.deepEqual(rowsOf(/cheapest tolerance/), [8, 8]);
    const captions = tables.map(({ caption }) => plain(caption)).join();
    assert.match(captions, /3 real solutions, not all may be here: a box was left/);
  }));

const KINDS = ["groups", "maps", "shares", "limits", "orders", "costs", "roots"];
const nothing = Object.fromEntries(KINDS.map((kind) => [kind, []]));

for (const kind of KINDS)
  test(`a study of ${kind} alone`, () =>
    withPage({ ...study, ...nothing, [kind]: study[kind] }, async (page, noticed) => {
      if (await page.$("#study .plot")) await bring(page, "#study .plot");
      assert.equal((await page.$$("#study h3")).length, kind === "groups" ? 2 : 1);
      assert.deepEqual(noticed, { console: [], requests: [] });
    }));

test("a group that holds no answers has no figure, and methods that found none are in the gutter", () => {
  const none = { points: null, residues: null, angles_deg: null, off_deg: null };
  const [first, second] = study.groups;
  const lost = { ...first, answers: first.answers.map((answer) => ({ ...answer, ...none })) };
  return withPage({ ...study, ...nothing, groups: [lost, { ...second, answers: [] }] }, async (page, noticed) => {
    const box = await bring(page, "#study-angles .plot");
    assert.equal((await page.$$("#study-angles .plot")).length, 1);
    assert.match(await box.evaluate((plot) => plot.ariaLabel), /original_cn no answer/);
    assert.deepEqual(noticed, { console: [], requests: [] });
  });
});
