/** ((|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1)^(1/n1): the gauge, 1 on the surface, and its gradient. */
import type { Vec } from "../data";

export interface Shape {
  axes: Vec;
  exponents: [number, number];
}

/** (a^n + b^n)^(1/n) of sizes, without overflow. */
export function norm(a: number, b: number, n: number): number {
  const larger = Math.max(a, b);
  if (larger === 0) return 0;
  return larger * (1 + (Math.min(a, b) / larger) ** n) ** (1 / n);
}

/** d norm(a, b, n) / d a. */
const slope = (a: number, whole: number, n: number): number => (whole > 0 ? (a / whole) ** (n - 1) : 0);

export interface Gauge {
  value: number;
  gradient: Vec;
}

export function gauge({ axes, exponents: [n1, n2] }: Shape, [x, y, z]: Vec): Gauge {
  const [u, v, w] = [Math.abs(x / axes[0]), Math.abs(y / axes[1]), Math.abs(z / axes[2])];
  const round = norm(u, v, n2);
  const value = norm(round, w, n1);
  const outer = slope(round, value, n1);
  const gradient: Vec = [
    (Math.sign(x) * outer * slope(u, round, n2)) / axes[0],
    (Math.sign(y) * outer * slope(v, round, n2)) / axes[1],
    (Math.sign(z) * slope(w, value, n1)) / axes[2],
  ];
  return { value, gradient };
}

/** Closer to the axis of a pointed shape, closer to the edge of a blocky one: where it bends. */
function graded(t: number, n: number): number {
  const k = n > 2 ? Math.min(2.6, 1 + 0.35 * Math.log2(n / 2)) : 1 + 1.1 * (2 - n);
  const bent = n > 2 ? 1 - (1 - t) ** k : t ** k;
  return Math.tan((bent * Math.PI) / 4);
}

/**
 * The quarter |u|^n + |v|^n = 1 from (1, 0) to (0, 1) in 2 `half` steps, by rays through the unit square: its corner is the edge
 * of a blocky shape, and the axes the creases of a pointed one, so that both lie on lines of the mesh.
 */
export function quarter(n: number, half: number): [number, number][] {
  const ray = (u: number, v: number): [number, number] => [u / norm(u, v, n), v / norm(u, v, n)];
  const points: [number, number][] = [];
  for (let i = 0; i <= half; i++) points.push(ray(1, graded(i / half, n)));
  for (let i = half - 1; i >= 0; i--) points.push(ray(graded(i / half, n), 1));
  return points;
}

/** The whole curve, closed: the last point is the first. */
export function loop(n: number, half: number): [number, number][] {
  const part = quarter(n, half);
  const turns: [number, number][] = [];
  const quarters: ((u: number, v: number) => [number, number])[] = [
    (u, v) => [u, v],
    (u, v) => [-v, u],
    (u, v) => [-u, -v],
    (u, v) => [v, -u],
  ];
  for (const turn of quarters) for (const [u, v] of part.slice(0, -1)) turns.push(turn(u, v));
  turns.push(part[0] as [number, number]);
  return turns;
}
