import {readFileSync} from "node:fs";
import {join} from "node:path";

export const program = "MuJoCo";
export const packageName = "@mujoco/mujoco";
const creeping = "its friction is soft, and stacks creep";
export const settings = [
  {name: "defaults", option: "", substeps: 1, looser: {standing: [0.1, creeping], drift: [0.05, creeping]}},
  {name: "4 substeps, elliptic cones, impratio 100", option: 'cone="elliptic" impratio="100"', substeps: 4},
];
export const slow = ["pane", "terraces"];

export async function start(load, folder) {
  const {default: loadMujoco} = await load(packageName);
  const mujoco = await loadMujoco({wasmBinary: readFileSync(join(folder, "mujoco.wasm"))});
  return {world: (gravity, step, setting) => new World(mujoco, gravity, step, setting)};
}

const text = (values) => values.join(" ");
const wxyz = ([x, y, z, w]) => text([w, x, y, z]);

/// Bodies are text until all are there; then the compiler checks them.
class World {
  constructor(mujoco, gravity, step, setting) {
    Object.assign(this, {mujoco, setting, assets: "", bodies: "", count: 0});
    this.option = `<option timestep="${step / setting.substeps}" gravity="${text(gravity)}" ${setting.option}/>`;
  }
  addFloor(height, friction) {
    this.bodies += `<geom type="plane" size="50 50 1" pos="0 ${height} 0" zaxis="0 1 0" friction="${friction}"/>`;
  }
  // The adapter. Quaternions have w first; a mesh has a frame of its own, which the compiler undoes.
  add(body) {
    const index = this.count++;
    const {moments, rotation} = body.principal;
    body.hulls.forEach((hull, k) => {
      this.assets += `<mesh name="${index}/${k}" vertex="${text(hull.vertices.flat())}" inertia="exact"/>`;
    });
    const geoms = body.hulls.map((_, k) =>
      `<geom type="mesh" mesh="${index}/${k}" density="1" friction="${body.friction}"/>`);
    this.bodies += `<body pos="${text(body.position)}" quat="${wxyz(body.rotation)}"><freejoint/>` +
      `<inertial pos="${text(body.centreOfMass)}" mass="${body.mass}" diaginertia="${text(moments)}" ` +
      `quat="${wxyz(rotation)}"/>${geoms.join("")}</body>`;
    const of = (values, k, count) => [...values.subarray(count * k, count * k + count)];
    return {
      position: () => of(this.data.qpos, index, 7).slice(0, 3),
      velocity: () => of(this.data.qvel, index, 6).slice(0, 3),
      properties: () => ({
        mass: this.model.body_mass[index + 1],
        centre: of(this.model.body_ipos, index + 1, 3),
        moments: of(this.model.body_inertia, index + 1, 3),
        volume: this.hulls.body_mass[index + 1],
        friction: this.model.geom_friction[3 * this.model.body_geomadr[index + 1]],
        position: of(this.model.body_pos, index + 1, 3),
      }),
    };
  }
  modelOf(bodies) {
    return this.mujoco.MjModel.from_xml_string(
      `<mujoco>${this.option}<asset>${this.assets}</asset><worldbody>${bodies}</worldbody></mujoco>`);
  }
  finish() {
    this.model = this.modelOf(this.bodies);
    this.hulls = this.modelOf(this.bodies.replace(/<inertial[^>]*>/g, ""));  // with the masses of hulls of density 1
    this.data = new this.mujoco.MjData(this.model);
  }
  step() {
    for (let k = 0; k < this.setting.substeps; ++k) this.mujoco.mj_step(this.model, this.data);
  }
  end() {
    this.data.delete();
    this.model.delete();
    this.hulls.delete();
  }
}
