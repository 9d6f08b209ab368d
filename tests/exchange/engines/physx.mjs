import {readFileSync} from "node:fs";
import {join} from "node:path";
import {asInBrowser} from "../packages.mjs";

export const program = "PhysX 5.6.1";
export const packageName = "physx-js-webidl";
const merged = "cooking merges planes that are nearly one (planeTolerance)";
const edges = "its persistent manifolds (eENABLE_PCM) find an overlap of hulls that are diagonal to each other at an edge";
export const settings = [
  {name: "defaults", looser: {
    volume: [2e-3, merged],
    standing: [3e-2, "4 iterations of the solver PGS let stacks sink"],
  }, round: {volume: [8e-2, merged], overlap: [2e-3, merged], swap: [5e-3, merged]}},
  {name: "solver TGS, 8 iterations, planeTolerance 1e-5", usesTgs: true, iterations: 8, planeTolerance: 1e-5, round: {
    volume: [5e-4, merged],
    overlap: [2.5e-4, edges],
  }},
];
/// Further settings for sculptures.mjs.
export const variants = [{...settings[1], name: "the same without persistent manifolds", withoutPcm: true, round: {
  volume: [5e-4, merged],
}}];

export async function start(load, folder) {
  const wasmBinary = readFileSync(join(folder, "physx-js-webidl.wasm"));
  const {default: PhysX} = await load(packageName);
  const Px = await asInBrowser(() => PhysX({wasmBinary}));
  const top = Px.PxTopLevelFunctions.prototype;
  const version = Px.PHYSICS_VERSION;
  const foundation = top.CreateFoundation(version, new Px.PxDefaultAllocator(), new Px.PxDefaultErrorCallback());
  const scale = new Px.PxTolerancesScale();
  const physics = top.CreatePhysics(version, foundation, scale);
  const cooking = new Px.PxCookingParams(scale);
  const dispatcher = top.DefaultCpuDispatcherCreate(0);
  const sdk = {Px, top, physics, scale, cooking, dispatcher};
  return {world: (gravity, step, setting) => new World(sdk, gravity, step, setting)};
}

const values = ({x, y, z}) => [x, y, z];
const fourValues = ({x, y, z, w}) => [x, y, z, w];
const kMostPoints = 64;  // of a pair

