// node --test: the playground in Chromium, from disk. PLUMB_PLAYGROUND names the file, PLUMB_BIN the folder of the native programs.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { join, resolve } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { views, withUrl } from "../../page/test/support/tab.mjs";

const URL_OF_PAGE = pathToFileURL(resolve(process.env.PLUMB_PLAYGROUND)).href;
const BIN = process.env.PLUMB_BIN;
/** Relative error of a number that is shown with five. */
const FIVE_DIGITS = 5e-5;
const axe = await readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** The page must ask for nothing and complain of nothing, whatever a test does. */
const withPlayground = (options, use) =>
  withUrl(options.url ?? URL_OF_PAGE, options, async (page, noticed) => {
    await use(page);
    assert.deepEqual(noticed, { console: [], requests: [] });
  });

const framesOf = (page) => page.evaluate(() => Number(document.documentElement.dataset.frames));

/** Does something, and waits until it has been drawn. */
async function drawn(page, act) {
  const before = await framesOf(page);
  await act();
  await page.waitForFunction((n) => Number(document.documentElement.dataset.frames) > n, {}, before);
}

const caseOf = async (page) => JSON.parse(await page.$eval(".case textarea", ({ value }) => value));
const kinds = (page) =>
  page.$$eval("tr[data-method]", (rows) =>
    Object.fromEntries(rows.map(({ dataset }) => [dataset.method, dataset.kind])),
  );

