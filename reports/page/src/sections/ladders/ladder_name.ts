import { breakable, h } from "../../dom";
import type { Column } from "../../table";

/** The first column of a table of ladders. */
export const LADDER_NAME: Column<{ name: string; knob: string }> = {
  title: "Ladder",
  head: true,
  cell: (ladder) => [breakable(ladder.name), " ", h("small", {}, breakable(ladder.knob))],
};
