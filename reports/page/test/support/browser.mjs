// Chromium without a window, by puppeteer; PLUMB_CHROMIUM names another one.
import puppeteer from "puppeteer-core";

/** Pixels of a desk's screen from top to bottom. */
export const SCREEN = 900;

export const launch = () =>
  puppeteer.launch({
    executablePath: process.env.PLUMB_CHROMIUM ?? "/usr/bin/chromium",
    headless: true,
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage"],
  });

/** Notes all that a page must not do: complain, or ask for anything but itself. */
function watch(page, url) {
  const noticed = { console: [], requests: [] };
  const watchers = {
    console: (message) => {
      if (["error", "warn", "warning"].includes(message.type())) noticed.console.push(message.text());
    },
    pageerror: (error) => noticed.console.push(String(error)),
    request: (request) => {
      const address = request.url();
      if (address !== url && !/^(data|blob):/.test(address)) noticed.requests.push(address);
    },
  };
  for (const [event, watcher] of Object.entries(watchers)) page.on(event, watcher);
  const forget = () => Object.entries(watchers).forEach(([event, watcher]) => page.off(event, watcher));
  return { noticed, forget };
}

/** Goes there in a tab and waits until the page is ready; what it does until forget() is noticed. Nothing moves unless `moves`. */
export async function show(page, url, { width = 1400, height = SCREEN, dark = false, moves = false } = {}) {
  const { noticed, forget } = watch(page, url);
  await page.setViewport({ width, height });
  await page.emulateMediaFeatures([
    { name: "prefers-color-scheme", value: dark ? "dark" : "light" },
    { name: "prefers-reduced-motion", value: moves ? "no-preference" : "reduce" },
  ]);
  await page.goto(url, { waitUntil: "load" });
  await page.waitForSelector('html[data-ready="true"]', { timeout: 30000 });
  return { page, noticed, forget };
}

/** The same in a tab of its own. */
export const open = async (browser, url, options) => show(await browser.newPage(), url, options);

/** Opens what it is folded in and scrolls there until it is drawn: what is drawn above it may push it out of view again. */
export async function bring(page, selector) {
  const element = await page.waitForSelector(selector);
  await element.evaluate((found) => {
    for (let at = found.closest("details"); at; at = at.parentElement.closest("details")) at.open = true;
  });
  const scroll = (found) => {
    if (!found.dataset.drawn) found.scrollIntoView({ behavior: "instant", block: "center" });
    return found.dataset.drawn === "true";
  };
  await page.waitForFunction(scroll, { polling: 100 }, element);
  await element.evaluate((found) => found.scrollIntoView({ behavior: "instant", block: "center" }));
  return element;
}
