export const program = "Jolt Physics";
export const packageName = "jolt-physics";
export const settings = [{name: "defaults", looser: {
  volume: [1.2e-2, "its hulls leave out points nearer than 1 mm to a face (mHullTolerance)"],
}}];

const kMoving = 1, kFixed = 0;  // layers

export async function start(load) {
  const Jolt = await (await load(packageName)).default();
  return {world: (gravity, step) => new World(Jolt, gravity, step)};
}

function interfaceOf(Jolt) {
  const settings = new Jolt.JoltSettings();
  const pairs = new Jolt.ObjectLayerPairFilterTable(2);
  pairs.EnableCollision(kFixed, kMoving);
  pairs.EnableCollision(kMoving, kMoving);
  const broadPhase = new Jolt.BroadPhaseLayerInterfaceTable(2, 2);
  for (const layer of [kFixed, kMoving]) broadPhase.MapObjectToBroadPhaseLayer(layer, new Jolt.BroadPhaseLayer(layer));
  settings.mObjectLayerPairFilter = pairs;
  settings.mBroadPhaseLayerInterface = broadPhase;
  settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(broadPhase, 2, pairs, 2);
  const jolt = new Jolt.JoltInterface(settings);
  Jolt.destroy(settings);
  return jolt;
}

class World {
  constructor(Jolt, gravity, step) {
    this.Jolt = Jolt;
    this.stepLength = step;
    this.jolt = interfaceOf(Jolt);
    this.system = this.jolt.GetPhysicsSystem();
    this.system.SetGravity(new Jolt.Vec3(...gravity));
    this.bodies = this.system.GetBodyInterface();
  }
  addFloor(height, friction) {
    const {Jolt} = this;
    const settings = new Jolt.BodyCreationSettings(new Jolt.BoxShape(new Jolt.Vec3(10, 1, 10), 0.05),
      new Jolt.RVec3(0, height - 1, 0), new Jolt.Quat(0, 0, 0, 1), Jolt.EMotionType_Static, kFixed);
    settings.mFriction = friction;
    this.bodies.CreateAndAddBody(settings, Jolt.EActivation_DontActivate);
  }
  shapeOf(hulls) {
    const {Jolt} = this;
    const shapes = hulls.map((hull) => {
      const settings = new Jolt.ConvexHullShapeSettings();
      for (const vertex of hull.vertices) settings.mPoints.push_back(new Jolt.Vec3(...vertex));
      const result = settings.Create();
      if (!result.IsValid()) throw new Error(result.GetError().c_str());
      return result.Get();
    });
    if (shapes.length === 1) return shapes[0];
    const all = new Jolt.StaticCompoundShapeSettings();
    for (const shape of shapes) all.AddShapeShape(new Jolt.Vec3(0, 0, 0), new Jolt.Quat(0, 0, 0, 1), shape, 0);
    return all.Create().Get();
  }
  // The adapter.
  add(body) {
    const {Jolt} = this;
    // A shape has the centre of mass of its hulls; this one that of the fragment.
    const hulls = this.shapeOf(body.hulls);
    const centre = hulls.GetCenterOfMass();
    const [x, y, z] = body.centreOfMass;
    const shape = new Jolt.OffsetCenterOfMassShape(
      hulls, new Jolt.Vec3(x - centre.GetX(), y - centre.GetY(), z - centre.GetZ()));
    const settings = new Jolt.BodyCreationSettings(shape, new Jolt.RVec3(...body.position),
      new Jolt.Quat(...body.rotation), Jolt.EMotionType_Dynamic, kMoving);
    settings.mOverrideMassProperties = Jolt.EOverrideMassProperties_MassAndInertiaProvided;
    settings.mMassPropertiesOverride.mMass = body.mass;
    for (let k = 0; k < 3; ++k) {
      settings.mMassPropertiesOverride.mInertia.SetColumn3(k, new Jolt.Vec3(...body.inertia[k]));
    }
    settings.mFriction = body.friction;
    settings.mRestitution = body.restitution;
    const added = this.bodies.CreateBody(settings);
    this.bodies.AddBody(added.GetID(), Jolt.EActivation_Activate);
    const values = (v) => [v.GetX(), v.GetY(), v.GetZ()];
    return {
      position: () => values(added.GetPosition()),
      velocity: () => values(added.GetLinearVelocity()),
      properties: () => ({
        mass: 1 / added.GetMotionProperties().GetInverseMass(),
        centre: values(shape.GetCenterOfMass()),
        moments: values(added.GetMotionProperties().GetInverseInertiaDiagonal()).map((inverse) => 1 / inverse),
        volume: shape.GetVolume(),
        friction: added.GetFriction(),
        position: values(added.GetPosition()),
      }),
    };
  }
  step() { this.jolt.Step(this.stepLength, 1); }
  end() { this.Jolt.destroy(this.jolt); }
}
