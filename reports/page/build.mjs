// node build.mjs [--outfile=dist/template.html]: one HTML file with all scripts and styles inside, and one place for the data.
import { mkdir, writeFile } from "node:fs/promises";
import { dirname, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { oneFile } from "./tools/one_file.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const DATA_PLACE = "<!-- plumb:data -->";

export async function buildTemplate(outfile) {
  const page = await oneFile(here, { style: "src/styles/page.css" });
  if (page.split(DATA_PLACE).length !== 2) throw new Error(`${DATA_PLACE} must stand once in the page`);
  await mkdir(dirname(outfile), { recursive: true });
  await writeFile(outfile, page);
  return page.length;
}

const { values } = parseArgs({
  options: { outfile: { type: "string", default: resolve(here, "dist/template.html") } },
});
const size = await buildTemplate(resolve(values.outfile));
console.log(`${values.outfile}: ${(size / 1024).toFixed(0)} KiB`);
