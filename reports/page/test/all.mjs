// All tests in one process, and so in one browser; each file is one of its own as well.
import { readdirSync } from "node:fs";

const files = readdirSync(new URL(".", import.meta.url)).filter((file) => file.endsWith(".test.mjs"));
for (const file of files.sort()) await import(`./${file}`);
