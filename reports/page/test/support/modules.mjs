// Modules of the page, outside of it: several are one, and share what they keep.
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const sources = fileURLToPath(new URL("../../src", import.meta.url));

export async function load(...modules) {
  const contents = modules.map((module) => `export * from "./${module}";`).join("\n");
  const stdin = { contents, resolveDir: sources };
  const { outputFiles } = await build({ stdin, bundle: true, write: false, format: "esm" });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`);
}
