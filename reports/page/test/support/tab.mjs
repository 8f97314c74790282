// One browser and one tab for all tests of a process: to start either takes longer than most of them.
import { join } from "node:path";
import { after } from "node:test";
import { launch, show } from "./browser.mjs";
import { withFolder, writePage } from "./pages.mjs";

/** Widths and colours that axe looks at: by day each width and each set of colours once, by night all four. */
export const views = [
  { width: 400, dark: false },
  { width: 1400, dark: true },
  ...(process.env.PLUMB_NIGHTLY === "1"
    ? [
        { width: 400, dark: true },
        { width: 1400, dark: false },
      ]
    : []),
];

let browser;
let tab;

after(async () => (await browser)?.close());

/** What a page left behind goes, whether its test held or not: what it keeps, and itself. */
async function leave(page) {
  await page.mouse.move(0, 0);
  await page.evaluate(() => localStorage.clear());
  await page.goto("about:blank");
}

/** The page there, given to `use` with what it must not do. One at a time: tests of a process follow each other. */
export async function withUrl(url, options, use) {
  browser ??= launch();
  tab ??= (await browser).newPage();
  const page = await tab;
  let forget;
  try {
    const shown = await show(page, url, options);
    forget = shown.forget;
    return await use(shown.page, shown.noticed);
  } catch (error) {
    tab = undefined; // whatever is wrong with it, the next test has another
    throw error;
  } finally {
    forget?.();
    if (tab) await leave(page);
    else await page.close();
  }
}

/** The page of a report. */
export const withPage = (report, options, use) =>
  withFolder(async (folder) => withUrl(await writePage(report, join(folder, "page.html")), options, use));
