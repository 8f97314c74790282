// Pages made of the built template and a report, as plumb report makes them.
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const TEMPLATE = fileURLToPath(new URL("../../dist/template.html", import.meta.url));
const PLACE = "<!-- plumb:data -->";

export async function pageOf(report, template = TEMPLATE) {
  const page = await readFile(template, "utf8");
  const data = JSON.stringify(report).replaceAll("<", "\\u003c");
  return page.split(PLACE).join(`<script type="application/json" id="plumb-data">${data}</script>`);
}

export async function writePage(report, file) {
  await writeFile(file, await pageOf(report));
  return pathToFileURL(resolve(file)).href;
}

export async function withFolder(use) {
  const folder = await mkdtemp(join(tmpdir(), "plumb-page-"));
  try {
    return await use(folder);
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}
