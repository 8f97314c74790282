// node build.mjs [--outfile=dist/template.html]: one HTML file with all scripts and styles inside, and one place for the data.
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const DATA_PLACE = "<!-- plumb:data -->";

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

export async function buildTemplate(outfile) {
  const script = await bundle("src/main.ts", {
    format: "iife",
    target: "es2022",
    loader: { "": "text" },
    define: { "process.env.NODE_ENV": '"production"' },
  });
  const style = await bundle("src/styles/page.css", {});
  let page = await readFile(resolve(here, "src/template.html"), "utf8");
  page = fill(page, "<!-- build:style -->", `<style>${style}</style>`);
  page = fill(page, "<!-- build:script -->", `<script>${safeInScript(script)}</script>`);
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
