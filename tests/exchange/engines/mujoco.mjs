import {readFileSync} from "node:fs";
import {join} from "node:path";
import {conjugate, rotated} from "../geometry.mjs";

export const program = "MuJoCo";
export const packageName = "@mujoco/mujoco";
const creeping = "its friction is soft, and stacks creep";
export const settings = [
  {name: "defaults", option: "", substeps: 1, looser: {standing: [0.1, creeping], drift: [0.05, creeping]}},
  {name: "4 substeps, elliptic cones, impratio 100", option: 'cone="elliptic" impratio="100"', substeps: 4, looser: {
    hardest: [0.3, "where meshes touch along an edge, its contact may be at the end of it"],
  }},
];
export const slow = ["pane", "terraces"];

export async function start(load, folder) {
  const {default: loadMujoco} = await load(packageName);
  const mujoco = await loadMujoco({wasmBinary: readFileSync(join(folder, "mujoco.wasm"))});
  return {world: (gravity, step, setting) => new World(mujoco, gravity, step, setting)};
}

const text = (values) => values.join(" ");
const wxyz = ([x, y, z, w]) => text([w, x, y, z]);

/// A body: text for the compiler, and its pose and velocities.
class Handle {
  constructor(world, body) {
    const {position, rotation} = body;
    Object.assign(this, {world, body, motion: {position, rotation, velocity: [0, 0, 0], angularVelocity: [0, 0, 0]}});
  }
  index() { return this.world.bodies.indexOf(this); }
  assets() {
    if (this.body.radius) return "";
    return this.body.hulls.map((hull, k) =>
      `<mesh name="${this.index()}/${k}" vertex="${text(hull.vertices.flat())}" inertia="exact"/>`).join("");
  }
  /// With the mass of the body, or that of its hulls of density 1.
  text(hasMass) {
    const {hulls, radius, friction, mass, centreOfMass, principal: {moments, rotation}} = this.body;
    const shapes = radius ? [`type="sphere" size="${radius}"`] : hulls.map((_, k) => `type="mesh" mesh="${this.index()}/${k}"`);
    const geoms = shapes.map((shape) => `<geom ${shape} density="1" friction="${friction}"/>`);
    const inertial = `<inertial pos="${text(centreOfMass)}" mass="${mass}" diaginertia="${text(moments)}" ` +
      `quat="${wxyz(rotation)}"/>`;
    return `<body pos="${text(this.motion.position)}" quat="${wxyz(this.motion.rotation)}"><freejoint/>` +
      `${hasMass ? inertial : ""}${geoms.join("")}</body>`;
  }
  position() { return this.motion.position; }
  rotation() { return this.motion.rotation; }
  velocity() { return this.motion.velocity; }
  angularVelocity() { return this.motion.angularVelocity; }
  setMotion(velocity, angularVelocity) {
    Object.assign(this.motion, {velocity, angularVelocity});
    if (this.world.isCompiled) this.write();
  }
  // Angular velocities are in the axes of the body.
  read() {
    const [k, {qpos, qvel}] = [this.index(), this.world.data];
    const [x, y, z, w, i, j, l] = qpos.subarray(7 * k, 7 * k + 7);
    const v = [...qvel.subarray(6 * k, 6 * k + 6)];
    const rotation = [i, j, l, w];
    this.motion = {position: [x, y, z], rotation, velocity: v.slice(0, 3), angularVelocity: rotated(rotation, v.slice(3))};
  }
  write() {
    const {velocity, angularVelocity, rotation} = this.motion;
    this.world.data.qvel.set([...velocity, ...rotated(conjugate(rotation), angularVelocity)], 6 * this.index());
  }
  properties() {
    const {model, hulls, mujoco} = this.world;
    const k = this.index() + 1;
    const three = (values) => [...values.subarray(3 * k, 3 * k + 3)];
    return {
      mass: model.body_mass[k],
      centre: three(model.body_ipos),
      moments: three(model.body_inertia),
      volume: hulls.body_mass[k],
      hulls: model.geom_type.subarray(model.body_geomadr[k], model.body_geomadr[k] + model.body_geomnum[k])
        .filter((type) => type === mujoco.mjtGeom.mjGEOM_MESH.value).length,
      friction: model.geom_friction[3 * model.body_geomadr[k]],
      position: three(model.body_pos),
    };
  }
}

/// Bodies are text until all are there; then the compiler checks them. Where one is added or removed later, a new model
/// is compiled, which goes on from the poses and velocities of the others.
class World {
  constructor(mujoco, gravity, step, setting) {
    Object.assign(this, {mujoco, setting, floor: "", bodies: [], isCompiled: true});
    this.option = `<option timestep="${step / setting.substeps}" gravity="${text(gravity)}" ${setting.option}/>`;
  }
  addFloor(height, friction) {
    this.floor = `<geom type="plane" size="50 50 1" pos="0 ${height} 0" zaxis="0 1 0" friction="${friction}"/>`;
  }
  // The adapter. Quaternions have w first; a mesh has a frame of its own, which the compiler undoes.
  add(body) {
    const handle = new Handle(this, body);
    this.bodies.push(handle);
    this.isCompiled = false;
    return handle;
  }
  remove(handle) {
    this.bodies.splice(this.bodies.indexOf(handle), 1);
    this.isCompiled = false;
  }
  modelOf(bodies, hasMass) {
    return this.mujoco.MjModel.from_xml_string(`<mujoco>${this.option}<asset>${bodies.map((one) => one.assets()).join("")}` +
      `</asset><worldbody>${this.floor}${bodies.map((one) => one.text(hasMass)).join("")}</worldbody></mujoco>`);
  }
  finish() {
    this.hulls?.delete();
    this.compile();
    this.hulls = this.modelOf(this.bodies, false);
  }
  compile() {
    this.data?.delete();
    this.model?.delete();
    this.model = this.modelOf(this.bodies, true);
    this.data = new this.mujoco.MjData(this.model);
    this.isCompiled = true;
    for (const one of this.bodies) one.write();
  }
  step() {
    if (!this.isCompiled) this.compile();
    for (let k = 0; k < this.setting.substeps; ++k) this.mujoco.mj_step(this.model, this.data);
    for (const one of this.bodies) one.read();
  }
  /// The contacts that the last step solved: {first, second, points: [{position, depth}], normal towards the second}.
  contacts() {
    const pairs = new Map();
    const bodyOf = (geom) => this.bodies[this.model.geom_bodyid[geom] - 1];
    const {contact} = this.data;
    for (let k = 0; k < this.data.ncon; ++k) {
      const one = contact.get(k);
      const normal = [...one.frame.subarray(0, 3)];
      const key = [one.geom1, one.geom2, ...normal].join();
      if (!pairs.has(key)) pairs.set(key, {first: bodyOf(one.geom1), second: bodyOf(one.geom2), points: [], normal});
      pairs.get(key).points.push({position: [...one.pos], depth: -one.dist});
      one.delete();
    }
    contact.delete();
    return [...pairs.values()];
  }
  end() {
    this.data.delete();
    this.model.delete();
    this.hulls.delete();
  }
}