for (const { width, dark } of views)
  test(`axe finds nothing and nothing is too wide, ${width} pixels, ${dark ? "dark" : "light"}`, () =>
    withPlayground({ width, dark }, async (page) => {
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
      assert.deepEqual(
        violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 160))}`),
        [],
      );
      const [scroll, client] = await page.evaluate(() => [
        document.documentElement.scrollWidth,
        document.documentElement.clientWidth,
      ]);
      assert.ok(scroll <= client, `${scroll} > ${client}`);
      assert.equal(await page.$eval("canvas", ({ dataset }) => dataset.drawn), "true");
    }));

test("each preset shows what its sentence says", () =>
  withPlayground({}, async (page) => {
    const presets = JSON.parse(await page.evaluate(() => document.documentElement.dataset.presets));
    assert.ok(presets.length >= 5);
    for (const [index, { name, says, shows }] of presets.entries()) {
      await drawn(page, () => page.select("select", String(index)));
      assert.equal(await page.$eval(".sentence", ({ textContent }) => textContent), says);
      assert.equal((await kinds(page))[shows.method], shows.kind, name);
      assert.equal((await kinds(page)).auto, "right", name);
    }
  }));

test("bounds are proved once nothing moves, close, and say who cannot be right", () =>
  withPlayground({}, async (page) => {
    const presets = JSON.parse(await page.evaluate(() => document.documentElement.dataset.presets));
    const atTilt = presets.findIndex(({ shows }) => shows.kind === "not_lowest");
    assert.ok(atTilt >= 0);
    await drawn(page, () => page.select("select", String(atTilt)));
    await page.waitForFunction(() => document.querySelector(".bounds").textContent !== "");
    const text = await page.$eval(".bounds", ({ textContent }) => textContent);
    const [, lower, upper] = text.match(/between (\S+) and (\S+)\.( |$)/);
    assert.ok(Number(lower) <= Number(upper) && Number(upper) - Number(lower) < 1e-9, text);
    assert.match(text, new RegExp(`wrong for sure: .*${presets[atTilt].shows.method}`));
    const overlap = await page.$eval('tr[data-method="auto"]', ({ cells }) => Number(cells[3].textContent));
    assert.ok(Math.abs(overlap - Number(upper)) <= FIVE_DIGITS * Math.abs(overlap));
  }));

test("no frame of a turn waits for more than one solve of each method", () =>
  withPlayground({}, async (page) => {
    await page.click('button[data-hold="turn2"]');
    const { x, y, width, height } = await (await page.$("canvas")).boundingBox();
    const before = await caseOf(page);
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    for (let step = 1; step <= 60; step++) await page.mouse.move(x + width / 2 + 2 * step, y + height / 2 + step);
    await page.mouse.up();
    const after = await caseOf(page);
    assert.notDeepEqual(after.bodies[1].orientation, before.bodies[1].orientation);
    assert.deepEqual(after.bodies[0], before.bodies[0]);
    const { frames, mostSolves } = await page.evaluate(() => ({ ...document.documentElement.dataset }));
    assert.ok(Number(frames) > 5, `${frames} frames`);
    assert.equal(mostSolves, "1");
  }));

test("keys and touch turn and move bodies", () =>
  withPlayground({}, async (page) => {
    await page.click('button[data-hold="turn1"]');
    await page.focus("canvas");
    const start = await caseOf(page);
    await drawn(page, () => page.keyboard.press("ArrowRight"));
    const turned = await caseOf(page);
    assert.notDeepEqual(turned.bodies[0].orientation, start.bodies[0].orientation);
    await page.click('button[data-hold="move2"]');
    const { x, y, width, height } = await (await page.$("canvas")).boundingBox();
    const touch = await page.touchscreen.touchStart(x + width / 2, y + height / 2);
    await drawn(page, async () => {
      await touch.move(x + width / 2 + 20, y + height / 2);
      await touch.move(x + width / 2 + 40, y + height / 2);
    });
    await touch.end();
    assert.notDeepEqual((await caseOf(page)).bodies[1].position, turned.bodies[1].position);
  }));

test("each slider changes the case", () =>
  withPlayground({}, async (page) => {
    const labels = await page.$$eval("input[type=range]", (all) => all.map(({ dataset }) => dataset.number));
    assert.equal(labels.length, 19);
    for (const label of labels) {
      const before = await caseOf(page);
      await page.focus(`input[data-number="${label}"]`);
      await drawn(page, () => page.keyboard.press("ArrowRight"));
      assert.notDeepEqual(await caseOf(page), before, label);
    }
  }));

test("a link holds the state, and one that is damaged does no harm", async () => {
  let link, held;
  await withPlayground({}, async (page) => {
    await page.waitForFunction(() => location.hash.length > 1);
    const before = await page.evaluate(() => location.hash);
    await drawn(page, () => page.select("select", "2"));
    await page.waitForFunction((old) => location.hash !== old, {}, before);
    link = await page.evaluate(() => location.href);
    held = await caseOf(page);
  });
  await withPlayground({ url: link }, async (page) => assert.deepEqual(await caseOf(page), held));
  for (const damaged of ["#1,2,three", "#%"])
    await withPlayground({ url: URL_OF_PAGE + damaged }, async (page) =>
      assert.equal((await caseOf(page)).bodies.length, 2),
    );
});

test("the case is what plumb solve reads, and answers alike", { skip: !BIN && "PLUMB_BIN is not set" }, () =>
  withPlayground({}, async (page) => {
    const input = await page.$eval(".case textarea", ({ value }) => value);
    const out = execFileSync(join(BIN, "plumb-solve"), ["-", "--method", "all", "--json"], { input, encoding: "utf8" });
    const native = out
      .trim()
      .split("\n")
      .map((line) => JSON.parse(line))
      .filter(({ method }) => !method.startsWith("peer_")); // other people's solvers, where they are built
    const rows = await page.$$eval("tr[data-method]", (all) =>
      all.map((row) => [row.dataset.method, row.dataset.kind === "no_answer", row.cells[3].textContent]),
    );
    assert.equal(rows.length, native.length);
    for (const [index, [method, isNone, overlap]] of rows.entries()) {
      assert.equal(method, native[index].method);
      assert.equal(isNone, native[index].status !== "converged");
      if (!isNone)
        assert.ok(Math.abs(Number(overlap) - native[index].overlap) <= FIVE_DIGITS * Math.abs(native[index].overlap));
    }
  }),
);
