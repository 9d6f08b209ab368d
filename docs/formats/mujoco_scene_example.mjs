// Stands a bonded scene in MuJoCo, fires one of its throws and prints what breaks, a JSON line each: beside bonds.mjs,
// npm install @mujoco/mujoco; node mujoco_scene_example.mjs FOLDER [THROW] [SECONDS]
import loadMujoco from "@mujoco/mujoco";
import {BondedPlay} from "./bonded_play.mjs";
import {cross, dot, firstTouches, loadScene, minus, plus, rotated, solidsOf, throwOf, times,
        unrotated} from "./bonds.mjs";

const [, , folder, shotName, seconds = 5] = process.argv;
const RATE = 240, FRICTION = 0.6;  // Hz; of what is thrown
const mujoco = await loadMujoco();
const scene = loadScene(folder);
const text = (values) => values.join(" "), wxyz = ([x, y, z, w]) => text([w, x, y, z]);
const handles = [];  // of bodies, in the order in which the model has them
let meshes = 0;
let model, data, isCompiled = false;

/// The geoms of solids in the frame of their asset; the hulls of one share its mass.
function geomsOf({pack}, solids) {
  const {friction} = pack.materials[pack.material];
  return solids.flatMap(({mass, hulls, offset}) => hulls.map((hull) => {
    hull.mesh ??= `m${++meshes}`;
    const place = `mesh="${hull.mesh}" pos="${text(offset)}"`;
    return {hull, more: `type="mesh" ${place} friction="${friction}" mass="${mass / hulls.length}"`};
  }));
}
/// A body: with what the model says of it, and how it moves.
function add(structure, numbers, isFixed, whole) {
  const {position, rotation} = structure.instance;
  const motion = {position, rotation, v: [0, 0, 0], w: [0, 0, 0], ...whole?.handle.motion};
  const handle = {isFixed, geoms: geomsOf(structure.instance, solidsOf(structure, numbers, !whole)), motion};
  handles.push(handle);
  isCompiled = false;
  return handle;
}
const remove = ({handle}) => handles.splice(handles.indexOf(handle), 1);  // what comes off it is added before
/// Bodies are text for the compiler, which goes on from their poses and velocities.
function compile() {
  const used = new Set(handles.flatMap(({geoms}) => geoms).flatMap(({hull}) => hull ?? []));
  const bodyText = ({isFixed, geoms, motion: {position, rotation}}) =>
    `<body pos="${text(position)}" quat="${wxyz(rotation)}">${isFixed ? "" : "<freejoint/>"}` +
    `${geoms.map(({more}) => `<geom ${more}/>`).join("")}</body>`;
  const ground = scene.ground ? `<geom type="plane" size="100 100 1" pos="0 ${scene.ground.height} 0" zaxis="0 1 0" ` +
    `friction="${scene.ground.friction}"/>` : "";
  for (const old of [data, model]) old?.delete();
  const meshText = ({mesh, vertices}) => `<mesh name="${mesh}" vertex="${text(vertices.flat())}" inertia="exact"/>`;
  model = mujoco.MjModel.from_xml_string(
    `<mujoco><option timestep="${1 / RATE}" gravity="${text(scene.gravity)}"/>` +
    `<asset>${[...used].map(meshText).join("")}</asset>` +
    `<worldbody>${ground}${handles.map(bodyText).join("")}</worldbody></mujoco>`);
  data = new mujoco.MjData(model);
  for (const [k, {motion: {rotation, v, w}}] of free().entries())
    data.qvel.set([...v, ...unrotated(rotation, w)], 6 * k);
  isCompiled = true;
}
const free = () => handles.filter(({isFixed}) => !isFixed);
function step() {
  if (!isCompiled) compile();
  mujoco.mj_step(model, data);
  for (const [k, {motion}] of free().entries()) {  // quaternions have w first; what rotates is in axes of the body
    const [x, y, z, w, ...axis] = data.qpos.subarray(7 * k, 7 * k + 7), both = data.qvel.subarray(6 * k, 6 * k + 6);
    Object.assign(motion, {position: [x, y, z], rotation: [...axis, w], v: [...both.subarray(0, 3)]});
    motion.w = rotated(motion.rotation, [...both.subarray(3)]);
  }
}

