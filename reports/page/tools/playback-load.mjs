// npm run playback-load: how large a page of 201 frames is, and how long a picture takes while it plays; 200 and 2000 made-up bodies,
// Chromium without a graphics card.
import { join } from "node:path";
import { readdir, readFile, stat } from "node:fs/promises";
import { bring, launch, open } from "../test/support/browser.mjs";
import { makePlayback, makeSceneReport } from "../test/support/fixture-playback.mjs";
import { withFolder, writePage } from "../test/support/pages.mjs";

const SECONDS = 8;

/** Of the browser and all that it started, in ms: other work on the machine does not count. */
async function processorTime(root) {
  const processes = [];
  for (const id of (await readdir("/proc")).filter((name) => /^\d+$/.test(name))) {
    const line = await readFile(`/proc/${id}/stat`, "utf8").catch(() => "");
    const fields = line.slice(line.lastIndexOf(")") + 2).split(" ");
    if (line)
      processes.push({ id: Number(id), parent: Number(fields[1]), ticks: Number(fields[11]) + Number(fields[12]) });
  }
  const known = new Set([root]);
  for (let before = 0; before !== known.size;) {
    before = known.size;
    for (const { id, parent } of processes) if (known.has(parent)) known.add(id);
  }
  return 10 * processes.reduce((sum, { id, ticks }) => sum + (known.has(id) ? ticks : 0), 0);
}

const frames = (page, seconds) =>
  page.evaluate(
    (long) =>
      new Promise((done) => {
        let count = 0;
        const begin = performance.now();
        const next = () => {
          count++;
          if (performance.now() - begin > 1000 * long) done({ count, took: performance.now() - begin });
          else requestAnimationFrame(next);
        };
        requestAnimationFrame(next);
      }),
    seconds,
  );

/** While it plays each animation frame is a picture. */
async function pace(browser, page) {
  const before = await processorTime(browser.process().pid);
  const { TaskDuration: begun } = await page.metrics();
  const { count, took } = await frames(page, SECONDS);
  const spent = (await processorTime(browser.process().pid)) - before;
  const own = 1000 * ((await page.metrics()).TaskDuration - begun);
  const [picture, thread, all] = [took, own, spent].map((ms) => (ms / count).toFixed(1));
  return `${picture} ms a picture, of which the page's own thread ${thread} ms, all processors ${all} ms`;
}

async function measure(browser, folder, bodies) {
  const playback = makePlayback({ bodies, frames: 201 });
  const file = join(folder, `${bodies}.html`);
  const url = await writePage(makeSceneReport(playback), file);
  const begin = performance.now();
  const { page } = await open(browser, url);
  await bring(page, "#playback canvas");
  const shown = performance.now() - begin;
  const [contactsBox, repeatBox] = await page.$$("#playback .player-choices input[type=checkbox]");
  await repeatBox.click();
  await page.click('#playback button[title="Play"]');
  const bare = await pace(browser, page);
  await contactsBox.click();
  const withContacts = await pace(browser, page);
  const contacts = playback.contacts.counts.reduce((sum, n) => sum + n, 0);
  await page.close();
  const size = (await stat(file)).size / 2 ** 20;
  console.log(
    `${bodies} bodies, 201 frames, ${contacts} contacts: ${size.toFixed(1)} MiB, first picture after ${shown.toFixed(0)} ms, ` +
      `${bare}; with contacts ${withContacts}`,
  );
}

await withFolder(async (folder) => {
  const browser = await launch();
  try {
    for (const bodies of [200, 2000]) await measure(browser, folder, bodies);
  } finally {
    await browser.close();
  }
});
