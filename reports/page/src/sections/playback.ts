import type { Playback, Report } from "../data";
import { type Child, h, section } from "../dom";
import { made } from "../made";
import { count, number, percent } from "../numbers";
import { PlaybackBlock } from "../playback/block";
import { definitions, table } from "../table";

const QUESTION = "What happens in a scene, which effects run in it, and where does its energy go?";
const HOW =
  "Speeds are the difference of the frames around. Arrows go from the body of lower number along the normal, as long as the force, up to what 98 in 100 contacts stay below. Planes are cut to the scene's extent; z is up. Drag or arrow keys turn, plus and minus zoom, 0 resets; space plays, comma and full stop step. A click on a figure goes to its time.";

const blocks: PlaybackBlock[] = [];

/** For a shell, as one word. */
const word = (text: string): string => (/^[\w@%+=:,./-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);

/** A run keeps its scene as it was run. */
const commandOf = ({ folder }: Playback): string =>
  `plumb scene ${word(`${folder}/scene.json`)} --out ${word(`${folder}-again`)}`;

/** On paper a scene is its last frame. */
export function stillsForPaper(on: boolean): void {
  for (const block of blocks) block.still(on);
}

function effects(playback: Playback): HTMLElement {
  return table({
    caption: `Effects of ${playback.name}`,
    columns: [
      { title: "Effect", head: true, cell: ({ name }) => name },
      { title: "Runs", cell: ({ on }) => h("span", { class: on ? "on" : "off" }, on ? "on" : "off") },
      { title: "Why", cell: ({ why }) => why },
    ],
    rows: playback.effects,
    hideCaption: true,
  });
}

function end({ end, name }: Playback): HTMLElement[] {
  if (!end)
    return [h("p", { class: "verdict bad" }, h("strong", {}, "Incomplete: "), `the run of ${name} did not end.`)];
  const failed = `${count(end.failed)} of ${count(end.solves)} solves failed.`;
  const parts = Object.entries(end.shares).map(([part, share]) => `${part} ${percent(share)} %`);
  const pairs: [string, Child][] = [
    ["Steps", count(end.steps)],
    ["Ended at t", number(end.time, 6)],
    ["Hash of the end", h("code", {}, end.hash)],
    ["Time went to", parts.join(", ") || "nothing that was measured"],
  ];
  const facts = definitions(pairs);
  facts.className = "facts";
  return [h("p", { class: `verdict ${end.failed > 0 ? "bad" : end.solves > 0 ? "good" : ""}` }, failed), facts];
}

function facts(playback: Playback): HTMLElement {
  const list = definitions([
    ["Bodies", count(playback.bodies.length)],
    ["Walls", count(playback.walls.length)],
    ["Frames", count(playback.times.length)],
    ["Time step", number(playback.time_step)],
    ["Accuracy", number(playback.accuracy)],
  ]);
  list.className = "figures";
  return list;
}

function scene(playback: Playback): HTMLElement {
  const block = new PlaybackBlock(playback);
  blocks.push(block);
  const title = h("h3", {}, playback.name, " ", h("small", {}, `scene ${playback.scene}`));
  const beside = h("div", { class: "beside" }, ...end(playback), ...block.figures);
  return h(
    "article",
    { class: "playback", "aria-label": `Scene ${playback.name}` },
    title,
    facts(playback),
    h("div", { class: "stage" }, block.element, beside),
    made([commandOf(playback)], `the scene ${playback.name}`),
    h("h4", {}, "Effects"),
    effects(playback),
  );
}

/** What the head says of the scenes. */
export const playbackLines = ({ playbacks }: Report): string[] =>
  playbacks.map(
    ({ name, scene, bodies, times }) =>
      `${name}: scene ${scene}, ${count(bodies.length)} bodies, ${count(times.length)} frames to t = ${number(times.at(-1))}`,
  );

/** null where the report holds no scene. */
export function playbackSection({ playbacks }: Report): HTMLElement | null {
  if (playbacks.length === 0) return null;
  return section("playback", "Playback", QUESTION, ...playbacks.map(scene), h("p", { class: "note" }, HOW));
}
