/** What colours bodies: which they are, how fast they move, how many they touch. */
import { count, number } from "../numbers";
import type { Playback } from "../data";
import { type Frames, quantile } from "./frames";

export type Colouring = "body" | "speed" | "contacts";
export const COLOURINGS: [Colouring, string][] = [
  ["body", "body"],
  ["speed", "speed"],
  ["contacts", "number of contacts"],
];

export const BODY_COLOURS = ["#4c84b6", "#d98b4a", "#5a9e6f", "#b0659a", "#8a7fc0", "#c2a13c", "#5aa5ad", "#b9605c"];
export const FIXED_COLOUR = "#8b939b";
/** From the least to the most, ever lighter; the least can be told from a dark page. */
export const SCALE = ["#5b3a9e", "#3f78b5", "#2aa192", "#7ccf5a", "#fde725"];

const SAMPLES = 40000;

/** What a scale's upper end stands for. */
export interface Scaled {
  most: number;
  values: (frame: number, out: Float32Array) => void;
  /** At the ends of the scale. */
  low: string;
  high: string;
}

function mostSpeed(frames: Frames): number {
  const stride = Math.max(1, Math.ceil((frames.count * frames.bodies) / SAMPLES));
  const speeds = new Float32Array(frames.bodies);
  const all: number[] = [];
  for (let frame = 0; frame < frames.count; frame += stride) {
    frames.speeds(frame, speeds);
    all.push(...speeds);
  }
  return quantile(all, 0.99);
}

function mostContacts(frames: Frames): number {
  const counts = new Float32Array(frames.bodies);
  let most = 0;
  for (let frame = 0; frame < frames.count; frame++) {
    frames.contactCounts(frame, counts);
    for (const n of counts) most = Math.max(most, n);
  }
  return most;
}

export function scaled(colouring: Exclude<Colouring, "body">, playback: Playback, frames: Frames): Scaled {
  if (colouring === "contacts") {
    const most = mostContacts(frames);
    return {
      most,
      values: (frame, out) => frames.contactCounts(frame, out),
      low: "0",
      high: `${count(most)} contacts`,
    };
  }
  const most = mostSpeed(frames);
  return {
    most,
    values: (frame, out) => frames.speeds(frame, out),
    low: "0",
    high: `${number(most * playback.size)} and more`,
  };
}