class World {
  constructor(sdk, gravity, step, setting) {
    Object.assign(this, sdk, {setting});
    const {Px, top} = sdk;
    this.stepLength = step;
    this.cooking.planeTolerance = setting.planeTolerance ?? 7e-4;  // its default
    const description = new Px.PxSceneDesc(this.scale);
    description.gravity = new Px.PxVec3(...gravity);
    description.cpuDispatcher = this.dispatcher;
    if (setting.usesTgs) description.solverType = Px.PxSolverTypeEnum.eTGS;
    if (setting.withoutPcm) description.flags.clear(Px.PxSceneFlagEnum.eENABLE_PCM);
    this.reportContacts(description);
    this.scene = this.physics.createScene(description);
  }
  /// Keeps the contacts of each step, also those of continuous collision detection.
  reportContacts(description) {
    const {Px, top} = this;
    const {eCONTACT_DEFAULT, eDETECT_CCD_CONTACT, eNOTIFY_CONTACT_POINTS, eNOTIFY_TOUCH_FOUND, eNOTIFY_TOUCH_PERSISTS,
           eNOTIFY_TOUCH_CCD} = Px.PxPairFlagEnum;
    this.shader = new Px.PassThroughFilterShaderImpl();
    this.shader.filterShader = () => {
      Px.wrapPointer(Px.getPointer(this.shader), Px.PassThroughFilterShader).outputPairFlags = eCONTACT_DEFAULT |
        eDETECT_CCD_CONTACT | eNOTIFY_CONTACT_POINTS | eNOTIFY_TOUCH_FOUND | eNOTIFY_TOUCH_PERSISTS | eNOTIFY_TOUCH_CCD;
      return 0;  // the pair is simulated
    };
    top.setupPassThroughFilterShader(description, this.shader);
    this.callback = new Px.PxSimulationEventCallbackImpl();
    for (const event of ["onConstraintBreak", "onWake", "onSleep", "onTrigger"]) this.callback[event] = () => {};
    this.callback.onContact = (header, pairs, count) => this.keep(header, pairs, count);
    description.simulationEventCallback = this.callback;
    description.flags.raise(Px.PxSceneFlagEnum.eENABLE_CCD);
    this.points = new Px.PxArray_PxContactPairPoint(kMostPoints);
    this.bodies = new Map();  // by addresses
    this.found = [];
  }
  keep(header, pairs, count) {
    const {Px} = this;
    const [first, second] = [0, 1].map((k) =>
      this.bodies.get(Px.getPointer(Px.wrapPointer(header, Px.PxContactPairHeader).get_actors(k))));
    for (let k = 0; k < count; ++k) {
      const pair = Px.NativeArrayHelpers.prototype.getContactPairAt(Px.wrapPointer(pairs, Px.PxContactPair), k);
      const size = pair.extractContacts(this.points.begin(), kMostPoints);
      // Those of a pair have several normals where there are several hulls or patches; these point to the first body.
      const patches = new Map();
      for (let i = 0; i < size; ++i) {
        const {position, normal, separation} = this.points.get(i);
        const key = values(normal).join();
        if (!patches.has(key)) patches.set(key, {first, second, points: [], normal: values(normal).map((x) => -x)});
        patches.get(key).points.push({position: values(position), depth: -separation});
      }
      this.found.push(...patches.values());
    }
  }
  /// A shape of an actor, which then collides with all others.
  attach(actor, geometry, friction, restitution) {
    const {Px} = this;
    const material = this.physics.createMaterial(friction, friction, restitution);
    const flags = new Px.PxShapeFlags(Px.PxShapeFlagEnum.eSIMULATION_SHAPE | Px.PxShapeFlagEnum.eSCENE_QUERY_SHAPE);
    const shape = this.physics.createShape(geometry, material, true, flags);
    shape.setSimulationFilterData(new Px.PxFilterData(1, 1, 0, 0));
    actor.attachShape(shape);
    return material;
  }
  addFloor(height, friction) {
    const {Px} = this;
    const pose = new Px.PxTransform(new Px.PxVec3(0, height - 1, 0), new Px.PxQuat(0, 0, 0, 1));
    const floor = this.physics.createRigidStatic(pose);
    this.attach(floor, new Px.PxBoxGeometry(10, 1, 10), friction, 0);
    this.scene.addActor(floor);
  }
  hullOf(hull) {
    const {Px} = this;
    const points = new Px.PxArray_PxVec3();
    for (const vertex of hull.vertices) points.pushBack(new Px.PxVec3(...vertex));
    const description = new Px.PxConvexMeshDesc();
    description.points.count = points.size();
    description.points.stride = 12;
    description.points.data = points.begin();
    description.flags = new Px.PxConvexFlags(Px.PxConvexFlagEnum.eCOMPUTE_CONVEX);
    const mesh = this.top.CreateConvexMesh(this.cooking, description);
    if (!mesh || !Px.getPointer(mesh)) throw new Error("PhysX cooks no mesh of a hull");
    return new Px.PxConvexMeshGeometry(mesh);
  }
  /// The number of convex hulls that an actor has.
  hullsOf(actor) {
    const {Px} = this;
    const count = actor.getNbShapes();
    const shapes = new Px.PxArray_PxShapePtr(count);
    actor.getShapes(shapes.begin(), count, 0);
    const types = Array.from({length: count}, (_, k) => shapes.get(k).getGeometry().getType());
    return types.filter((type) => type === Px.PxGeometryTypeEnum.eCONVEXMESH).length;
  }
  // The adapter.
  add(body) {
    const {Px} = this;
    const transform = (position, rotation) => new Px.PxTransform(new Px.PxVec3(...position), new Px.PxQuat(...rotation));
    const added = this.physics.createRigidDynamic(transform(body.position, body.rotation));
    const geometries = body.radius ? [new Px.PxSphereGeometry(body.radius)] : body.hulls.map((hull) => this.hullOf(hull));
    if (body.isFast) added.setRigidBodyFlag(Px.PxRigidBodyFlagEnum.eENABLE_CCD, true);
    const materials = geometries.map((hull) => this.attach(added, hull, body.friction, body.restitution));
    if (this.setting.iterations) added.setSolverIterationCounts(this.setting.iterations, 1);
    added.setMass(body.mass);
    added.setMassSpaceInertiaTensor(new Px.PxVec3(...body.principal.moments));
    added.setCMassLocalPose(transform(body.centreOfMass, body.principal.rotation));
    this.scene.addActor(added);
    const handle = {
      added,
      position: () => values(added.getGlobalPose().p),
      rotation: () => fourValues(added.getGlobalPose().q),
      angularVelocity: () => values(added.getAngularVelocity()),
      setMotion: (velocity, angularVelocity) => {
        added.setLinearVelocity(new Px.PxVec3(...velocity));
        added.setAngularVelocity(new Px.PxVec3(...angularVelocity));
      },
      velocity: () => values(added.getLinearVelocity()),
      properties: () => ({
        mass: added.getMass(),
        centre: values(added.getCMassLocalPose().p),
        moments: values(added.getMassSpaceInertiaTensor()),
        volume: geometries.reduce((sum, hull) => sum + new Px.PxMassProperties(hull).mass, 0),
        hulls: this.hullsOf(added),
        friction: materials[0].getStaticFriction(),
        position: values(added.getGlobalPose().p),
      }),
    };
    this.bodies.set(Px.getPointer(added), handle);
    return handle;
  }
  remove({added}) {
    this.bodies.delete(this.Px.getPointer(added));
    added.release();
  }
  contacts() { return this.found; }
  step() {
    this.found = [];
    this.scene.simulate(this.stepLength);
    this.scene.fetchResults(true);
  }
}
