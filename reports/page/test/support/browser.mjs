// Chromium without a window, by puppeteer; PLUMB_CHROMIUM names another one.
import puppeteer from "puppeteer-core";

export const launch = () =>
  puppeteer.launch({
    executablePath: process.env.PLUMB_CHROMIUM ?? "/usr/bin/chromium",
    headless: true,
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage"],
  });

/** Opens a page and notes all that it must not do: complain, or ask for anything but itself. */
export async function open(browser, url, { width = 1400, height = 900, dark = false } = {}) {
  const page = await browser.newPage();
  const noticed = { console: [], requests: [] };
  page.on("console", (message) => {
    if (["error", "warn", "warning"].includes(message.type())) noticed.console.push(message.text());
  });
  page.on("pageerror", (error) => noticed.console.push(String(error)));
  page.on("request", (request) => {
    const address = request.url();
    if (address !== url && !/^(data|blob):/.test(address)) noticed.requests.push(address);
  });
  await page.setViewport({ width, height });
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: dark ? "dark" : "light" }]);
  await page.goto(url, { waitUntil: "load" });
  await page.waitForSelector('html[data-ready="true"]', { timeout: 30000 });
  return { page, noticed };
}

/** Scrolls there until it is drawn: what is drawn above it may push it out of view again. */
export async function bring(page, selector) {
  const element = await page.waitForSelector(selector);
  const scroll = (found) => {
    if (!found.dataset.drawn) found.scrollIntoView({ behavior: "instant", block: "center" });
    return found.dataset.drawn === "true";
  };
  await page.waitForFunction(scroll, { polling: 100 }, element);
  await element.evaluate((found) => found.scrollIntoView({ behavior: "instant", block: "center" }));
  return element;
}
