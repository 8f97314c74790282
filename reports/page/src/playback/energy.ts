/** Energy against time, with a line at what the view shows. */
import type { Data } from "plotly.js";
import type { Playback } from "../data";
import { h } from "../dom";
import { NONE, number } from "../numbers";
import { type Drawing, type Figure, figure, plain } from "../plot";
import { legend } from "../swatch";
import { type Column, table } from "../table";
import { ink, theme } from "../theme";

const HUES: Record<"light" | "dark", string[]> = {
  light: ["#c44e00", "#00795a", "#6a51a3", "#a86d00", "#b0508a", "#2f7d86"],
  dark: ["#ff8a45", "#27c39a", "#b7a1ef", "#f0b030", "#e79bc8", "#63cad6"],
};
const DASHES = ["solid", "dash", "dot", "dashdot"];
const TOTAL = "total";

interface Line {
  name: string;
  values: (number | null)[];
  index: number;
}

const linesOf = ({ energy }: Playback): Line[] =>
  Object.entries(energy).map(([name, values], index) => ({ name, values, index }));

const hueOf = ({ name, index }: Line, dark: "light" | "dark"): string =>
  name === TOTAL ? ink().text : (HUES[dark][index % HUES[dark].length] as string);
const dashOf = ({ name, index }: Line): string =>
  name === TOTAL ? "solid" : (DASHES[Math.floor(index / HUES.light.length) % DASHES.length] as string);

function swatch(line: Line): HTMLElement {
  const [light, dark] = [HUES.light, HUES.dark].map((hues) => hues[line.index % hues.length]);
  const colour = line.name === TOTAL ? "currentColor" : `light-dark(${light}, ${dark})`;
  const mark = h("span", { class: "line-swatch", style: `background: ${colour}`, "aria-hidden": "true" });
  return h("span", { class: "method" }, mark, line.name);
}

function draw(playback: Playback, hidden: Set<string>): Drawing {
  const { grid } = ink();
  const shown = linesOf(playback).filter(({ name }) => !hidden.has(name));
  const data = shown.map((line): Data => ({
    type: "scatter",
    mode: "lines",
    name: plain(line.name),
    x: playback.times,
    y: line.values,
    customdata: playback.times,
    line: { color: hueOf(line, theme.value), width: line.name === TOTAL ? 2.4 : 1.8, dash: dashOf(line) as "solid" },
    hovertemplate: `${plain(line.name)} %{y:.4~g}<br>t = %{x:.4~g}<extra></extra>`,
  }));
  const axis = { gridcolor: grid, zerolinecolor: grid };
  return {
    data,
    layout: {
      xaxis: {
        ...axis,
        title: { text: "time" },
        range: [playback.times[0] as number, playback.times.at(-1) as number],
      },
      yaxis: { ...axis, title: { text: "energy", standoff: 10 }, tickformat: ".3~g", automargin: true },
      margin: { l: 64, r: 14, t: 10, b: 44 },
    },
  };
}

function describe(playback: Playback): string {
  const words = linesOf(playback).map(({ name, values }) => {
    const known = values.filter((value) => value !== null);
    return `${name} from ${number(known[0])} to ${number(known.at(-1))}`;
  });
  const { times } = playback;
  return `Energy from t = ${number(times[0])} to ${number(times.at(-1))}: ${words.join("; ")}.`;
}

function rows(playback: Playback): HTMLElement {
  const { times, contacts } = playback;
  const columns: Column<number>[] = [
    { title: "Time", head: true, cell: (frame) => number(times[frame], 5) },
    ...linesOf(playback).map(({ name, values }): Column<number> => ({
      title: name,
      figure: true,
      cell: (frame) => number(values[frame], 5),
    })),
    { title: "Contacts", figure: true, cell: (frame) => String(contacts.counts[frame] ?? NONE) },
    { title: "Deepest overlap", figure: true, cell: (frame) => number(contacts.deepest[frame]) },
  ];
  const caption = `Each frame of ${playback.name}`;
  return table({ caption, columns, rows: times.map((_, frame) => frame), hideCaption: true });
}

/** A click goes to the time. */
export function energyFigure(playback: Playback, seek: (time: number) => void): Figure {
  const hidden = new Set<string>();
  const lines = linesOf(playback);
  const shown = (name: string) => swatch(lines.find((line) => line.name === name) as Line);
  const made: Figure = figure({
    caption: "Energy against time",
    describe: () => describe(playback),
    height: () => 300,
    draw: () => draw(playback, hidden),
    table: () => h("div", { class: "frames-table" }, rows(playback)),
    legend: legend(
      "Kinds",
      lines.map(({ name }) => name),
      shown,
      hidden,
      () => made.redraw(),
    ),
    longTable: true,
    clicked: (time) => seek(Number(time)),
  });
  return made;
}
