// npm run types: src/data.ts, the document's types, from its one description, report-1.schema.json.
import { readFileSync, writeFileSync } from "node:fs";

const schemaFile = new URL("../../document/report-1.schema.json", import.meta.url);
const typesFile = new URL("../src/data.ts", import.meta.url);
const { description, $defs } = JSON.parse(readFileSync(schemaFile, "utf8"));

const NAMES = { integer: "number", number: "number", string: "string", boolean: "boolean", null: "null" };

const comment = (text, indent = "") => (text ? `${indent}/** ${text} */\n` : "");

/** Three numbers are [number, number, number]. */
function arrayType({ items, minItems, maxItems }, indent) {
  const item = typeOf(items, indent);
  if (maxItems && minItems === maxItems) return `[${Array(maxItems).fill(item).join(", ")}]`;
  return item.includes(" ") ? `(${item})[]` : `${item}[]`;
}

function objectType({ properties = {}, required = [], additionalProperties }, indent) {
  const deeper = `${indent}  `;
  const fields = Object.entries(properties).map(([name, property]) => {
    const mark = required.includes(name) ? "" : "?";
    return `${comment(property.description, deeper)}${deeper}${name}${mark}: ${typeOf(property, deeper)};\n`;
  });
  const others = additionalProperties && `${deeper}[name: string]: ${typeOf(additionalProperties, deeper)};\n`;
  return `{\n${fields.join("")}${others ?? ""}${indent}}`;
}

function typeOf(part, indent) {
  if (part.$ref) return part.$ref.replace("#/$defs/", "");
  if (part.const) return JSON.stringify(part.const);
  if (part.enum) return part.enum.map((word) => JSON.stringify(word)).join(" | ");
  if (part.oneOf) return part.oneOf.map((one) => typeOf(one, indent)).join(" | ");
  if (Array.isArray(part.type)) return part.type.map((type) => typeOf({ ...part, type }, indent)).join(" | ");
  if (part.type === "array") return arrayType(part, indent);
  if (part.type === "object") return objectType(part, indent);
  return NAMES[part.type] ?? "unknown";
}

const types = Object.entries($defs).map(
  ([name, part]) => `${comment(part.description)}export type ${name} = ${typeOf(part, "")};\n`,
);
writeFileSync(typesFile, `/** ${description} Made by tools/types.mjs. */\n\n${types.join("\n")}`);
