// MuJoCo's distance of two ellipsoids, mj_geomDistance: its own GJK and EPA, in double.
//     node mujoco.mjs [TOLERANCE ITERATIONS]        its own defaults without: ccd_tolerance 1e-6, ccd_iterations 50
import loadMujoco from 'mujoco-js';
import { norm, scale, serve, subtract } from './plumb_solver.mjs';

// One model for all pairs: sizes and poses are written where the distance reads them. At 200 iterations this build ends by "null
// function or function signature mismatch".
const [tolerance = '1e-6', iterations = '50'] = process.argv.slice(2);
const MODEL = `<mujoco>
  <option ccd_tolerance="${tolerance}" ccd_iterations="${iterations}"/>
  <worldbody><geom type="ellipsoid" size="1 1 1"/><geom type="ellipsoid" size="1 1 1"/></worldbody>
</mujoco>`;

const mujoco = await loadMujoco();
mujoco.FS.writeFile('/tmp/pair.xml', MODEL);
const model = mujoco.MjModel.loadFromXML('/tmp/pair.xml');
const data = new mujoco.MjData(model);
mujoco.mj_forward(model, data);
const fromTo = new mujoco.DoubleBuffer(6);

const isEllipsoid = (body) => body.exponents.every((n) => n === 2);

function place(body, i) {
  model.geom_size.set(body.semiAxes, 3 * i);
  data.geom_xpos.set(body.position, 3 * i);
  data.geom_xmat.set(body.rotation.flat(), 9 * i);
}

function solve(pair) {
  if (!pair.bodies.every(isEllipsoid)) return null;
  pair.bodies.forEach(place);
  const far = norm(pair.bodies[1].position) + 1; // more than any distance
  const distance = mujoco.mj_geomDistance(model, data, 0, 1, far, fromTo);
  if (!(distance < far)) return pair.answer({ status: 'stalled' });
  const both = fromTo.GetView();
  const points = [[...both.slice(0, 3)], [...both.slice(3, 6)]];
  const normal = scale(1 / distance, subtract(points[1], points[0])); // it gives none but the points
  return pair.answer({ overlap: -distance, normal: scale(1 / norm(normal), normal), points });
}

await serve(solve, {
  name: process.argv.length > 2 ? `mujoco_wasm-${tolerance}` : 'mujoco_wasm',
  version: mujoco.mj_versionString(),
  licence: 'Apache-2.0',
  shapes: 'ellipsoids',
  tolerance: Number(tolerance),
});
