// PhysX's GJK and EPA, PxGjkQuery::proximityInfo, in float, over a support function of ours: no hull, the superellipsoid itself.
import { readFileSync } from 'node:fs';
import { norm, scale, serve } from './plumb_solver.mjs';

// The package is built for browsers, and refuses where there is a `process` or no `window`; it uses neither.
async function loadForBrowser() {
  const { process } = globalThis;
  const wasmBinary = readFileSync(new URL('./node_modules/physx-js-webidl/physx-js-webidl.wasm', import.meta.url));
  Object.assign(globalThis, { process: undefined, window: globalThis });
  try {
    return await (await import('physx-js-webidl')).default({ wasmBinary });
  } finally {
    globalThis.process = process;
    delete globalThis.window;
  }
}
const px = await loadForBrowser();

const array = ({ x, y, z }) => [x, y, z];
const write = (v, [x, y, z]) => {
  [v.x, v.y, v.z] = [x, y, z];
};

// One shape for each body of every pair; `body` is set before each query.
function makeShape() {
  const shape = new px.CustomSupportImpl();
  shape.getCustomMargin = () => 0;
  shape.getCustomSupportLocal = (direction, result) => {
    const d = array(px.wrapPointer(direction, px.PxVec3));
    const some = d.some((v) => v !== 0) ? d : [1, 0, 0];
    write(px.wrapPointer(result, px.PxVec3), shape.body.localSupportPoint(some));
    ++shape.evaluations;
  };
  return shape;
}

const shapes = [makeShape(), makeShape()];
const poses = [0, 1].map(() => new px.PxTransform(px.PxIDENTITYEnum.PxIdentity));
const result = new px.PxGjkQueryProximityInfoResult();

function place(body, i) {
  shapes[i].body = body;
  shapes[i].evaluations = 0;
  write(poses[i].p, body.position);
  const [w, ...xyz] = body.quaternion;
  write(poses[i].q, xyz);
  poses[i].q.w = w;
}

function solve(pair) {
  pair.bodies.forEach(place);
  const far = norm(pair.bodies[1].position) + 1;
  const size = 1; // of the larger body, in the pair's units
  const answers = px.PxGjkQuery.prototype.proximityInfo(shapes[0], shapes[1], poses[0], poses[1], far, size, result);
  const evaluations = shapes[0].evaluations + shapes[1].evaluations;
  if (!answers) return pair.answer({ status: 'stalled', evaluations });
  const axis = array(result.separatingAxis);
  const normal = scale(-1 / norm(axis), axis);
  const points = [array(result.pointA), array(result.pointB)];
  return pair.answer({ overlap: -result.separation, normal, points, evaluations });
}

await serve(solve, {
  name: 'physx_gjk',
  version: '5.6.1', // of the package 2.7.3
  licence: 'BSD-3-Clause',
  tolerance: 1e-4, // a tenth of the margin that it gives every custom shape, 0.001: there its EPA ends, if it does not get stuck before
});
