// Failures of pairs of any shapes, plumb/case-2: each shape once as body 1, once as body 2.
const CUBE = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) => [x, y, z])));

/** With its word; every one alone and swept. */
export const SHAPES = {
  superellipsoid: { superellipsoid: { semi_axes: [1, 2, 3], exponents: [4, 3] } },
  capsule: { capsule: { half_length: 2, radius: 0.5 } },
  cylinder: { cylinder: { half_length: 2, radius: 0.5 } },
  cone: { cone: { radius: 1, height: 2 } },
  frustum: { frustum: { radii: [1, 0.5], height: 1 } },
  box: { box: { half_extents: [1, 2, 3] } },
  polyhedron: { polyhedron: { points: CUBE } },
  poly_superellipsoid: { poly_superellipsoid: { semi_axes: [1, 2, 3, 1, 2, 4], exponents: [3, 2] } },
  half_space: { half_space: {} },
  tablet: { tablet: { half_length: 0.5, radius: 1, cap_height: 0.25 } },
};

export const swept = (core, radius) => ({ sphere_swept: { core, radius } });

const TURN = [0.8, 0.1, -0.5, 0.3];
const bodyOf = (shape, position) => ({ shape, position, orientation: { quaternion_wxyz: TURN } });

const ANSWER = {
  status: "converged",
  verdict: "overlapping",
  overlap: 0.25,
  normal: [0, 0, 1],
  points: [[0, 0, 0.125], [0, 0, -0.125]], // prettier-ignore
  normals: null,
  iterations: 0,
  angle_error_deg: null,
};
const STALLED = { ...ANSWER, status: "stalled", verdict: "undecided", overlap: null, normal: null, points: null };
const BOUNDS = { ...ANSWER, status: "bounds of the overlap alone: 0.2 .. 0.3", normal: null, points: null };

/** As plumb report has it: a reference without a normal. */
export function failureOfShapes(first, second, isStalled = false) {
  const words = [first, second].map((shape) => Object.keys(shape.sphere_swept?.core ?? shape)[0]);
  const isSwept = [first, second].some((shape) => shape.sphere_swept);
  const [method, finding] = ["auto", isStalled ? "nonconverged" : "misaligned"];
  const bucket = `${finding}-${method}-${words.join("-")}${isSwept ? "-swept" : ""}`;
  const file = `runs/shapes/failures/${bucket}--simplest.json`;
  const bodies = [bodyOf(first, [0, 0, -1]), bodyOf(second, [0, 0.25, 1])];
  return {
    bucket,
    kept: "only",
    count: 1,
    finding,
    method,
    shapes: words.join(" against "),
    regime: isSwept ? "swept" : "",
    family: "shapes",
    own: true,
    severity: 3,
    law: `law_${finding}`,
    detail: isStalled ? "status stalled" : "a body reaches 1e-3 beyond the plane through its point",
    file,
    replay: `plumb replay ${file}`,
    case: { format: "plumb/case-2", name: "pair", bodies, expect: { method, finding } },
    answer: isStalled ? STALLED : ANSWER,
    reference: BOUNDS,
    right_from: null,
  };
}

export function failuresOfShapes() {
  const ball = { capsule: { half_length: 0, radius: 1 } };
  return Object.values(SHAPES).flatMap((shape, index) => [
    failureOfShapes(shape, ball, index % 3 === 0),
    failureOfShapes(ball, swept(shape, 0.25)),
  ]);
}
