/** What makes the figures above it: one click away. */
import { command } from "./commands";
import { type Child, details, h } from "./dom";

/** Under each part that has something to show. */
export const madeBy = (text: string, parts: [string, Child[]][]): Child[] =>
  parts.flatMap(([what, part]) => (part.length > 0 ? [...part, made([text], what)] : []));

export const made = (commands: string[], what: string): HTMLElement =>
  details(
    `What makes these figures: ${what}`,
    () => h("div", {}, ...commands.map((text) => command(text, `the command of ${what}`))),
    { class: "made" },
  );
