import type { Playback } from "../data";

/** Whether forces come from what both bodies have in common: then a contact's point is the centre of that. */
export const usesPatch = ({ effects }: Playback): boolean =>
  effects.some(({ name, on }) => on && (name === "volume" || name === "foundation"));

/** Frames with more contacts show no patches: each takes about a millisecond. */
export const MOST_PATCHES = 100;