/// The strongest impact of the impactor on each body in this step, J = v m from before it, with all of its points.
function impactsOf(impactor, before) {
  const contacts = new Map(), all = data.contact;
  for (let k = 0; k < data.ncon; ++k) {
    const one = all.get(k), ends = [one.geom1, one.geom2].map((geom) => handles[model.geom_bodyid[geom] - 1]);
    const side = ends.indexOf(impactor), handle = ends[1 - side], distance = one.dist;
    const n = times([...one.frame.subarray(0, 3)], side === 1 ? 1 : -1), geom = side === 1 ? one.geom1 : one.geom2;
    const point = plus([...one.pos], times(n, -distance / 2));  // on the body; MuJoCo has it halfway
    one.delete();
    if (side < 0 || !handle) continue;
    const speed = -dot(minus(before, handle.motion.v), n);
    if (speed < 0.5 || distance > speed / RATE) continue;
    contacts.set(handle, [...(contacts.get(handle) ?? []), {hull: geom, n, speed, distance, point}]);
  }
  all.delete();
  return [...contacts].map(([handle, touching]) => {
    const hits = firstTouches(touching).map((one) => ({...one, impulse: one.speed /
      (inverseMassAt(impactor, one.point, one.n) + inverseMassAt(handle, one.point, one.n))}));  // without restitution
    const hardest = hits.reduce((best, one) => (one.impulse > best.impulse ? one : best));
    return {...hardest, handle, points: hits.map(({point}) => point)};
  });
}
/// 1/mass + (r × n) · I⁻¹ (r × n) of a body, as pack.md has it; what is fixed has none.
function inverseMassAt(handle, point, n) {
  if (handle.isFixed) return 0;
  const k = handles.indexOf(handle) + 1, of = (values, size = 3) => [...values.subarray(size * k, size * (k + 1))];
  const [w, x, y, z] = of(model.body_iquat, 4), arm = minus(point, of(data.xipos)), moments = of(model.body_inertia);
  const turning = unrotated([x, y, z, w], unrotated(handle.motion.rotation, cross(arm, n)));
  return 1 / model.body_mass[k] + turning.reduce((sum, value, axis) => sum + value * value / moments[axis], 0);
}

function fire({action}) {
  const {rotation, velocity} = throwOf(action), half = times(action.size, 0.5), reach = 2 * action.speed / RATE;
  const shape = action.projectile === "ball" ? `type="sphere" size="${half[0]}"` : `type="box" size="${text(half)}"`;
  const more = `${shape} mass="${action.mass}" friction="${FRICTION}" gap="${reach}"`;  // contacts are known before
  handles.push({isFixed: false, geoms: [{more}], motion: {position: action.from, rotation, v: velocity, w: [0, 0, 0]}});
  isCompiled = false;
  return handles.at(-1);
}

const play = new BondedPlay(scene, {add, remove});
const shot = scene.shots.find(({name, kind}) => name === shotName && kind === "throw");
let impactor;
for (let k = 1; k <= seconds * RATE; ++k) {
  if (shot && k === Math.ceil(shot.time * RATE) + 1) impactor = fire(shot);
  const before = impactor?.motion.v;
  step();
  for (const {handle, points, n, impulse} of impactor ? impactsOf(impactor, before) : []) {
    const body = [...play.bodies].find((one) => one.handle === handle), {position, rotation} = handle.motion;
    const {taken, broken, islands} = play.hit(body, points.map((point) => unrotated(rotation, minus(point, position))), impulse);
    if (broken.length === 0) continue;
    console.log(JSON.stringify({time: k / RATE, instance: body.structure.instance.id, taken, broken, islands}));
    impactor.motion.v = plus(before, times(n, taken / shot.action.mass));  // the fragments take the rest
    break;
  }
  play.advance(k / RATE);
}
console.log(JSON.stringify({bodies: play.bodies.size, free: [...play.bodies].filter(({isFixed}) => !isFixed).length}));
