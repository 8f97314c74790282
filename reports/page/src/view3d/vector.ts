import type { Vec } from "../data";

export const add = (a: Vec, b: Vec): Vec => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vec, s: number): Vec => [a[0] * s, a[1] * s, a[2] * s];
export const divide = (a: Vec, s: number): Vec => [a[0] / s, a[1] / s, a[2] / s];
export const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec, b: Vec): Vec => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const length = (a: Vec): number => Math.hypot(...a);
export const middle = (a: Vec, b: Vec): Vec => [a[0] / 2 + b[0] / 2, a[1] / 2 + b[1] / 2, a[2] / 2 + b[2] / 2];
export const isFinite3 = (a: Vec | null | undefined): a is Vec => !!a && a.every((x) => Number.isFinite(x));

/** Of any length but none; by the largest part first, so that nothing under- or overflows. */
export function unit(a: Vec): Vec {
  const largest = Math.max(...a.map(Math.abs));
  if (!(largest > 0)) return [0, 1, 0];
  const near = divide(a, largest);
  return divide(near, length(near));
}

/** Some direction across `n`. */
export function across(n: Vec): Vec {
  const [x, y, z] = n.map(Math.abs) as Vec;
  const axis: Vec = x <= y && x <= z ? [1, 0, 0] : y <= z ? [0, 1, 0] : [0, 0, 1];
  return unit(cross(n, axis));
}

/** Rows of a rotation. */
export type Turn = [Vec, Vec, Vec];
export const turned = (rows: Turn, a: Vec): Vec => [dot(rows[0], a), dot(rows[1], a), dot(rows[2], a)];
export const turnedBack = (rows: Turn, a: Vec): Vec =>
  add(add(scale(rows[0], a[0]), scale(rows[1], a[1])), scale(rows[2], a[2]));

/** From body to world axes; the quaternion may have any length. */
export function turnOf([w, x, y, z]: [number, number, number, number]): Turn {
  const largest = Math.max(Math.abs(w), Math.abs(x), Math.abs(y), Math.abs(z)) || 1;
  const near = [w, x, y, z].map((part) => part / largest);
  const size = Math.hypot(...near) || 1;
  const [s, i, j, k] = near.map((part) => part / size) as [number, number, number, number];
  return [
    [1 - 2 * (j * j + k * k), 2 * (i * j - s * k), 2 * (i * k + s * j)],
    [2 * (i * j + s * k), 1 - 2 * (i * i + k * k), 2 * (j * k - s * i)],
    [2 * (i * k - s * j), 2 * (j * k + s * i), 1 - 2 * (i * i + j * j)],
  ];
}
