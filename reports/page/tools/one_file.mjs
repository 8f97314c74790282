// A page as one HTML file: scripts and styles inside, at their places in the template.
import { readFile } from "node:fs/promises";
import { resolve } from "node:path";
import { build } from "esbuild";

async function bundle(folder, entry, options) {
  const result = await build({
    absWorkingDir: folder,
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

/** Of a folder with src/main.ts and src/template.html; `style`: its style sheet; `define`: constants of the scripts. */
export async function oneFile(folder, { style, define = {} }) {
  const script = await bundle(folder, "src/main.ts", {
    format: "iife",
    target: "es2022",
    loader: { "": "text" },
    define: { "process.env.NODE_ENV": '"production"', ...define },
  });
  const sheet = await bundle(folder, style, {});
  const page = await readFile(resolve(folder, "src/template.html"), "utf8");
  const styled = fill(page, "<!-- build:style -->", `<style>${sheet}</style>`);
  return fill(styled, "<!-- build:script -->", `<script>${safeInScript(script)}</script>`);
}
