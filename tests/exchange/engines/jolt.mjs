import {dot, sub} from "../geometry.mjs";

export const program = "Jolt Physics";
export const packageName = "jolt-physics";
const simplified = "its hulls leave out points nearer than 1 mm to a face (mHullTolerance)";
export const settings = [
  {name: "defaults", looser: {volume: [1.2e-2, simplified]}, round: {volume: [8e-2, simplified]}},
];

const values = (v) => [v.GetX(), v.GetY(), v.GetZ()];
const fourValues = (q) => [...values(q), q.GetW()];

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
    this.handles = new Map();  // by Jolt's ids
    this.found = [];
    this.system.SetContactListener(this.listener());
  }
  /// Keeps the contacts of a step. Bodies that nearly touch have some, too.
  listener() {
    const {Jolt} = this;
    const keep = (first, second, pointer) => {
      const manifold = Jolt.wrapPointer(pointer, Jolt.ContactManifold);
      const normal = values(manifold.mWorldSpaceNormal);
      const points = Array.from({length: manifold.mRelativeContactPointsOn1.size()}, (_, k) => {
        const on1 = values(manifold.GetWorldSpaceContactPointOn1(k)), on2 = values(manifold.GetWorldSpaceContactPointOn2(k));
        return {position: on1, depth: dot(sub(on1, on2), normal)};
      });
      const [one, other] = [first, second].map((body) =>
        this.handles.get(Jolt.wrapPointer(body, Jolt.Body).GetID().GetIndexAndSequenceNumber()));
      this.found.push({first: one, second: other, points, normal});
    };
    const listener = new Jolt.ContactListenerJS();
    listener.OnContactValidate = () => Jolt.ValidateResult_AcceptAllContactsForThisBodyPair;
    listener.OnContactAdded = keep;
    listener.OnContactPersisted = keep;
    listener.OnContactRemoved = () => {};
    return listener;
  }
  addFloor(height, friction) {
    const {Jolt} = this;
    const settings = new Jolt.BodyCreationSettings(new Jolt.BoxShape(new Jolt.Vec3(10, 1, 10), 0.05),
      new Jolt.RVec3(0, height - 1, 0), new Jolt.Quat(0, 0, 0, 1), Jolt.EMotionType_Static, kFixed);
    settings.mFriction = friction;
    this.bodies.CreateAndAddBody(settings, Jolt.EActivation_DontActivate);
  }
  shapeOf({hulls, radius}) {
    const {Jolt} = this;
    if (radius) return new Jolt.SphereShape(radius);
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
  /// The number of convex hulls that a shape has.
  hullsOf(shape) {
    const {Jolt} = this;
    const type = shape.GetSubType();
    if (type === Jolt.EShapeSubType_ConvexHull) return 1;
    if (type !== Jolt.EShapeSubType_StaticCompound) return 0;
    const all = Jolt.castObject(shape, Jolt.StaticCompoundShape);
    return Array.from({length: all.GetNumSubShapes()}, (_, k) => this.hullsOf(all.GetSubShape(k).mShape))
      .reduce((sum, count) => sum + count);
  }
  // The adapter.
  add(body) {
    const {Jolt} = this;
    // A shape has the centre of mass of its hulls; this one that of the fragment.
    const hulls = this.shapeOf(body);
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
    if (body.isFast) {
      settings.mMotionQuality = Jolt.EMotionQuality_LinearCast;
      settings.mLinearDamping = 0;
      settings.mAngularDamping = 0;
    }
    const added = this.bodies.CreateBody(settings);
    this.bodies.AddBody(added.GetID(), Jolt.EActivation_Activate);
    const handle = {
      added,
      position: () => values(added.GetPosition()),
      rotation: () => fourValues(added.GetRotation()),
      velocity: () => values(added.GetLinearVelocity()),
      angularVelocity: () => values(added.GetAngularVelocity()),
      setMotion: (velocity, angularVelocity) =>
        this.bodies.SetLinearAndAngularVelocity(added.GetID(), new Jolt.Vec3(...velocity), new Jolt.Vec3(...angularVelocity)),
      properties: () => ({
        mass: 1 / added.GetMotionProperties().GetInverseMass(),
        centre: values(shape.GetCenterOfMass()),
        moments: values(added.GetMotionProperties().GetInverseInertiaDiagonal()).map((inverse) => 1 / inverse),
        volume: shape.GetVolume(),
        hulls: this.hullsOf(hulls),
        friction: added.GetFriction(),
        position: values(added.GetPosition()),
      }),
    };
    this.handles.set(added.GetID().GetIndexAndSequenceNumber(), handle);
    return handle;
  }
  remove({added}) {
    const id = added.GetID();
    this.handles.delete(id.GetIndexAndSequenceNumber());
    this.bodies.RemoveBody(id);
    this.bodies.DestroyBody(id);
  }
  contacts() { return this.found; }
  step() {
    this.found = [];
    this.jolt.Step(this.stepLength, 1);
  }
  end() { this.Jolt.destroy(this.jolt); }
}
