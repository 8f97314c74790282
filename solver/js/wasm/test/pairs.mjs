// Random pairs as case files, the same for the same seed: every shape class, from apart to deep in each other.

/** mulberry32: 32 bits of state are enough for pairs that are all the same to every method. */
export function stream(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

const between = (random, low, high) => low + (high - low) * random();

function direction(random) {
  const z = between(random, -1, 1);
  const angle = between(random, 0, 2 * Math.PI);
  const r = Math.sqrt(1 - z * z);
  return [r * Math.cos(angle), r * Math.sin(angle), z];
}

/** Uniform over rotations (Shoemake). */
function quaternion(random) {
  const [u, a, b] = [random(), between(random, 0, 2 * Math.PI), between(random, 0, 2 * Math.PI)];
  const [r, s] = [Math.sqrt(1 - u), Math.sqrt(u)];
  return [r * Math.sin(a), r * Math.cos(a), s * Math.sin(b), s * Math.cos(b)];
}

const SHAPES = {
  spheroid: (random) => {
    const aspect = 2 ** between(random, -2, 2);
    return { semi_axes: [1, 1, aspect], exponents: [2, 2] };
  },
  ellipsoid: (random) => ({ semi_axes: [0, 1, 2].map(() => 2 ** between(random, -2, 0)), exponents: [2, 2] }),
  superellipsoid: (random) => ({
    semi_axes: [0, 1, 2].map(() => 2 ** between(random, -2, 0)),
    exponents: [between(random, 1.3, 8), between(random, 1.3, 8)],
  }),
};

/** How far the surface is from the centre along a direction of the world; roughly is enough, for a distance that is random anyway. */
function reach({ semi_axes: [a, b, c], exponents: [n1, n2] }, [w, x, y, z], [u, v, t]) {
  const local = [
    (1 - 2 * (y * y + z * z)) * u + 2 * (x * y + w * z) * v + 2 * (x * z - w * y) * t,
    2 * (x * y - w * z) * u + (1 - 2 * (x * x + z * z)) * v + 2 * (y * z + w * x) * t,
    2 * (x * z + w * y) * u + 2 * (y * z - w * x) * v + (1 - 2 * (x * x + y * y)) * t,
  ];
  const [p, q, s] = [local[0] / a, local[1] / b, local[2] / c].map(Math.abs);
  return 1 / ((p ** n2 + q ** n2) ** (n1 / n2) + s ** n1) ** (1 / n1);
}

const body = (shape, position, turn) => ({
  shape: { superellipsoid: shape },
  position,
  orientation: { quaternion_wxyz: turn },
});

/** `count` cases; shape classes take turns. */
export function* pairs(count, seed) {
  const random = stream(seed);
  const classes = Object.keys(SHAPES);
  for (let index = 0; index < count; index++) {
    const family = classes[index % classes.length];
    const shapes = [SHAPES[family](random), SHAPES[family](random)];
    const turns = [quaternion(random), quaternion(random)];
    const line = direction(random);
    const back = line.map((x) => -x);
    const touch = reach(shapes[0], turns[0], line) + reach(shapes[1], turns[1], back);
    const distance = touch * (1 - between(random, -0.2, 0.2));
    const place = [0, 1, 2].map(() => between(random, -1, 1));
    const second = place.map((x, i) => x + distance * line[i]);
    yield {
      format: "plumb/case-1",
      name: `${family} ${index}`,
      bodies: [body(shapes[0], place, turns[0]), body(shapes[1], second, turns[1])],
    };
  }
}
