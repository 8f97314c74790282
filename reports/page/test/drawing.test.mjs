// The page in Chromium: quiet, drawn, reacting.
import assert from "node:assert/strict";
import { test } from "node:test";
import { bring } from "./support/browser.mjs";
import { makeReport } from "./support/fixture.mjs";
import { makeFem } from "./support/fixture-fem.mjs";
import { makePlayback } from "./support/fixture-playback.mjs";
import { makeStudy } from "./support/fixture-study.mjs";
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
    for (const id of ["precision", "atlas", "compare"]) await bring(page, `#${id} .plot`);
    for (const id of ["answer", "gallery"]) await bring(page, `#${id} canvas`);
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

test("every solver has its bar, its share and its words at the required accuracy, and nothing unjudged is green", () => {
  const report = makeReport({ failures: 8 });
  const [run] = report.runs;
  Object.assign(run.totals[3], { answers: 7, judged: 0, unjudged: 7, findings: {}, right: {} });
  return withReport(report, {}, async (page) => {
    const shown = () =>
      page.$$eval("#answer .solvers li", (all) =>
        all.map((one) => ({
          name: one.querySelector(".method").textContent.replaceAll("\u200b", ""),
          words: one.querySelector(".words").textContent.replace(/\s/g, ""),
          share: one.querySelector(".much").textContent,
          green: one.querySelector(".shares .right")?.style.flexGrow ?? "0",
        })),
      );
    for (const level of ["0.01deg", "rounding", "1e-6rad", "1deg"]) {
      await page.select("#accuracy select", level);
      const rows = await shown();
      assert.equal(rows.length, run.totals.length);
      for (const total of run.totals) {
        const row = rows.find(({ name }) => name.startsWith(total.method) && name.length < total.method.length + 8);
        const right = total.right[level]?.count ?? 0;
        assert.equal(row.green, String(right));
        if (total.judged > 0) assert.ok(row.words.startsWith(`rightin${right}of${total.judged}`), row.words);
        else assert.match(`${row.share} ${row.words}`, /^not judged noneof7answersjudged/);
      }
    }
  });
});

test("the opening figure turns until it is stopped, and stands still for who asked for that", async () => {
  const moving = async (page) => {
    const canvas = await bring(page, "#answer canvas");
    const before = await pixels(canvas);
    return [canvas, before];
  };
  await withReport(makeReport({ failures: 60 }), { moves: true }, async (page, noticed) => {
    const [canvas, before] = await moving(page);
    await repainted(page, canvas, before);
    await page.$eval("#answer .view-bar button", (button) => button.click());
    const stopped = await pixels(canvas);
    await new Promise((done) => setTimeout(done, 600));
    assert.equal(await pixels(canvas), stopped);
    assert.deepEqual(noticed, { console: [], requests: [] });
  });
  await withReport(makeReport({ failures: 60 }), {}, async (page) => {
    const [canvas, before] = await moving(page);
    await new Promise((done) => setTimeout(done, 600));
    assert.equal(await pixels(canvas), before);
    assert.equal(await page.$eval("#answer .view-bar button", (button) => button.textContent), "Turn");
  });
});

test("a link of the navigation opens the section that it leads to", () =>
  withPage(async (page) => {
    const links = await page.$$eval("nav a", (all) => all.map((link) => link.hash));
    for (const hash of links) {
      await page.$eval(`nav a[href="${hash}"]`, (link) => link.click());
      assert.equal(
        await page.$eval(hash, (part) => part.querySelector(":scope > details:not([open])") !== null),
        false,
      );
    }
  }));

test("one click from any figure of the campaign to the command that makes it", () =>
  withPage(async (page) => {
    await page.evaluate(() => {
      for (const fold of document.querySelectorAll(".fold")) fold.open = true;
    });
    for (const part of ["#answer", "#families .family", "#atlas", "#ladders"]) {
      await page.$eval(`${part} .made summary`, (summary) => summary.click());
      const code = await page.waitForSelector(`${part} .made code`);
      assert.match(await code.evaluate((text) => text.textContent), /^plumb campaign --family/);
    }
    const cards = await page.$$eval("#gallery .card", (all) =>
      all.map((card) => card.querySelector(".command code").textContent),
    );
    for (const text of cards) assert.match(text, /^plumb replay /);
  }));

