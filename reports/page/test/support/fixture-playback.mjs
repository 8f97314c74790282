// The lines of a playback.jsonl as plumb scene would write them, and what plumb report makes of them: bodies that fall into a box.
import { makeReport, stream } from "./fixture.mjs";

const SHAPES = [
  { semi_axes: [0.5, 0.5, 0.5], exponents: [2, 2] },
  { semi_axes: [0.55, 0.42, 0.36], exponents: [2, 2] },
  { semi_axes: [0.42, 0.42, 0.42], exponents: [8, 8] },
  { semi_axes: [0.4, 0.4, 0.5], exponents: [6, 2] },
];
const EFFECTS = [
  ["gravity", true, "the scene asks for it"],
  ["elastic contact", true, "always, where bodies touch"],
  ["rolling resistance", false, "no coefficient is given"],
  ["cohesion", false, "no surface energy is given"],
];
const LONG = 2;
const GRAVITY = 9.81;

/** Where each comes to lie, and from how high. */
function beds(random, bodies) {
  const wide = Math.max(1, Math.round(Math.cbrt(bodies)));
  return Array.from({ length: bodies }, (_, index) => {
    const [column, layer] = [index % (wide * wide), Math.floor(index / (wide * wide))];
    const shift = layer % 2 === 0 ? 0.2 : -0.2;
    return {
      x: 0.95 * ((column % wide) - (wide - 1) / 2) + shift * random(),
      y: 0.95 * (Math.floor(column / wide) - (wide - 1) / 2) + shift * random(),
      z: 0.45 + 0.82 * layer,
      drop: 1 + 0.6 * layer + random(),
      turn: [1, random() - 0.5, random() - 0.5, random() - 0.5],
      spin: 4 * (random() - 0.5),
    };
  });
}

/** Above its bed: it falls, and bounces once. */
function height({ drop }, time) {
  const landed = Math.sqrt((2 * drop) / GRAVITY);
  if (time < landed) return drop - (GRAVITY * time * time) / 2;
  const speed = 0.3 * Math.sqrt(2 * GRAVITY * drop);
  const after = time - landed;
  return Math.max(0, speed * after - (GRAVITY * after * after) / 2);
}

function frameAt(time, all, touching, wallPoints) {
  const heights = all.map((bed) => height(bed, time));
  const position = all.flatMap(({ x, y, z }, body) => [x, y, z + heights[body]]);
  const orientation = all.flatMap(({ turn, spin, drop }) => {
    const angle = spin * Math.min(time, Math.sqrt((2 * drop) / GRAVITY));
    const size = Math.hypot(...turn.slice(1)) || 1;
    return [Math.cos(angle), ...turn.slice(1).map((part) => (Math.sin(angle) * part) / size)];
  });
  const contacts = touching
    .filter(({ pair }) => pair.every((body) => (heights[body] ?? 0) < 0.02))
    .map(({ pair, point, normal, force }) => [...pair, ...point, ...normal, 1e-4 * force, force]);
  const potential = heights.reduce((sum, high, body) => sum + GRAVITY * (high + all[body].z), 0);
  const kinetic = all.reduce(
    (sum, { drop }, body) => sum + (heights[body] > 0 ? GRAVITY * (drop - heights[body]) : 0),
    0,
  );
  const elastic = 1e-2 * contacts.length;
  const energy = { kinetic, elastic, gravity: potential, total: kinetic + elastic + potential };
  const coordination = contacts.length > 0 ? (2 * contacts.length) / all.length : null;
  const bulk = { packing_fraction: 0.2 + (0.4 * time) / LONG, coordination };
  return { time, position, orientation, wall: wallPoints.flat(), contacts, energy, bulk };
}

/** Neighbours in their beds, and the lowest with the floor. */
function neighbours(random, all, nearest) {
  const found = [];
  const reach = 1.1;
  all.forEach((a, i) => {
    if (a.z < 0.5)
      found.push({ pair: [i, all.length], point: [a.x, a.y, 0], normal: [0, 0, -1], force: 8 + 20 * random() });
    for (let j = i + 1; j < Math.min(all.length, i + nearest); j++) {
      const d = [all[j].x - a.x, all[j].y - a.y, all[j].z - a.z];
      const far = Math.hypot(...d);
      if (far > reach) continue;
      const normal = d.map((part) => part / far);
      found.push({
        pair: [i, j],
        point: d.map((part, k) => [a.x, a.y, a.z][k] + part / 2),
        normal,
        force: 30 * random() ** 2,
      });
    }
  });
  return found;
}

