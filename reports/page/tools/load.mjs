// npm run load [-- PAGE.html]: how long a page takes from navigation to its own mark "ready", best and worst of some tries; without a
// page, one of 100 000 cases, five families, thirteen methods, 500 failures and four precision sets.
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { launch, open } from "../test/support/browser.mjs";
import { makeReport } from "../test/support/fixture.mjs";
import { writePage } from "../test/support/pages.mjs";

const TRIES = 5;

async function loads(url) {
  const browser = await launch();
  const times = [];
  while (times.length < TRIES) {
    const { page } = await open(browser, url);
    times.push(await page.evaluate(() => performance.getEntriesByName("ready")[0].startTime));
    await page.close();
  }
  await browser.close();
  return times;
}

const folder = await mkdtemp(join(tmpdir(), "plumb-page-"));
try {
  const [file] = process.argv.slice(2);
  const url = file ? pathToFileURL(resolve(file)).href : await writePage(makeReport(), join(folder, "page.html"));
  const times = await loads(url);
  console.log(
    `ready after ${Math.min(...times).toFixed(0)} ms at best, ${Math.max(...times).toFixed(0)} ms at worst of ${TRIES}`,
  );
} finally {
  await rm(folder, { recursive: true, force: true });
}
