// npm run screenshots -- PAGE.html OUTDIR: the page as it opens and each section opened, light and dark, on a phone and on a desk, and
// the page on paper.
import { mkdir } from "node:fs/promises";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { launch, open } from "../test/support/browser.mjs";

const [file, folder] = process.argv.slice(2);
if (!file || !folder) throw new Error("usage: npm run screenshots -- PAGE.html OUTDIR");
const url = pathToFileURL(resolve(file)).href;
await mkdir(folder, { recursive: true });

const pause = (ms) => new Promise((done) => setTimeout(done, ms));

/** What is further down is cut off. */
const LONGEST = 9000;

/** All figures of a section in view drawn, and the page still. */
async function settled(page, id) {
  const isDrawn = (target) =>
    [...document.querySelectorAll(`#${target} :is(.plot, canvas):not([data-drawn])`)].every(
      (figure) => figure.getBoundingClientRect().top > innerHeight,
    );
  await page.waitForFunction(isDrawn, { timeout: 60000 }, id).catch(() => console.error(`${id}: not all is drawn`));
  await pause(300);
}

async function shoot(browser, width, dark) {
  const { page } = await open(browser, url, { width, height: 1000, dark });
  const look = `${width}-${dark ? "dark" : "light"}`;
  await page.evaluate(() => scrollTo(0, 0));
  await pause(3000);
  await page.screenshot({ path: join(folder, `top-${look}.png`) });
  const height = await page.evaluate(() => document.documentElement.scrollHeight);
  console.log(`${look}: ${height} pixels high as it opens`);
  await page.setViewport({ width, height: Math.min(LONGEST, height) });
  await pause(3000);
  await page.screenshot({ path: join(folder, `whole-${look}.png`) });
  await page.addStyleTag({
    content: ".bar { position: static !important; } html { scroll-behavior: auto !important; }",
  });
  for (const id of await page.$$eval("main > section", (sections) =>
    sections.map((section) => section.id).filter(Boolean),
  )) {
    await page.setViewport({ width, height: ["study", "fem"].includes(id) ? LONGEST : 4000 });
    await page.evaluate((target) => {
      const section = document.getElementById(target);
      for (const fold of section.querySelectorAll(":scope > details")) fold.open = true;
      section.scrollIntoView();
    }, id);
    if (id !== "gallery") await settled(page, id);
    else await pause(4000);
    const clip = await page.$eval(`#${id}`, (part) => {
      const { top, height } = part.getBoundingClientRect();
      return { x: 0, y: top + scrollY, height: Math.min(height, innerHeight) };
    });
    await page.screenshot({ path: join(folder, `${id}-${look}.png`), clip: { ...clip, width } });
    await page.$eval(`#${id}`, (section) => {
      for (const fold of section.querySelectorAll(":scope > details")) fold.open = false;
    });
  }
  await page.close();
}

const browser = await launch();
try {
  for (const width of [1400, 400]) for (const dark of [false, true]) await shoot(browser, width, dark);
  const { page } = await open(browser, url);
  await pause(4000);
  await page.pdf({ path: join(folder, "paper.pdf"), format: "A4", printBackground: true, timeout: 120000 });
} finally {
  await browser.close();
}
