// A module of the page, outside of it.
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

export async function load(module) {
  const entry = fileURLToPath(new URL(`../../src/${module}`, import.meta.url));
  const { outputFiles } = await build({ entryPoints: [entry], bundle: true, write: false, format: "esm" });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`);
}
