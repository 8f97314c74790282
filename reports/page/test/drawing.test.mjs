// The page in Chromium: quiet, drawn, reacting.
import assert from "node:assert/strict";
import { test } from "node:test";
import { bring } from "./support/browser.mjs";
import { makeReport } from "./support/fixture.mjs";
import { withPage as withReport } from "./support/tab.mjs";

const withPage = (use) => withReport(makeReport({ second: true, failures: 60 }), {}, use);

/** The middle of a marker of the first trace that has customdata. */
async function middleOf(page, selector) {
  const marker = await page.waitForSelector(selector);
  return marker.evaluate((found) => {
    const { x, y, width, height } = found.getBoundingClientRect();
    return { x: x + width / 2, y: y + height / 2 };
  });
}

const pixels = (canvas) => canvas.evaluate((element) => element.toDataURL());

/** The picture once it is no longer that one: a frame may pass first. */
async function repainted(page, canvas, before) {
  await page.waitForFunction((element, old) => element.toDataURL() !== old, { timeout: 10000 }, canvas, before);
  return pixels(canvas);
}

test("asks for nothing and complains of nothing, from top to bottom", () =>
  withPage(async (page, noticed) => {
    for (const id of ["summary", "precision", "atlas", "compare"]) await bring(page, `#${id} .plot`);
    await bring(page, "#gallery canvas");
    assert.deepEqual(noticed, { console: [], requests: [] });
  }));

test("a point names its method, tolerance and command, and keeps the command when it is clicked", () =>
  withPage(async (page) => {
    await bring(page, "#precision .plot");
    const point = "#precision .plot .scatterlayer .trace:nth-child(8) .points path:nth-child(4)";
    const at = await middleOf(page, point);
    await page.mouse.move(at.x, at.y);
    await page.waitForSelector("#precision .hoverlayer .hovertext");
    const label = await page.$eval("#precision .hoverlayer", (layer) => layer.textContent);
    assert.match(label, /tolerance/);
    assert.match(label, /plumb report-precision/);
    // What is drawn above may push the plot away between the look and the click: then once more.
    let kept = null;
    for (let tries = 0; tries < 10 && !kept; ++tries) {
      const { x, y } = await middleOf(page, point);
      await page.mouse.click(x, y);
      kept = await page.waitForSelector("#precision .pins .command code", { timeout: 3000 }).catch(() => null);
    }
    assert.ok(kept);
    assert.match(await kept.evaluate((code) => code.textContent), /^plumb report-precision --set spheroid/);
  }));

test("a drag zooms, and the button shows everything again", () =>
  withPage(async (page) => {
    const box = await bring(page, "#precision .plot");
    const range = () =>
      box.evaluate((plot) => plot.querySelector(".js-plotly-plot")._fullLayout.xaxis.range.map(Number));
    const whole = await range();
    const { x, y } = await box.evaluate((plot) => plot.querySelector(".nsewdrag").getBoundingClientRect().toJSON());
    await page.mouse.move(x + 200, y + 40);
    await page.mouse.down();
    await page.mouse.move(x + 500, y + 240, { steps: 5 });
    await page.mouse.up();
    await page.waitForFunction(
      (plot, before) => Math.abs(plot.querySelector(".js-plotly-plot")._fullLayout.xaxis.range[0] - before) > 0.1,
      {},
      box,
      whole[0],
    );
    const zoomed = await range();
    assert.ok(zoomed[1] - zoomed[0] < whole[1] - whole[0]);
    await page.click('#precision button[title="Reset the view"]');
    assert.deepEqual(await range(), whole);
  }));

test("a legend's entry hides its method", () =>
  withPage(async (page) => {
    const box = await bring(page, "#precision .plot");
    const traces = () => box.evaluate((plot) => plot.querySelector(".js-plotly-plot").data.length);
    const all = await traces();
    await page.click("#precision .legend input");
    assert.ok((await traces()) < all);
  }));

test("the gallery turns a body by drag and by arrow keys, and zooms to the overlap", () =>
  withPage(async (page) => {
    const canvas = await bring(page, "#gallery canvas");
    const first = await pixels(canvas);
    const { x, y, width, height } = await canvas.boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2 + 80, y + height / 2 + 20, { steps: 4 });
    await page.mouse.up();
    const dragged = await repainted(page, canvas, first);
    await canvas.focus();
    await page.keyboard.press("ArrowLeft");
    const turned = await repainted(page, canvas, dragged);
    await page.click('#gallery .view3d button[title^="Zoom to the overlap"]');
    await repainted(page, canvas, turned);
  }));

test("every method of the summary's figure has its name and its marker", () =>
  withPage(async (page) => {
    await bring(page, "#summary .plot");
    const [first] = makeReport({ second: true, failures: 60 }).runs.at(-1).families;
    const labels = await page.$$eval("#summary .yaxislayer-above .ytick text", (all) =>
      all.map((one) => one.textContent),
    );
    assert.deepEqual([...labels].sort(), first.methods.map(({ method }) => method).sort());
    const markers = await page.$$eval("#summary .plot .trace", (traces) =>
      traces.map((trace) => trace.querySelectorAll(".point").length),
    );
    const judged = first.methods.filter(({ failures }) => failures.share !== null).length;
    assert.equal(markers[0], judged);
  }));

test("a filter narrows the count and the cards", () =>
  withPage(async (page) => {
    const state = () =>
      page.evaluate(() => ({
        status: document.querySelector("#gallery .status").textContent,
        cards: document.querySelectorAll("#gallery .card").length,
        own: document.querySelectorAll("#gallery .card.is-own").length,
      }));
    const all = Number.parseInt((await state()).status, 10);
    assert.ok(all > 20);
    assert.ok((await state()).status.startsWith(`${all} of ${all} failures here`));
    await page.click("#gallery .controls input[type=checkbox]");
    const narrowed = await state();
    assert.equal(narrowed.cards, narrowed.own);
    assert.ok(narrowed.status.startsWith(`${narrowed.cards} of ${all}`));
    await page.type("#gallery input[type=search]", "no such word");
    assert.match((await state()).status, new RegExp(`^0 of ${all}`));
    assert.equal((await state()).cards, 0);
  }));

test("plumb's own failures come first", () =>
  withPage(async (page) => {
    const own = await page.$$eval("#gallery .card", (cards) => cards.map((card) => card.classList.contains("is-own")));
    assert.ok(own[0]);
    assert.deepEqual(
      own,
      [...own].sort((a, b) => Number(b) - Number(a)),
    );
  }));

test("two runs show the planted regression at the top, as worse", () =>
  withPage(async (page) => {
    const top = await page.$eval("#compare tbody tr", (row) => row.textContent);
    assert.match(top, /worse/);
    assert.match(top, /auto/);
    assert.match(top, /misaligned/);
    await page.select("#run-choice select", "1");
    const verdict = await page.$eval("#summary .verdict", (line) => line.textContent);
    assert.match(verdict, /3\.\d+ %/);
  }));

test("the theme's button changes the colours, in the plots as well", () =>
  withPage(async (page) => {
    const colours = () =>
      page.evaluate(() => [
        getComputedStyle(document.body).backgroundColor,
        document.querySelector("#summary .plot text").style.fill,
      ]);
    await page.waitForSelector("#summary .plot text");
    const light = await colours();
    await page.click("#theme");
    const dark = await colours();
    assert.notEqual(dark[0], light[0]);
    assert.notEqual(dark[1], light[1]);
  }));
