/** Names of certificates beside their points, none over another. What finds no room is named on hover. */
import type { Annotations } from "plotly.js";

/** A point with its name, in pixels of the panel, and where it is on the axes. */
export interface Named {
  text: string;
  colour: string;
  at: [number, number];
  pixel: [number, number];
}

const LETTER = 7;
const LINE = 16;
/** Of a point's middle to its name. */
const BESIDE = 10;
/** Half a point. */
const HALF = 7;
const SHIFTS = [0, -LINE, LINE, -2 * LINE, 2 * LINE];

interface Box {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

const meet = (a: Box, b: Box): boolean => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

const around = ([x, y]: [number, number]): Box => ({
  left: x - HALF,
  right: x + HALF,
  top: y - HALF,
  bottom: y + HALF,
});

function boxOf({ text, pixel: [x, y] }: Named, side: number, shift: number): Box {
  const [near, far] = [x + side * BESIDE, x + side * (BESIDE + LETTER * text.length)];
  const middle = y + shift;
  return { left: Math.min(near, far), right: Math.max(near, far), top: middle - LINE / 2, bottom: middle + LINE / 2 };
}

export interface PlacedName {
  named: Named;
  side: number;
  shift: number;
  box: Box;
}

/** The first come has the best place; `width` is the panel's. */
export function placedNames(all: Named[], width: number): PlacedName[] {
  const taken = all.map(({ pixel }) => around(pixel));
  return all.flatMap((named) => {
    for (const side of [1, -1])
      for (const shift of SHIFTS) {
        const box = boxOf(named, side, shift);
        if (box.left < 0 || box.right > width || taken.some((other) => meet(box, other))) continue;
        taken.push(box);
        return [{ named, side, shift, box }];
      }
    return [];
  });
}

export const nameAnnotations = (all: Named[], width: number): Partial<Annotations>[] =>
  placedNames(all, width).map(({ named: { text, colour, at }, side, shift }) => ({
    xref: "x",
    yref: "y",
    x: at[0],
    y: at[1],
    text,
    showarrow: false,
    xanchor: side > 0 ? "left" : "right",
    yanchor: "middle",
    xshift: side * BESIDE,
    yshift: -shift,
    font: { size: 12, color: colour },
  }));
