/** What the reader has set: body 1 at the origin, body 2 at a distance along a line. */
import type { Pair } from "../../plumb-contact/plumb_contact.mjs";
import type { Vec } from "../../page/src/data";
import { scale } from "../../page/src/view3d/vector";
import { directionOf, quaternionOf } from "./rotation";

export interface Solid {
  axes: Vec;
  exponents: [number, number];
  /** Degrees, zxz. */
  euler: Vec;
}

export interface Setting {
  solids: [Solid, Solid];
  /** Zenith and azimuth, degrees. */
  line: [number, number];
  distance: number;
}

export const copyOf = (setting: Setting): Setting => structuredClone(setting);

/** Coordinates that should be 0, and are 1e-17, are. */
const tidy = (v: Vec): Vec => v.map((x) => (Math.abs(x) < 1e-15 ? 0 : x)) as Vec;

export const positionOf = ({ line, distance }: Setting): Vec => tidy(scale(directionOf(line), distance));

export function pairOf(setting: Setting): Pair {
  const body = ({ axes, exponents, euler }: Solid, position: Vec) => ({
    semi_axes: axes,
    exponents,
    position,
    quaternion: quaternionOf(euler),
  });
  const [first, second] = setting.solids;
  return { bodies: [body(first, [0, 0, 0]), body(second, positionOf(setting))] };
}

export const sizeOf = ({ solids }: Setting): number => Math.max(...solids.flatMap(({ axes }) => axes));

/** A file for `plumb solve`: the very doubles that are solved here. */
export function caseOf(setting: Setting): string {
  const body = ({ semi_axes, exponents, position, quaternion }: Pair["bodies"][0]) => ({
    shape: { superellipsoid: { semi_axes, exponents } },
    position,
    orientation: { quaternion_wxyz: quaternion },
  });
  const bodies = pairOf(setting).bodies.map(body);
  const lines = bodies.map((one) => `    ${JSON.stringify(one)}`).join(",\n");
  return `{ "format": "plumb/case-1",\n  "bodies": [\n${lines} ] }`;
}

/** "1,1,0.4,2,2,0,0,0;..;75.07,180,1.552": all that is set, each number to its last digit. */
export function wordOf({ solids, line, distance }: Setting): string {
  const parts = solids.map(({ axes, exponents, euler }) => [...axes, ...exponents, ...euler].join(","));
  return [...parts, [...line, distance].join(",")].join(";");
}

/** "%3B" -> ";"; as it is where it is no such text. */
function decoded(word: string): string {
  try {
    return decodeURIComponent(word);
  } catch {
    return word;
  }
}

/** Null where it is no setting. */
export function settingOf(word: string): Setting | null {
  const [a, b, place, ...rest] = decoded(word)
    .split(";")
    .map((part) => part.split(",").map((x) => (x.trim() === "" ? Number.NaN : Number(x))));
  const all = [...(a ?? []), ...(b ?? []), ...(place ?? [])];
  if (a?.length !== 8 || b?.length !== 8 || place?.length !== 3 || rest.length > 0) return null;
  if (!all.every(Number.isFinite)) return null;
  const solid = (x: number[]): Solid => ({
    axes: x.slice(0, 3) as Vec,
    exponents: x.slice(3, 5) as [number, number],
    euler: x.slice(5) as Vec,
  });
  const setting: Setting = { solids: [solid(a), solid(b)], line: [place[0]!, place[1]!], distance: place[2]! };
  const legal = setting.solids.every(
    ({ axes, exponents }) => axes.every((x) => x > 0) && exponents.every((n) => n > 1),
  );
  return legal && setting.distance >= 0 ? setting : null;
}
