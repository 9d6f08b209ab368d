// Stands the asset of a pack in Rapier, throws a ball of 100 kg at it and breaks it:
// npm install @dimforge/rapier3d-compat; node rapier_example.mjs pack.json SPEED
import RAPIER from "@dimforge/rapier3d-compat";
import {readFileSync} from "node:fs";

const xyz = ([x, y, z]) => ({x, y, z});
const plus = (a, b) => ({x: a.x + b.x, y: a.y + b.y, z: a.z + b.z});
const minus = (a, b) => ({x: a.x - b.x, y: a.y - b.y, z: a.z - b.z});
const dot = (a, b) => a.x * b.x + a.y * b.y + a.z * b.z;
const cross = (a, b) => ({x: a.y * b.z - a.z * b.y, y: a.z * b.x - a.x * b.z, z: a.x * b.y - a.y * b.x});
function rotated(q, v) {
  const s = cross(q, v);
  const t = cross(q, s);
  return {x: v.x + 2 * (q.w * s.x + t.x), y: v.y + 2 * (q.w * s.y + t.y), z: v.z + 2 * (q.w * s.z + t.z)};
}

const [, , path, speed] = process.argv;
const pack = JSON.parse(readFileSync(path, "utf8"));
await RAPIER.init();
const world = new RAPIER.World({x: 0, y: -9.81, z: 0});

/// A body of the pack, at a place of its frame.
function addBody(body, position, rotation) {
  const [x, y, z, w] = body.principal.rotation;
  const added = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(position.x, position.y, position.z)
    .setRotation(rotation)
    .setAdditionalMassProperties(body.mass, xyz([0, 0, 0]), xyz(body.principal.moments), {x, y, z, w}));
  for (const hull of body.hulls) {
    world.createCollider(RAPIER.ColliderDesc.convexHull(new Float32Array(hull.vertices.flat())).setDensity(0)
      .setFriction(pack.materials[pack.material].friction), added);
  }
  return added;
}

/// 1/mass + (r × n) · I⁻¹ (r × n), as pack.md has it.
function inverseMassAt(body, point, n) {
  const arm = cross(minus(point, body.worldCom()), n);
  const {m11, m12, m13, m22, m23, m33} = body.effectiveWorldInvInertia();
  return body.invMass() + m11 * arm.x ** 2 + m22 * arm.y ** 2 + m33 * arm.z ** 2 +
    2 * (m12 * arm.x * arm.y + m13 * arm.x * arm.z + m23 * arm.y * arm.z);
}

const start = xyz(pack.whole.offset);
const whole = addBody(pack.whole, start, {x: 0, y: 0, z: 0, w: 1});
world.createCollider(RAPIER.ColliderDesc.cuboid(5, 1, 5)
  .setTranslation(start.x, start.y + pack.whole.bounds.min[1] - 1, start.z));
const ball = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(start.x, start.y, start.z + 1)
  .setLinvel(0, 0, -speed).setGravityScale(0).setCcdEnabled(true));  // it flies straight
const ballCollider = world.createCollider(RAPIER.ColliderDesc.ball(0.2).setMass(100), ball);

const fragments = [];
for (let step = 0; step < 120; ++step) {
  const isWhole = fragments.length === 0;
  const velocity = isWhole && minus(ball.linvel(), whole.linvel());  // before the step, and before anything rotates
  world.step();
  let impact = 0;
  for (let k = 0; isWhole && k < whole.numColliders(); ++k) {
    world.contactPair(whole.collider(k), ballCollider, (contact) => {
      if (contact.numSolverContacts() === 0 || contact.contactImpulse(0) === 0) return;
      const [point, n] = [contact.solverContactPoint(0), contact.normal()];
      const approach = Math.abs(dot(velocity, n));
      const inverse = inverseMassAt(whole, point, n) + inverseMassAt(ball, point, n);
      if (approach > 0.5) impact = Math.max(impact, approach / inverse);  // without restitution
    });
  }
  if (impact < pack.threshold) continue;
  console.log(`broke at ${impact.toFixed(1)} N·s, threshold ${pack.threshold}, fragments moved`);
  const [origin, rotation, v, w] = [whole.translation(), whole.rotation(), whole.linvel(), whole.angvel()];
  world.removeRigidBody(whole);
  for (const fragment of pack.fragments.filter(({parent}) => parent === null)) {
    const arm = rotated(rotation, minus(xyz(fragment.offset), start));
    const body = addBody(fragment, plus(origin, arm), rotation);
    body.setLinvel(plus(v, cross(w, arm)), true);
    body.setAngvel(w, true);
    fragments.push({body, from: plus(origin, arm)});
  }
}
for (const {body, from} of fragments)
  console.log(`${Math.hypot(...Object.values(minus(body.translation(), from)))} m`);
