export const program = "Rapier";
export const packageName = "@dimforge/rapier3d-compat";
export const settings = [{name: "defaults", looser: {
  volume: [5e-4, "its hulls leave out points less than about a thousandth of their size outside a face"],
}}];

const xyz = ([x, y, z]) => ({x, y, z});
const xyzw = ([x, y, z, w]) => ({x, y, z, w});
const values = ({x, y, z}) => [x, y, z];

export async function start(load) {
  const RAPIER = await load(packageName);
  await RAPIER.init();
  return {world: (gravity, step) => new World(RAPIER, gravity, step)};
}

class World {
  constructor(RAPIER, gravity, step) {
    this.RAPIER = RAPIER;
    this.world = new RAPIER.World(xyz(gravity));
    this.world.timestep = step;
  }
  addFloor(height, friction) {
    const shape = this.RAPIER.ColliderDesc.cuboid(10, 1, 10).setTranslation(0, height - 1, 0).setFriction(friction);
    this.world.createCollider(shape);
  }
  // The adapter: bodies have all mass, their hulls none.
  add(body) {
    const {RAPIER, world} = this;
    const {moments, rotation} = body.principal;
    const added = world.createRigidBody(
      RAPIER.RigidBodyDesc.dynamic().setTranslation(...body.position).setRotation(xyzw(body.rotation))
        .setAdditionalMassProperties(body.mass, xyz(body.centreOfMass), xyz(moments), xyzw(rotation)));
    const colliders = body.hulls.map((hull) => world.createCollider(
      RAPIER.ColliderDesc.convexHull(new Float32Array(hull.vertices.flat())).setDensity(0)
        .setFriction(body.friction).setRestitution(body.restitution)
        .setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Max), added));
    added.recomputeMassPropertiesFromColliders();
    return {
      position: () => values(added.translation()),
      velocity: () => values(added.linvel()),
      properties: () => ({
        mass: added.mass(),
        centre: values(added.localCom()),
        moments: values(added.principalInertia()),
        volume: colliders.reduce((sum, collider) => sum + collider.volume(), 0),
        friction: colliders[0].friction(),
        position: values(added.translation()),
      }),
    };
  }
  step() { this.world.step(); }
  end() { this.world.free(); }
}
