/** Plotly's symbols beside words: legends are lists that wrap, are read aloud, and hide no point. */
import { breakable, checkbox, h } from "./dom";
import { cssColourOf, DASHES, isForeign, isOwn, plainName, symbolOf } from "./methods";

const PATHS: Record<string, string> = {
  circle: "M13 8A5 5 0 1 1 3 8A5 5 0 1 1 13 8Z",
  square: "M3.5 3.5h9v9h-9Z",
  diamond: "M8 2l6 6l-6 6l-6-6Z",
  "triangle-up": "M8 3l5.5 9.5h-11Z",
  "triangle-down": "M8 13l5.5-9.5h-11Z",
  "triangle-left": "M3 8l9.5-5.5v11Z",
  "triangle-right": "M13 8l-9.5-5.5v11Z",
  pentagon: "M8 2.5l5.5 4l-2.1 6.5h-6.8l-2.1-6.5Z",
  x: "M3 5l2-2l3 3l3-3l2 2l-3 3l3 3l-2 2l-3-3l-3 3l-2-2l3-3Z",
  cross: "M6.5 2.5h3v4h4v3h-4v4h-3v-4h-4v-3h4Z",
  star: "M8 2l1.6 4.2h4.4l-3.5 2.7l1.3 4.4l-3.8-2.6l-3.8 2.6l1.3-4.4l-3.5-2.7h4.4Z",
  hexagon: "M8 2l5.2 3v6l-5.2 3l-5.2-3v-6Z",
  "star-diamond": "M8 2l2 4l4 2l-4 2l-2 4l-2-4l-4-2l4-2Z",
  hourglass: "M3 3h10l-10 10h10Z",
  bowtie: "M3 3v10l10-10v10Z",
};

function svg(name: string, attributes: Record<string, string>): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
}

export function methodSwatch(method: string): SVGElement {
  const picture = svg("svg", { viewBox: "0 0 16 16", class: "swatch", "aria-hidden": "true" });
  const d = PATHS[symbolOf(method)] ?? (PATHS.circle as string);
  picture.append(svg("path", { d, style: `fill: ${cssColourOf(method)}` }));
  return picture;
}

export function methodName(method: string): HTMLElement {
  const mark = isForeign(method)
    ? h(
        "span",
        { class: "own", title: "A solver that was brought along (--solver): its findings are its defects" },
        "judged",
      )
    : isOwn(method)
      ? h("span", { class: "own", title: "Plumb's own: its findings are defects" }, "own")
      : null;
  return h("span", { class: "method" }, methodSwatch(method), breakable(plainName(method)), mark);
}

const DASH_ARRAYS: Record<string, string> = { solid: "", dash: "6 3", dot: "2 3", dashdot: "6 3 2 3" };

export function scalarSwatch(scalar: string): SVGElement {
  const picture = svg("svg", { viewBox: "0 0 28 16", class: "swatch wide", "aria-hidden": "true" });
  const isDouble = scalar === "double";
  const dashes = DASH_ARRAYS[DASHES[scalar] ?? "dashdot"] ?? "";
  picture.append(
    svg("path", { d: "M1 8h26", stroke: "currentColor", "stroke-width": "1.6", "stroke-dasharray": dashes }),
    svg("circle", {
      cx: "14",
      cy: "8",
      r: "3.4",
      fill: isDouble ? "currentColor" : "var(--paper)",
      stroke: "currentColor",
    }),
  );
  return picture;
}

/** A legend whose entries can be switched off; `hidden` says which are, and follows the boxes. */
export function legend(
  label: string,
  names: string[],
  show: (name: string) => Node,
  hidden: Set<string>,
  changed: () => void,
): HTMLElement {
  const entry = (name: string) =>
    checkbox(show(name), !hidden.has(name), (on) => {
      if (on) hidden.delete(name);
      else hidden.add(name);
      changed();
    });
  return h("fieldset", { class: "legend" }, h("legend", {}, label), ...names.map(entry));
}
