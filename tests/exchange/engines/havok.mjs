import {readFileSync} from "node:fs";
import {join} from "node:path";

export const program = "Havok";
export const packageName = "@babylonjs/havok";
const reshaped = "it rounds hulls by a radius, and a face of less than about 25 mm moves 2 mm out, those beside it 2 mm in";
export const settings = [{name: "defaults", looser: {
  volume: [1e-2, reshaped],
  swap: [0.1, reshaped],
  standing: [8e-3, reshaped],
}}];

export async function start(load, folder) {
  const {default: HavokPhysics} = await load(packageName);
  const havok = await HavokPhysics({wasmBinary: readFileSync(join(folder, "lib/esm/HavokPhysics.wasm"))});
  return {world: (gravity, step) => new World(havok, gravity, step)};
}

class World {
  constructor(havok, gravity, step) {
    this.havok = havok;
    this.stepLength = step;
    this.world = havok.HP_World_Create()[1];
    havok.HP_World_SetGravity(this.world, gravity);
  }
  materialOf(shape, friction, restitution) {
    const {havok} = this;
    const {GEOMETRIC_MEAN, MAXIMUM} = havok.MaterialCombine;
    havok.HP_Shape_SetMaterial(shape, [friction, friction, restitution, GEOMETRIC_MEAN, MAXIMUM]);
  }
  addFloor(height, friction) {
    const {havok} = this;
    const body = havok.HP_Body_Create()[1];
    const shape = havok.HP_Shape_CreateBox([0, height - 1, 0], [0, 0, 0, 1], [20, 2, 20])[1];
    this.materialOf(shape, friction, 0);
    havok.HP_Body_SetShape(body, shape);
    havok.HP_Body_SetMotionType(body, havok.MotionType.STATIC);
    havok.HP_World_AddBody(this.world, body, false);
  }
  hullOf(hull) {
    const {havok} = this;
    const address = havok._malloc(12 * hull.vertices.length);
    new Float32Array(havok.HEAPU8.buffer, address, 3 * hull.vertices.length).set(hull.vertices.flat());
    const [result, shape] = havok.HP_Shape_CreateConvexHull(address, hull.vertices.length);
    havok._free(address);
    if (result !== havok.Result.RESULT_OK) throw new Error("Havok refuses a hull");
    havok.HP_Shape_SetDensity(shape, 1);
    return shape;
  }
  shapeOf(body) {
    const {havok} = this;
    const hulls = body.hulls.map((hull) => this.hullOf(hull));
    for (const hull of hulls) this.materialOf(hull, body.friction, body.restitution);
    this.friction = havok.HP_Shape_GetMaterial(hulls[0])[1][0];
    if (hulls.length === 1) return hulls[0];
    const all = havok.HP_Shape_CreateContainer()[1];
    for (const hull of hulls) havok.HP_Shape_AddChild(all, hull, [[0, 0, 0], [0, 0, 0, 1], [1, 1, 1]]);
    return all;
  }
  // The adapter. Inertia is per unit of mass.
  add(body) {
    const {havok} = this;
    const added = havok.HP_Body_Create()[1];
    const shape = this.shapeOf(body);
    const friction = this.friction;
    const {moments, rotation} = body.principal;
    havok.HP_Body_SetShape(added, shape);
    havok.HP_Body_SetMotionType(added, havok.MotionType.DYNAMIC);
    havok.HP_Body_SetQTransform(added, [body.position, body.rotation]);
    havok.HP_Body_SetMassProperties(
      added, [body.centreOfMass, body.mass, moments.map((moment) => moment / body.mass), rotation]);
    havok.HP_World_AddBody(this.world, added, false);
    const place = () => [...havok.HP_Body_GetQTransform(added)[1][0]];
    return {
      position: place,
      velocity: () => [...havok.HP_Body_GetLinearVelocity(added)[1]],
      properties: () => {
        const [centre, mass, inertia] = havok.HP_Body_GetMassProperties(added)[1];
        return {
          mass,
          centre: [...centre],
          moments: inertia.map((moment) => moment * mass),
          volume: havok.HP_Shape_BuildMassProperties(shape)[1][1],
          friction,
          position: place(),
        };
      },
    };
  }
  step() { this.havok.HP_World_Step(this.world, this.stepLength); }
  end() { this.havok.HP_World_Release(this.world); }
}