export function playbackLines({ scene = "pile", bodies = 60, frames = 41, ended = true, seed = 5 } = {}) {
  const random = stream(seed);
  const all = beds(random, bodies);
  const wide = 0.5 * Math.max(1, Math.round(Math.cbrt(bodies))) + 0.2;
  const walls = [
    [0, 0, 1],
    [1, 0, 0],
    [-1, 0, 0],
    [0, 1, 0],
  ].map((normal) => ({ normal }));
  const wallPoints = [
    [0, 0, 0],
    [-wide, 0, 0],
    [wide, 0, 0],
    [0, -wide, 0],
  ];
  const head = {
    format: "plumb/playback-1",
    scene,
    bodies: all.map((_, index) => ({ ...SHAPES[index % SHAPES.length], fixed: index === 0 })),
    walls,
    effects: EFFECTS.map(([name, on, why]) => ({ name, on, why })),
    time_step: 1e-4,
    accuracy: 1e-3,
  };
  const touching = neighbours(random, all, 2 * Math.cbrt(bodies) ** 2);
  const lines = Array.from({ length: frames }, (_, k) =>
    frameAt((LONG * k) / Math.max(1, frames - 1), all, touching, wallPoints),
  );
  const shares = { solver: 0.9, neighbours: 0.06, rest: 0.04 };
  const end = { steps: 20000, time: LONG, hash: "0123456789abcdef", solves: 1234567, failed: 0, shares };
  return [head, ...lines, ...(ended ? [{ end }] : [])];
}

const packed = (Numbers, values) => Buffer.from(Numbers.from(values).buffer).toString("base64");
const parts = (values) =>
  packed(
    Int16Array,
    values.map((x) => Math.sign(x) * Math.round(32767 * Math.abs(x))),
  );

function boxOf(points) {
  const low = [0, 1, 2].map((axis) =>
    points.reduce((least, point) => Math.min(least, point[axis]), points[0]?.[axis] ?? 0),
  );
  const side = [0, 1, 2].map((axis) => points.reduce((most, point) => Math.max(most, point[axis] - low[axis]), 0));
  return [low, side];
}

function packedContacts(frames, fromOrigin) {
  const all = frames.flatMap(({ contacts }) => contacts);
  const largest = all.reduce((most, contact) => Math.max(most, Math.abs(contact[9])), 0);
  const placed = frames.map(({ contacts }) => contacts.map((contact) => fromOrigin(contact.slice(2, 5))));
  const boxes = placed.map(boxOf);
  const points = placed.flatMap((inFrame, frame) => {
    const [low, side] = boxes[frame];
    return inFrame.flat().map((x, i) => (side[i % 3] > 0 ? Math.round((65535 * (x - low[i % 3])) / side[i % 3]) : 0));
  });
  return {
    counts: frames.map(({ contacts }) => contacts.length),
    deepest: frames.map(({ contacts }) =>
      contacts.length > 0 ? Math.max(...contacts.map((contact) => contact[8])) : null,
    ),
    largest_force: largest,
    boxes: packed(Float32Array, boxes.flat(2)),
    pairs: packed(
      Uint16Array,
      all.flatMap((contact) => contact.slice(0, 2)),
    ),
    points: packed(Uint16Array, points),
    normals: parts(all.flatMap((contact) => contact.slice(5, 8))),
    forces: parts(all.map((contact) => (largest > 0 ? contact[9] / largest : 0))),
  };
}

/** Of each kind one that is no plane, at its place, and with how fast it turns about z: as plumb scene writes it, and as the document has it. */
export const SHAPED_WALLS = [
  ["cylinder", { radius: 2, half_length: 1.5, closed: [true, false] }, [0, 0, 1.5], 0.5],
  ["cone", { radii: [0.3, 2], height: 1, closed: [false, false] }, [0, 0, -1], 0],
  ["box", { half_extents: [0.5, 1, 0.25] }, [4, 0, 0.5], 0.2],
  ["mesh", { triangles: [-1, 0, 0, 1, 0, 0, 1, 0, 1, -1, 0, 0, 1, 0, 1, -1, 0, 1] }, [0, 0, 0.2], 1],
];

