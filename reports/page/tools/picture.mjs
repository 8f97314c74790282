// npm run picture -- PAGE.html FILE.png SET: work and precision of one set, as the README shows it.
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { bring, launch, open } from "../test/support/browser.mjs";

const [file, picture, set] = process.argv.slice(2);
if (!file || !picture || !set) throw new Error("usage: npm run picture -- PAGE.html FILE.png SET");

/** The option of the first list that begins with the set's name. */
async function choose(page, name) {
  const list = await page.waitForSelector("#precision select");
  const value = await list.evaluate(
    (select, wanted) => [...select.options].find((option) => option.text.startsWith(wanted))?.value,
    name,
  );
  if (value === undefined) throw new Error(`${name}: the page has no such set`);
  await list.select(value);
}

/** The rectangle from the top of one to the end of the other, with a rim. */
async function between(page, first, last) {
  const box = (selector) =>
    page.$eval(selector, (element) => {
      const { x, y, width, height } = element.getBoundingClientRect();
      return { x: x + scrollX, y: y + scrollY, width, height };
    });
  const [from, to] = [await box(first), await box(last)];
  return { x: from.x, y: from.y, width: from.width, height: to.y + to.height - from.y };
}

const browser = await launch();
try {
  const { page } = await open(browser, pathToFileURL(resolve(file)).href, { width: 1100, height: 1400 });
  await bring(page, "#precision .plot");
  await choose(page, set);
  await bring(page, "#precision .plot");
  await new Promise((done) => setTimeout(done, 500));
  await page.screenshot({ path: picture, clip: await between(page, "#precision .legends", "#precision .plot") });
} finally {
  await browser.close();
}
