// node build.mjs --study FILE --failures FILE --outfile FILE: the playground as one HTML file. Run by ./build, in a folder with the page's tools.
import { readFile, writeFile } from "node:fs/promises";
import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { oneFile } from "../page/tools/one_file.mjs";

const here = dirname(fileURLToPath(import.meta.url));

const linesOf = async (file) =>
  (await readFile(file, "utf8"))
    .trim()
    .split("\n")
    .map((line) => JSON.parse(line));

/** The study's four groups of spheroids, as `plumb report-study` found them. */
async function groupsOf(file) {
  const groups = (await linesOf(file)).filter(({ kind, shape }) => kind === "group" && shape === "spheroid");
  if (groups.length !== 4) throw new Error(`${file}: four groups of spheroids expected, not ${groups.length}`);
  return groups;
}

const { values } = parseArgs({
  options: { study: { type: "string" }, failures: { type: "string" }, outfile: { type: "string" } },
});
const data = { groups: await groupsOf(values.study), failures: await linesOf(values.failures) };
const page = await oneFile(here, {
  style: "src/playground.css",
  define: { PRESET_DATA: JSON.stringify(data) },
});
await writeFile(values.outfile, page);
console.log(`${values.outfile}: ${(page.length / 1024).toFixed(0)} KiB`);
