// Pairs of superellipsoids that touch where they are said to: positions from the support points.
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const add = (a, b) => a.map((x, i) => x + b[i]);
const scale = (a, s) => a.map((x) => x * s);
const unit = (a) => scale(a, 1 / Math.hypot(...a));

const norm = (a, b, n) => {
  const larger = Math.max(a, b);
  return larger === 0 ? 0 : larger * ((a / larger) ** n + (b / larger) ** n) ** (1 / n);
};

export function turnOf([w, x, y, z]) {
  const s = Math.hypot(w, x, y, z);
  const [a, i, j, k] = [w / s, x / s, y / s, z / s];
  return [
    [1 - 2 * (j * j + k * k), 2 * (i * j - a * k), 2 * (i * k + a * j)],
    [2 * (i * j + a * k), 1 - 2 * (i * i + k * k), 2 * (j * k - a * i)],
    [2 * (i * k - a * j), 2 * (j * k + a * i), 1 - 2 * (i * i + j * j)],
  ];
}
const transposed = (rows) => [0, 1, 2].map((i) => rows.map((row) => row[i]));
const turned = (rows, x) => rows.map((row) => dot(row, x));

/** The point of the surface, from the centre, where the outward normal is `n`. */
export function support(axes, [n1, n2], rotation, n) {
  const u = turned(transposed(rotation), n);
  const scaled = u.map((x, i) => Math.abs(x * axes[i]));
  const q1 = n1 / (n1 - 1);
  const q2 = n2 / (n2 - 1);
  const round = norm(scaled[0], scaled[1], q2);
  const whole = norm(round, scaled[2], q1);
  const part = (x, total, q) => (total > 0 ? (x / total) ** (q - 1) : 0);
  const outer = part(round, whole, q1);
  const local = [
    Math.sign(u[0]) * axes[0] * part(scaled[0], round, q2) * outer,
    Math.sign(u[1]) * axes[1] * part(scaled[1], round, q2) * outer,
    Math.sign(u[2]) * axes[2] * part(scaled[2], whole, q1),
  ];
  return turned(rotation, local);
}

const direction = (random) => unit([random() - 0.5, random() - 0.5, random() - 0.5 + 1e-3]);

function bodyOf(random, kind, size) {
  const axes = [1, 1, 1].map(() => size * (0.5 + random()));
  if (kind.includes("needle")) axes[2] *= 1e3;
  if (kind.includes("disc")) axes[2] *= 1e-2;
  const exponents = kind.includes("blocky")
    ? [8 + 40 * random(), 6 + 30 * random()]
    : kind.includes("pointed")
      ? [1.15 + 0.5 * random(), 1.15 + 0.6 * random()]
      : [2, 2];
  return { axes, exponents, quaternion: [random() + 0.1, random() - 0.5, random() - 0.5, random() - 0.5] };
}

const inCase = ({ axes, exponents, quaternion }, position) => ({
  shape: {
    superellipsoid: exponents[0] === 2 && exponents[1] === 2 ? { semi_axes: axes } : { semi_axes: axes, exponents },
  },
  position,
  orientation: { quaternion_wxyz: quaternion },
});

const answerOf = (n, points, normals, overlap, more) => ({
  status: "converged",
  verdict: overlap > 0 ? "overlapping" : "separated",
  overlap,
  normal: n,
  points,
  normals,
  iterations: 7,
  angle_error_deg: null,
  ...more,
});

/** Bodies, the reference and an answer that is `tilt` radians off. */
export function contactPair(random, { kind, size, far, ratio, overlapRatio, tilt }) {
  const first = bodyOf(random, kind, size);
  const second = bodyOf(random, kind.replace("needle", ""), size * ratio);
  const n = direction(random);
  const [r1, r2] = [turnOf(first.quaternion), turnOf(second.quaternion)];
  const c1 = scale(direction(random), far);
  const overlap = overlapRatio * size * Math.min(1, ratio);
  const s2 = support(second.axes, second.exponents, r2, scale(n, -1));
  const p1 = add(c1, support(first.axes, first.exponents, r1, n));
  const p2 = add(p1, scale(n, -overlap));
  const c2 = add(p2, scale(s2, -1));
  const m = unit(add(n, scale(direction(random), tilt)));
  const q1 = add(c1, support(first.axes, first.exponents, r1, m));
  const q2 = add(c2, support(second.axes, second.exponents, r2, scale(m, -1)));
  const angle = (Math.acos(Math.min(1, dot(m, n))) * 180) / Math.PI;
  return {
    bodies: [inCase(first, c1), inCase(second, c2)],
    reference: answerOf(n, [p1, p2], [n, scale(n, -1)], overlap, { angle_error_deg: 0 }),
    answer: answerOf(m, [q1, q2], [m, scale(m, -1)], overlap * 1.3, { angle_error_deg: angle }),
  };
}
