// The one test of time: 100 000 cases, five families, thirteen methods, 500 failures, four precision sets.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { launch, open } from "./support/browser.mjs";
import { makeReport } from "./support/fixture.mjs";
import { withFolder, writePage } from "./support/pages.mjs";

const BUDGET_MS = 2000;
const TRIES = 5;

test(`a full campaign loads within ${BUDGET_MS} ms`, (t) =>
  withFolder(async (folder) => {
    const url = await writePage(makeReport(), join(folder, "page.html"));
    const browser = await launch();
    const times = [];
    try {
      while (times.length < TRIES) {
        const { page } = await open(browser, url);
        times.push(await page.evaluate(() => performance.getEntriesByName("ready")[0].startTime));
        await page.close();
      }
    } finally {
      await browser.close();
    }
    // The machine may be busy with something else: the best of some tries is the page's own.
    t.diagnostic(`ready after ${times.map((ms) => ms.toFixed(0)).join(", ")} ms`);
    assert.ok(Math.min(...times) < BUDGET_MS, `${times} ms`);
  }));
