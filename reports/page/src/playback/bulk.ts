/** Packing fraction, on the left, and contacts a body, on the right, against time. */
import type { Data } from "plotly.js";
import type { Playback } from "../data";
import { h } from "../dom";
import { number } from "../numbers";
import { type Drawing, type Figure, figure } from "../plot";
import { type Column, table } from "../table";
import { ink, theme } from "../theme";

const HUES = { light: ["#00795a", "#c44e00"], dark: ["#27c39a", "#ff8a45"] };

interface Measure {
  name: string;
  key: string;
  axis: "y" | "y2";
}

const MEASURES: Measure[] = [
  { name: "packing fraction", key: "packing_fraction", axis: "y" },
  { name: "contacts a body", key: "coordination", axis: "y2" },
];

const valuesOf = ({ bulk }: Playback, { key }: Measure): (number | null)[] => bulk[key] ?? [];

function draw(playback: Playback): Drawing {
  const { grid } = ink();
  const hues = HUES[theme.value];
  const data = MEASURES.map((measure, index): Data => ({
    type: "scatter",
    mode: "lines",
    name: measure.name,
    x: playback.times,
    y: valuesOf(playback, measure),
    yaxis: measure.axis,
    customdata: playback.times,
    line: { color: hues[index] as string, width: 2, dash: index === 0 ? "solid" : "dash" },
    hovertemplate: `${measure.name} %{y:.4~g}<br>t = %{x:.4~g}<extra></extra>`,
  }));
  const titled = ({ name }: Measure, index: number) => ({
    title: { text: name, standoff: 10, font: { color: hues[index] as string } },
    rangemode: "tozero" as const,
    automargin: true,
  });
  return {
    data,
    layout: {
      xaxis: {
        gridcolor: grid,
        zerolinecolor: grid,
        title: { text: "time" },
        range: [playback.times[0] as number, playback.times.at(-1) as number],
      },
      yaxis: { ...titled(MEASURES[0] as Measure, 0), gridcolor: grid, zerolinecolor: grid },
      yaxis2: {
        ...titled(MEASURES[1] as Measure, 1),
        overlaying: "y",
        side: "right",
        showgrid: false,
        tickmode: "auto",
      },
      margin: { l: 64, r: 64, t: 10, b: 44 },
    },
  };
}

function describe(playback: Playback): string {
  const words = MEASURES.map((measure) => {
    const known = valuesOf(playback, measure).filter((value) => value !== null);
    return `${measure.name} from ${number(known[0])} to ${number(known.at(-1))}`;
  });
  return `The packing from t = ${number(playback.times[0])} to ${number(playback.times.at(-1))}: ${words.join("; ")}.`;
}

function rows(playback: Playback): HTMLElement {
  const columns: Column<number>[] = [
    { title: "Time", head: true, cell: (frame) => number(playback.times[frame], 5) },
    ...MEASURES.map((measure): Column<number> => ({
      title: measure.name,
      figure: true,
      cell: (frame) => number(valuesOf(playback, measure)[frame], 5),
    })),
  ];
  const caption = `The packing in each frame of ${playback.name}`;
  return table({ caption, columns, rows: playback.times.map((_, frame) => frame), hideCaption: true });
}

/** null where the scene does not write bulk. A click goes to the time. */
export function bulkFigure(playback: Playback, seek: (time: number) => void): Figure | null {
  if (Object.keys(playback.bulk).length === 0) return null;
  return figure({
    caption: "Packing against time",
    describe: () => describe(playback),
    height: () => 260,
    draw: () => draw(playback),
    table: () => h("div", { class: "frames-table" }, rows(playback)),
    longTable: true,
    clicked: (time) => seek(Number(time)),
  });
}
