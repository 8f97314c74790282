// npm run picture -- PAGE.html FILE.png SET: work and precision of one set, as the README shows it; in SET's place also
//   study-angles, study-maps [ASPECT PHI RATIO], study-limits [angle_deg | point | overlap]: figures of the source's study;
//   fem-angles: the figure of the finite elements; scene: the bodies of a run's first frame.
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { bring, launch, open } from "../test/support/browser.mjs";

const [file, picture, what, ...choices] = process.argv.slice(2);
if (!file || !picture || !what)
  throw new Error("usage: npm run picture -- PAGE.html FILE.png SET|study-FIGURE|fem-angles|scene [CHOICE..]");
const BLOCKS = ["study-angles", "study-maps", "study-limits", "fem-angles"];

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

const pause = () => new Promise((done) => setTimeout(done, 500));

async function pictureOfSet(page) {
  await bring(page, "#precision .plot");
  await choose(page, what);
  await bring(page, "#precision .plot");
  await pause();
  await page.screenshot({ path: picture, clip: await between(page, "#precision .legends", "#precision .plot") });
}

/** A choice for each list, in their order. */
async function chooseAll(block) {
  const lists = await block.$$("select");
  for (const [index, wanted] of choices.entries()) {
    const value = await lists[index]?.evaluate(
      (select, text) =>
        [...select.options].map((option) => option.value).find((one) => one === text || Number(one) === Number(text)),
      wanted,
    );
    if (value === undefined) throw new Error(`${wanted}: ${what} has no such choice`);
    await lists[index].select(value);
  }
}

/** All its panels in view at once, without the tables behind them. */
async function pictureOfBlock(page) {
  const block = await page.$(`#${what}`);
  if (!block) throw new Error(`${file}: the page has no ${what}`);
  const hidden = `#${what} details, .bar { display: none !important } #${what} { padding: 0.8rem }`;
  await page.addStyleTag({ content: hidden });
  await chooseAll(block);
  await page.setViewport({ width: 1400, height: 3000 });
  await block.evaluate((element) => element.scrollIntoView({ behavior: "instant" }));
  const isDrawn = (element) => !element.querySelector(".plot:not([data-drawn])");
  await page.waitForFunction(isDrawn, { timeout: 60000 }, block);
  await pause();
  await block.screenshot({ path: picture });
}

async function pictureOfScene(page) {
  const canvas = await bring(page, "#playback canvas");
  await pause();
  await canvas.screenshot({ path: picture });
}

const browser = await launch();
try {
  const { page } = await open(browser, pathToFileURL(resolve(file)).href, { width: 1100, height: 1400 });
  if (what === "scene") await pictureOfScene(page);
  else await (BLOCKS.includes(what) ? pictureOfBlock(page) : pictureOfSet(page));
} finally {
  await browser.close();
}
