// Stands a bonded scene in Rapier, fires one of its throws and prints what breaks, a JSON line each: beside bonds.mjs,
// npm install @dimforge/rapier3d-compat; node rapier_scene_example.mjs FOLDER [THROW] [SECONDS]
import RAPIER from "@dimforge/rapier3d-compat";
import {BondedPlay} from "./bonded_play.mjs";
import {cross, dot, firstTouches, loadScene, minus, plus, solidsOf, throwOf, times, unrotated} from "./bonds.mjs";

const [, , folder, shotName, seconds = 5] = process.argv;
const RATE = 240, FRICTION = 0.6;  // Hz; of what is thrown
await RAPIER.init();
const scene = loadScene(folder);
const xyz = ([x, y, z]) => ({x, y, z}), xyzw = ([x, y, z, w]) => ({x, y, z, w});
const list = ({x, y, z}) => [x, y, z], four = ({x, y, z, w}) => [x, y, z, w];
const world = new RAPIER.World(xyz(scene.gravity));
world.timestep = 1 / RATE;

/// Fragments as one body with the frame of their asset; the first collider of each solid has all of its mass.
function add(structure, numbers, isFixed, whole) {
  const {pack, position, rotation} = structure.instance, material = pack.materials[pack.material];
  const pose = whole ? [list(whole.handle.translation()), four(whole.handle.rotation())] : [position, rotation];
  const kind = isFixed ? RAPIER.RigidBodyDesc.fixed() : RAPIER.RigidBodyDesc.dynamic();
  const added = world.createRigidBody(kind.setTranslation(...pose[0]).setRotation(xyzw(pose[1])));
  for (const {mass, centreOfMass, hulls, offset, principal} of solidsOf(structure, numbers, !whole)) {
    for (const hull of hulls) {
      const shape = RAPIER.ColliderDesc.convexHull(new Float32Array(hull.vertices.flat())).setTranslation(...offset)
        .setFriction(material.friction).setRestitution(material.restitution).setDensity(0)
        .setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Max);
      if (hull === hulls[0])
        shape.setMassProperties(mass, xyz(centreOfMass), xyz(principal.moments), xyzw(principal.rotation));
      world.createCollider(shape, added);
    }
  }
  if (!whole || isFixed) return added;
  const [v, w] = [list(whole.handle.linvel()), list(whole.handle.angvel())];
  const arm = minus(list(added.worldCom()), list(whole.handle.worldCom()));
  added.setLinvel(xyz(plus(v, cross(w, arm))), true);
  added.setAngvel(xyz(w), true);
  return added;
}

/// 1/mass + (r × n) · I⁻¹ (r × n), as pack.md has it; what is fixed has none.
function inverseMassAt(body, point, n) {
  if (body.isFixed()) return 0;
  const [x, y, z] = cross(minus(point, list(body.worldCom())), n), i = body.effectiveWorldInvInertia();
  const turning = i.m11 * x * x + i.m22 * y * y + i.m33 * z * z;
  return body.invMass() + turning + 2 * (i.m12 * x * y + i.m13 * x * z + i.m23 * y * z);
}
/// The strongest impact of a impactor on a body in this step, J = (1 + e) v m from before it, with all of its points.
function impactOn({structure, handle}, impactor, velocity) {
  const contacts = [], found = {impulse: 0, points: []}, {pack} = structure.instance;
  for (let hull = 0; hull < handle.numColliders(); ++hull) {
    world.contactPair(handle.collider(hull), impactor.collider(0), (contact, isFlipped) => {
      const n = times(list(contact.normal()), isFlipped ? -1 : 1), speed = -dot(velocity, n);  // n: to the impactor
      for (let k = 0; speed > 0.5 && k < contact.numSolverContacts(); ++k) {
        const distance = contact.solverContactDist(k);
        const point = list(contact.solverContactPoint(k));
        if (distance <= speed / RATE) contacts.push({hull, n, speed, distance, point});
      }
    });
  }
  for (const {point, n, speed} of firstTouches(contacts)) {
    const inverse = inverseMassAt(handle, point, n) + inverseMassAt(impactor, point, n);
    const impulse = (1 + pack.materials[pack.material].restitution) * speed / inverse;
    found.points.push(unrotated(four(handle.rotation()), minus(point, list(handle.translation()))));
    if (impulse > found.impulse) Object.assign(found, {impulse, n});
  }
  return found;
}

function fire({action}) {
  const {rotation, velocity} = throwOf(action), half = times(action.size, 0.5);
  const body = RAPIER.RigidBodyDesc.dynamic().setTranslation(...action.from).setRotation(xyzw(rotation));
  const fired = world.createRigidBody(body.setLinvel(...velocity).setCcdEnabled(true)
    .setSoftCcdPrediction(2 * action.speed / RATE));  // so that contacts are known before they touch
  const shape = action.projectile === "ball" ? RAPIER.ColliderDesc.ball(half[0]) : RAPIER.ColliderDesc.cuboid(...half);
  world.createCollider(shape.setMass(action.mass).setFriction(FRICTION), fired);
  return fired;
}

const play = new BondedPlay(scene, {add, remove: ({handle}) => world.removeRigidBody(handle)});
if (scene.ground) {
  const ground = RAPIER.ColliderDesc.cuboid(100, 1, 100).setTranslation(0, scene.ground.height - 1, 0);
  world.createCollider(ground.setFriction(scene.ground.friction));
}
const shot = scene.shots.find(({name, kind}) => name === shotName && kind === "throw");
let impactor;
for (let step = 1; step <= seconds * RATE; ++step) {
  if (shot && step === Math.ceil(shot.time * RATE) + 1) impactor = fire(shot);
  const before = impactor && list(impactor.linvel());
  world.step();
  for (const body of impactor ? [...play.bodies] : []) {
    const {impulse, points, n} = impactOn(body, impactor, minus(before, list(body.handle.linvel())));
    if (points.length === 0) continue;
    const {taken, broken, islands} = play.hit(body, points, impulse);
    if (broken.length === 0) continue;
    console.log(JSON.stringify({time: step / RATE, instance: body.structure.instance.id, taken, broken, islands}));
    impactor.setLinvel(xyz(plus(before, times(n, taken * impactor.invMass()))), true);  // the fragments take the rest
    break;
  }
  play.advance(step / RATE);
}
const free = [...play.bodies].filter(({isFixed}) => !isFixed);
console.log(JSON.stringify({bodies: play.bodies.size, free: free.length}));
