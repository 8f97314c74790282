/** Euler angles of the case files, R = Rz(phi) Rx(theta) Rz(psi), in degrees. */
import type { Vec } from "../../page/src/data";
import { type Turn, turned } from "../../page/src/view3d/vector";

export type Quaternion = [number, number, number, number];

const RADIANS = Math.PI / 180;

export function quaternionOf([phi, theta, psi]: Vec): Quaternion {
  const [half, sum, difference] = [theta / 2, (phi + psi) / 2, (phi - psi) / 2].map((x) => x * RADIANS) as Vec;
  const [c, s] = [Math.cos(half), Math.sin(half)];
  return [c * Math.cos(sum), s * Math.cos(difference), s * Math.sin(difference), c * Math.sin(sum)];
}

const within = (degrees: number): number => ((degrees % 360) + 360) % 360;

/** Rows of a rotation to angles; where theta is 0 or 180 psi is 0. */
export function eulerOf([x, y, z]: Turn): Vec {
  const slant = Math.hypot(x[2], y[2]);
  const theta = Math.atan2(slant, z[2]) / RADIANS;
  if (slant < 1e-9) return [within(Math.atan2(y[0], x[0]) / RADIANS), theta, 0];
  return [within(Math.atan2(x[2], -y[2]) / RADIANS), theta, within(Math.atan2(z[0], z[1]) / RADIANS)];
}

/** About a unit axis; rows. */
export function turnAbout([x, y, z]: Vec, radians: number): Turn {
  const [c, s] = [Math.cos(radians), Math.sin(radians)];
  const t = 1 - c;
  return [
    [t * x * x + c, t * x * y - s * z, t * x * z + s * y],
    [t * x * y + s * z, t * y * y + c, t * y * z - s * x],
    [t * x * z - s * y, t * y * z + s * x, t * z * z + c],
  ];
}

/** a after b. */
export function composed(a: Turn, b: Turn): Turn {
  const columns = [0, 1, 2].map((i) => turned(a, b.map((row) => row[i]) as Vec));
  return [0, 1, 2].map((i) => columns.map((column) => column[i])) as Turn;
}

/** Zenith from z and azimuth, degrees, as `line_deg`. */
export function directionOf([zenith, azimuth]: [number, number]): Vec {
  const [t, p] = [zenith * RADIANS, azimuth * RADIANS];
  return [Math.sin(t) * Math.cos(p), Math.sin(t) * Math.sin(p), Math.cos(t)];
}

export function lineOf([x, y, z]: Vec): [number, number] {
  return [Math.atan2(Math.hypot(x, y), z) / RADIANS, within(Math.atan2(y, x) / RADIANS)];
}
