// Rapier's contact of two convex hulls, each of a thousand points of a superellipsoid, in float: GJK and EPA of Parry.
import RAPIER from '@dimforge/rapier3d-compat';
import { norm, serve } from './plumb_solver.mjs';

const POINTS = 1000;
const silently = console.warn; // its loader warns of its own call
console.warn = () => {};
await RAPIER.init();
console.warn = silently;

// Evenly over the sphere of normals: a spiral by the golden angle.
const normals = Array.from({ length: POINTS }, (_, i) => {
  const z = 1 - (2 * i + 1) / POINTS;
  const turn = i * Math.PI * (3 - Math.sqrt(5));
  return [Math.sqrt(1 - z * z) * Math.cos(turn), Math.sqrt(1 - z * z) * Math.sin(turn), z];
});

const array = ({ x, y, z }) => [x, y, z];
const world = new RAPIER.World({ x: 0, y: 0, z: 0 });

// A hull takes 50 ms to build: those of the last shapes are kept: pairs are asked for in several places.
const KEPT = 256;
const kept = new Map();

function colliderOf(body) {
  const key = JSON.stringify([body.semiAxes, body.exponents]);
  const known = kept.get(key);
  if (known) return known;
  if (kept.size === KEPT) {
    const [oldest, colliders] = kept.entries().next().value;
    colliders.forEach((collider) => world.removeCollider(collider, false));
    kept.delete(oldest);
  }
  // The normals of a sphere, carried along as it is stretched: points that spread over a needle as evenly.
  const points = normals.flatMap((n) => body.localSupportPoint(n.map((v, i) => v / body.semiAxes[i])));
  const hull = RAPIER.ColliderDesc.convexHull(new Float32Array(points));
  if (!hull) return null;
  const colliders = [0, 1].map(() => world.createCollider(hull)); // two bodies may have one shape
  kept.set(key, colliders);
  return colliders;
}

function place(collider, { position: [x, y, z], quaternion: [qw, qx, qy, qz] }) {
  collider.setTranslation({ x, y, z });
  collider.setRotation({ w: qw, x: qx, y: qy, z: qz });
}

function solve(pair) {
  const colliders = pair.bodies.map((body, i) => colliderOf(body)?.[i]);
  if (!colliders.every(Boolean)) return null; // flat, to Rapier
  colliders.forEach((collider, i) => place(collider, pair.bodies[i]));
  const far = norm(pair.bodies[1].position) + 1; // more than any distance
  const found = colliders[0].contactCollider(colliders[1], far);
  if (!found) return pair.answer({ status: 'stalled' });
  const { distance, point1, point2, normal1 } = found;
  return pair.answer({ overlap: -distance, normal: array(normal1), points: [array(point1), array(point2)] });
}

await serve(solve, {
  name: 'rapier_hull',
  version: RAPIER.version(),
  licence: 'Apache-2.0',
  tolerance: 5e-3, // what a hull of so many points cuts off a sphere, and a little
});
