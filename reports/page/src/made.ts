/** What makes the figures above it: one click away. */
import { command } from "./commands";
import { details, h } from "./dom";

export const made = (commands: string[], what: string): HTMLElement =>
  details(
    `What makes these figures: ${what}`,
    () => h("div", {}, ...commands.map((text) => command(text, `the command of ${what}`))),
    { class: "made" },
  );
