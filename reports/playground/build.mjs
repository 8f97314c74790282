// node build.mjs --study FILE --failures FILE --outfile FILE: the playground as one HTML file. Run by ./build, in a folder with the page's tools.
import { readFile, writeFile } from "node:fs/promises";
import { dirname, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));

async function bundle(entry, options) {
  const result = await build({
    absWorkingDir: here,
    entryPoints: [entry],
    bundle: true,
    write: false,
    minify: true,
    charset: "utf8",
    legalComments: "inline",
    logLevel: "warning",
    ...options,
  });
  return result.outputFiles[0].text.trim();
}

/** Inside <script> these would end it, or hide its end. */
const safeInScript = (code) => code.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");

function fill(template, place, text) {
  const parts = template.split(place);
  if (parts.length !== 2) throw new Error(`${place} stands ${parts.length - 1} times in the template, not once`);
  return parts.join(text);
}

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
const script = await bundle("src/main.ts", {
  format: "iife",
  target: "es2022",
  loader: { "": "text" },
  define: { "process.env.NODE_ENV": '"production"', PRESET_DATA: JSON.stringify(data) },
});
const style = await bundle("src/playground.css", {});
let page = await readFile(resolve(here, "src/template.html"), "utf8");
page = fill(page, "<!-- build:style -->", `<style>${style}</style>`);
page = fill(page, "<!-- build:script -->", `<script>${safeInScript(script)}</script>`);
await writeFile(values.outfile, page);
console.log(`${values.outfile}: ${(page.length / 1024).toFixed(0)} KiB`);
