import { command } from "../commands";
import type { Run } from "../data";
import { h, section } from "../dom";
import { count, duration } from "../numbers";
import { perRun, type State } from "../state";
import { definitions } from "../table";

function facts(run: Run): HTMLElement {
  const { host, timing } = run;
  const list = definitions([
    ["Commit", h("code", {}, run.commit)],
    ["Seed", String(run.seed)],
    ["Folder", h("code", {}, run.folder)],
    ["System", host.system],
    ["Machine", `${host.machine}, ${host.processors} processors`],
    ["Compiler", host.compiler],
    ["Flags", h("code", {}, host.flags)],
    [
      "Took",
      `${duration(timing.seconds)} in ${timing.threads} threads, ${count(timing.cases_per_second)} cases a second`,
    ],
  ]);
  list.className = "facts";
  return list;
}

function commands(run: Run): HTMLElement[] {
  const named = run.families.map((family): [string, string] => [family.name, family.command]);
  const known = new Set(named.map(([, text]) => text));
  const others = run.commands.filter((text) => !known.has(text)).map((text): [string, string] => ["", text]);
  return [...named, ...others].map(([name, text]) =>
    h(
      "div",
      { class: "repeat" },
      name ? h("h4", {}, name) : null,
      command(text, `the command of ${name || "the run"}`),
    ),
  );
}

export function machineSection(state: State): HTMLElement {
  const place = perRun(state, h("div"), (run) => [
    h("h3", {}, run.name),
    facts(run),
    h("h3", {}, "To repeat it"),
    ...commands(run),
  ]);
  const { made } = state.report;
  const page = definitions([
    ["Commit", h("code", {}, made.commit)],
    ["Compiler", made.compiler],
    ["Flags", h("code", {}, made.flags)],
  ]);
  page.className = "facts";
  return section(
    "machine",
    "Machine and commands",
    "Where do the figures come from, and what repeats them?",
    place,
    h("h3", {}, "This page"),
    page,
    command(made.command, "the command that made this page"),
  );
}
