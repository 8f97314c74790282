/** How far each method's normal is from the common one, over two angles of the pair; and of random pairs, how often. */
import type { StudyMap, StudyShare } from "../../data";
import { type Child, fill, h, select } from "../../dom";
import { inOrder } from "../../methods";
import { count, interval, NONE, number, percent } from "../../numbers";
import { figure } from "../../plot";
import { methodName } from "../../swatch";
import { type Column, table } from "../../table";
import { SCALES } from "../atlas_plot";
import { MAP_RANGE, mapDrawing } from "./study_plot";
import { angleCell, describeMap, mapWords } from "./study_words";

type Choice = Pick<StudyMap, "aspect" | "phi_deg" | "ratio">;

function mapTable(map: StudyMap): HTMLElement {
  const columns: Column<number>[] = map.theta_deg.map((theta, k) => ({
    title: number(theta),
    figure: true,
    cell: (row) => angleCell(map.off_deg[row]?.[k]),
  }));
  const head: Column<number> = { title: "θ_L \\ θ, °", head: true, cell: (row) => number(map.theta_L_deg[row]) };
  const rows = map.theta_L_deg.map((_, row) => row);
  return table({ caption: `Degrees off, ${map.method}`, columns: [head, ...columns], rows, hideCaption: true });
}

function mapFigure(map: StudyMap): HTMLElement {
  const { element } = figure({
    caption: map.method,
    describe: () => describeMap(map),
    height: (width) => Math.min(320, Math.max(230, 0.66 * width)),
    draw: () => mapDrawing(map),
    table: () => mapTable(map),
    zoom: false,
    longTable: true,
  });
  element.append(h("p", { class: "note" }, `${mapWords(map)}.`));
  return element;
}

function maps(all: StudyMap[], { aspect, phi_deg, ratio }: Choice): HTMLElement[] {
  const chosen = all.filter((map) => map.aspect === aspect && map.phi_deg === phi_deg && map.ratio === ratio);
  if (chosen.length === 0) return [h("p", { class: "empty" }, "There is no map of this choice.")];
  const order = inOrder(chosen.map(({ method }) => method));
  return order.flatMap((method) => chosen.filter((map) => map.method === method)).map(mapFigure);
}

function colourKey(): HTMLElement {
  const colours = SCALES.light.map((light, index) => `light-dark(${light}, ${SCALES.dark[index]})`);
  const bar = h("span", { class: "scale-bar", style: `background: linear-gradient(90deg, ${colours.join(", ")})` });
  const [least, most] = MAP_RANGE.map((deg) => number(deg));
  return h(
    "p",
    { class: "scale-key" },
    `${least}° or less`,
    bar,
    `${most}°, logarithmic; `,
    h("span", { class: "none-key", "aria-hidden": "true" }, "×"),
    " no answer",
  );
}

export function mapsBlock(all: StudyMap[]): Child[] {
  const [first] = all;
  if (!first) return [];
  const chosen: Choice = { aspect: first.aspect, phi_deg: first.phi_deg, ratio: first.ratio };
  const place = h("div", { class: "panels" });
  const redraw = () => fill(place, ...maps(all, chosen));
  const choice = (label: string, key: keyof Choice) => {
    const values = [...new Set(all.map((map) => map[key]))].sort((a, b) => a - b);
    return select(
      label,
      values.map((value) => [String(value), number(value)]),
      String(chosen[key]),
      (value) => {
        chosen[key] = Number(value);
        redraw();
      },
    );
  };
  redraw();
  return [
    h("h3", {}, "Maps"),
    h(
      "p",
      { class: "note" },
      "Body 2 on the line of zenith θ_L, turned by the Euler angles φ and θ: degrees to the common normal.",
    ),
    h(
      "div",
      { id: "study-maps" },
      h(
        "div",
        { class: "controls" },
        choice("Aspect", "aspect"),
        choice("φ, °", "phi_deg"),
        choice("Overlap ratio", "ratio"),
      ),
      colourKey(),
      place,
    ),
  ];
}

type ShareRow = Pick<StudyShare, "aspect" | "ratio">;

function shareCell(share: StudyShare | undefined): Child[] {
  if (!share) return [NONE];
  const { answers, off, low, high, pairs, median_deg } = share;
  return [
    h("span", {}, answers > 0 ? `${percent(off / answers)} %` : NONE),
    h("small", {}, interval(low, high)),
    median_deg !== null && h("small", {}, `median ${number(median_deg)}°`),
    answers < pairs && h("small", {}, `${count(pairs - answers)} no answer`),
  ];
}

function shareRows(shares: StudyShare[]): ShareRow[] {
  const rows = new Map(shares.map(({ aspect, ratio }) => [`${aspect} ${ratio}`, { aspect, ratio }]));
  return [...rows.values()].sort((a, b) => a.aspect - b.aspect || a.ratio - b.ratio);
}

export function sharesBlock(shares: StudyShare[]): Child[] {
  if (shares.length === 0) return [];
  const columns = inOrder(shares.map(({ method }) => method)).map((method): Column<ShareRow> => ({
    title: methodName(method),
    cell: ({ aspect, ratio }) =>
      shareCell(shares.find((one) => one.method === method && one.aspect === aspect && one.ratio === ratio)),
  }));
  const head: Column<ShareRow> = {
    title: "Pairs",
    head: true,
    cell: ({ aspect, ratio }) => [
      h("span", {}, `aspect ${number(aspect)}`),
      h("small", {}, `overlap ratio ${number(ratio)}`),
    ],
  };
  const pairs = [...new Set(shares.map((share) => count(share.pairs)))].join(" or ");
  const caption = `Of ${pairs} random pairs: answers more than 0.01° off, their 95 % interval, the median angle`;
  return [
    h("h3", {}, "How often"),
    h("div", { class: "stacked" }, table({ caption, columns: [head, ...columns], rows: shareRows(shares) })),
  ];
}