test("one click from the figures of the other sections to theirs", () => {
  const others = { study: makeStudy(), fem: makeFem(), playbacks: [makePlayback({ bodies: 8, frames: 5 })] };
  const report = makeReport({ second: true, failures: 8, cases: 1000, ...others });
  return withReport(report, {}, async (page) => {
    await page.evaluate(() => {
      for (const fold of document.querySelectorAll(".fold, .made")) fold.open = true;
    });
    const commandsIn = (id) =>
      page.$$eval(`${id} .made`, (all) => all.map((one) => one.querySelector("code")?.textContent ?? "none"));
    const made = {
      "#compare": /^plumb campaign /,
      "#precision": /^plumb report-precision /,
      "#playback": /^plumb scene /,
    };
    for (const [id, pattern] of Object.entries({
      ...made,
      "#study": report.study.command,
      "#fem": report.fem.command,
    })) {
      await page.waitForSelector(`${id} .made code`);
      const commands = await commandsIn(id);
      for (const text of commands)
        typeof pattern === "string" ? assert.equal(text, pattern) : assert.match(text, pattern);
    }
    for (const id of ["#study", "#fem"]) assert.ok((await commandsIn(id)).length >= 5, id);
  });
});

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

test("plumb's own failures come first, refusals last and folded", () =>
  withPage(async (page) => {
    const own = await page.$$eval("#gallery .card", (cards) => cards.map((card) => card.classList.contains("is-own")));
    assert.ok(own[0]);
    const first = own.indexOf(false);
    assert.ok(first > 0);
    const found = (part) =>
      page.$$eval(`${part} .finding`, (all) => all.map((finding) => finding.textContent === "nonconverged"));
    assert.ok((await found("#gallery .refusals")).every((refused) => refused));
    assert.ok((await found("#gallery > div > div")).every((refused) => !refused));
    assert.equal(await page.$eval("#gallery .refusals", (fold) => fold.open), false);
  }));

test("at a coarser accuracy more failures are set apart as right, and the filter stays", () =>
  withPage(async (page) => {
    const apart = () =>
      page.$eval("#gallery .right-enough", (fold) => ({
        open: fold.open,
        count: fold.hidden ? 0 : Number.parseInt(fold.querySelector("summary").textContent, 10),
      }));
    const counts = [];
    for (const level of ["rounding", "1e-6rad", "0.01deg", "1deg"]) {
      await page.select("#accuracy select", level);
      counts.push((await apart()).count);
    }
    assert.equal(counts[0], 0);
    assert.deepEqual(
      counts,
      [...new Set(counts)].sort((a, b) => a - b),
    );
    assert.equal((await apart()).open, false);
    await page.click("#gallery .controls input[type=checkbox]");
    const cards = () => page.$$eval("#gallery .card", (all) => all.map((card) => card.classList.contains("is-own")));
    await page.select("#accuracy select", "0.01deg");
    assert.ok((await cards()).every((own) => own));
  }));

test("two runs show the planted regression at the top, as worse", () =>
  withPage(async (page) => {
    const top = await page.$eval("#compare tbody tr", (row) => row.textContent);
    assert.match(top, /worse/);
    assert.match(top, /auto/);
    assert.match(top, /misaligned/);
    await page.select("#run-choice select", "1");
    const [auto] = makeReport({ second: true, failures: 60 }).runs[1].totals;
    const words = await page.$eval("#answer .is-own .words", (line) => line.textContent.replace(/\s/g, ""));
    assert.ok(words.startsWith(`rightin${auto.right["0.01deg"].count}of${auto.judged}`), words);
  }));

test("the theme's button changes the colours, in the plots as well", () =>
  withPage(async (page) => {
    const colours = () =>
      page.evaluate(() => [
        getComputedStyle(document.body).backgroundColor,
        document.querySelector("#atlas .plot text").style.fill,
      ]);
    await bring(page, "#atlas .plot");
    const light = await colours();
    await page.click("#theme");
    const dark = await colours();
    assert.notEqual(dark[0], light[0]);
    assert.notEqual(dark[1], light[1]);
  }));