/** The lines with those walls after the planes. */
export function withShapedWalls([head, ...others]) {
  const walls = [
    ...head.walls,
    ...SHAPED_WALLS.map(([shape, numbers]) => ({ normal: [0, 0, 1], shape, [shape]: numbers })),
  ];
  const turned = ({ time }) => [
    ...head.walls.flatMap(() => [1, 0, 0, 0]),
    ...SHAPED_WALLS.flatMap(([, , , rate]) => [Math.cos((rate * time) / 2), 0, 0, Math.sin((rate * time) / 2)]),
  ];
  const moved = (line) => ({
    ...line,
    wall: [...line.wall, ...SHAPED_WALLS.flatMap(([, , position]) => position)],
    wall_orientation: turned(line),
  });
  return [{ ...head, walls }, ...others.map((line) => (line.end ? line : moved(line)))];
}

function wallShape(wall, size) {
  const numbers = wall[wall.shape];
  if (!numbers) return null;
  const { radius, half_length, radii, height, closed, half_extents, triangles } = numbers;
  const scaled = (lengths) => lengths.map((x) => x / size);
  if (triangles) return { triangles: packed(Float32Array, scaled(triangles)) };
  if (half_extents) return { half_extents: scaled(half_extents) };
  if (radii) return { radii: scaled(radii), heights: scaled([0, height]), closed };
  return { radii: scaled([radius, radius]), heights: scaled([-half_length, half_length]), closed };
}

/** What stands in the document. */
export function playbackOf([head, ...others], name = "pile") {
  const frames = others.filter((line) => !line.end);
  const { bodies } = head;
  const keys = bodies.map(({ semi_axes, exponents }) => JSON.stringify({ semi_axes, exponents }));
  const shapes = [...new Set(keys)];
  const size = Math.max(...bodies.flatMap(({ semi_axes }) => semi_axes));
  const origin = [0, 1, 2].map((axis) =>
    bodies.reduce((sum, _, body) => sum + frames[0].position[3 * body + axis] / bodies.length, 0),
  );
  const fromOrigin = (x) => x.map((value, i) => (value - origin[i % 3]) / size);
  const seriesOf = (what) => {
    const names = [...new Set(frames.flatMap((frame) => Object.keys(frame[what] ?? {})))];
    return Object.fromEntries(names.map((name) => [name, frames.map((frame) => frame[what]?.[name] ?? null)]));
  };
  const wallShapes = head.walls.map((wall) => wallShape(wall, size));
  return {
    name,
    folder: `runs/${name}`,
    scene: head.scene,
    time_step: head.time_step,
    accuracy: head.accuracy,
    effects: head.effects,
    shapes: shapes.map((key) => JSON.parse(key)),
    bodies: keys.map((key) => shapes.indexOf(key)),
    fixed: bodies.flatMap(({ fixed }, index) => (fixed ? [index] : [])),
    walls: head.walls.map(({ normal, shape }) => (shape ? [0, 0, 0] : normal)),
    wall_shapes: wallShapes,
    origin,
    size,
    times: frames.map(({ time }) => time),
    positions: packed(
      Float32Array,
      frames.flatMap(({ position }) => fromOrigin(position)),
    ),
    orientations: parts(frames.flatMap(({ orientation }) => orientation)),
    wall_points: packed(
      Float32Array,
      frames.flatMap(({ wall }) => fromOrigin(wall)),
    ),
    wall_orientations: wallShapes.some((shape) => shape)
      ? parts(frames.flatMap(({ wall_orientation }) => wall_orientation))
      : "",
    contacts: packedContacts(frames, fromOrigin),
    energy: seriesOf("energy"),
    bulk: seriesOf("bulk"),
    end: others.find((line) => line.end)?.end ?? null,
  };
}

export const makePlayback = ({ name, ...options } = {}) => playbackOf(playbackLines(options), name);

/** Of scenes alone. */
export const makeSceneReport = (...playbacks) => ({
  ...makeReport({ families: [], failures: 0, precision: false, stability: false, playbacks }),
  runs: [],
});
