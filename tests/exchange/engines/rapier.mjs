export const program = "Rapier";
export const packageName = "@dimforge/rapier3d-compat";
const simplified = "its hulls leave out points less than about a thousandth of their size outside a face";
const absolute = "the tolerances of its search for the nearest points are lengths: small hulls that are apart seem to overlap";
export const settings = [{name: "defaults", looser: {volume: [5e-4, simplified]}, round: {
  volume: [8e-3, simplified],
  overlap: [4e-2, absolute],
  swap: [0.15, absolute],
}}];
/// Further settings for sculptures.mjs.
export const variants = [{name: "lengths × 10", perMetre: 10, round: {volume: [8e-3, simplified]}}];

const xyz = ([x, y, z]) => ({x, y, z});
const xyzw = ([x, y, z, w]) => ({x, y, z, w});
const values = ({x, y, z}) => [x, y, z];
const fourValues = ({x, y, z, w}) => [x, y, z, w];

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
    this.bodies = new Map();  // by Rapier's handles
  }
  addFloor(height, friction) {
    const shape = this.RAPIER.ColliderDesc.cuboid(10, 1, 10).setTranslation(0, height - 1, 0).setFriction(friction);
    this.world.createCollider(shape);
  }
  shapesOf({hulls, radius}) {
    const {ColliderDesc} = this.RAPIER;
    if (radius) return [ColliderDesc.ball(radius)];
    return hulls.map((hull) => ColliderDesc.convexHull(new Float32Array(hull.vertices.flat())));
  }
  // The adapter: bodies have all mass, their hulls none.
  add(body) {
    const {RAPIER, world} = this;
    const {moments, rotation} = body.principal;
    const added = world.createRigidBody(
      RAPIER.RigidBodyDesc.dynamic().setTranslation(...body.position).setRotation(xyzw(body.rotation))
        .setCcdEnabled(body.isFast ?? false)
        .setAdditionalMassProperties(body.mass, xyz(body.centreOfMass), xyz(moments), xyzw(rotation)));
    const colliders = this.shapesOf(body).map((shape) => world.createCollider(
      shape.setDensity(0).setFriction(body.friction).setRestitution(body.restitution)
        .setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Max), added));
    added.recomputeMassPropertiesFromColliders();
    const handle = {
      added,
      position: () => values(added.translation()),
      rotation: () => fourValues(added.rotation()),
      velocity: () => values(added.linvel()),
      angularVelocity: () => values(added.angvel()),
      setMotion: (velocity, angularVelocity) => {
        added.setLinvel(xyz(velocity), true);
        added.setAngvel(xyz(angularVelocity), true);
      },
      properties: () => ({
        mass: added.mass(),
        centre: values(added.localCom()),
        moments: values(added.principalInertia()),
        volume: colliders.reduce((sum, collider) => sum + collider.volume(), 0),
        hulls: colliders.filter((collider) => collider.shapeType() === RAPIER.ShapeType.ConvexPolyhedron).length,
        friction: colliders[0].friction(),
        position: values(added.translation()),
      }),
    };
    this.bodies.set(added.handle, handle);
    return handle;
  }
  remove({added}) {
    this.bodies.delete(added.handle);
    this.world.removeRigidBody(added);
  }
  /// The contacts that the last step solved: {first, second, points: [{position, depth}], normal towards the second}.
  contacts() {
    const contacts = [];
    const bodyOf = (collider) => this.bodies.get(collider.parent()?.handle);
    const visit = (one, other) => this.world.contactPair(one, other, (manifold, isFlipped) => {
      const count = manifold.numSolverContacts();
      if (count === 0) return;
      const points = Array.from({length: count}, (_, k) =>
        ({position: values(manifold.solverContactPoint(k)), depth: -manifold.solverContactDist(k)}));
      const [first, second] = (isFlipped ? [other, one] : [one, other]).map(bodyOf);
      contacts.push({first, second, points, normal: values(manifold.normal())});
    });
    this.world.forEachCollider((one) => this.world.contactPairsWith(one, (other) => {
      if (one.handle < other.handle) visit(one, other);
    }));
    return contacts;
  }
  step() { this.world.step(); }
  end() { this.world.free(); }
}
