import {conjugate, rotated, solidOf, sub} from "../geometry.mjs";

export const program = "cannon-es";
export const packageName = "cannon-es";
const creeping = "stacks creep with 10 iterations of its solver, and less, but still, with 50";
export const settings = [{name: "defaults", looser: {standing: [0.2, creeping], drift: [0.1, creeping]}}];
export const slow = ["pane"];  // it tests every face and edge of a pair

export async function start(load) {
  const CANNON = await load(packageName);
  return {world: (gravity, step) => new World(CANNON, gravity, step)};
}

const values = ({x, y, z}) => [x, y, z];

class World {
  constructor(CANNON, gravity, step) {
    this.CANNON = CANNON;
    this.stepLength = step;
    this.world = new CANNON.World({gravity: new CANNON.Vec3(...gravity)});
  }
  addFloor(height, friction) {
    const {CANNON} = this;
    const material = new CANNON.Material({friction: Math.sqrt(friction), restitution: 0});
    const floor = new CANNON.Body({mass: 0, material, shape: new CANNON.Box(new CANNON.Vec3(10, 1, 10))});
    floor.position.set(0, height - 1, 0);
    this.world.addBody(floor);
  }
  // The adapter. Inertia is a diagonal, so the body has the frame of its principal axes.
  add(body) {
    const {CANNON} = this;
    const {moments, rotation} = body.principal;
    const added = new CANNON.Body({mass: body.mass});
    // The friction of a pair is the product of both.
    added.material = new CANNON.Material({friction: Math.sqrt(body.friction), restitution: body.restitution});
    for (const hull of body.hulls) {
      // The origin of a polyhedron must be inside.
      const {centroid} = solidOf(hull);
      const inFrame = (point) => new CANNON.Vec3(...rotated(conjugate(rotation), point));
      const vertices = hull.vertices.map((vertex) => inFrame(sub(vertex, centroid)));
      const faces = hull.faces.map((face) => [...face]);
      added.addShape(new CANNON.ConvexPolyhedron({vertices, faces}), inFrame(centroid));
    }
    added.position.set(...body.position);
    added.quaternion.set(...body.principalPose);
    added.inertia.set(...moments);
    added.invInertia.set(...moments.map((moment) => 1 / moment));
    added.updateInertiaWorld(true);
    this.world.addBody(added);
    return {
      position: () => values(added.position),
      velocity: () => values(added.velocity),
      properties: () => ({
        mass: added.mass,
        moments: values(added.invInertia).map((inverse) => 1 / inverse),
        friction: added.material.friction ** 2,
        position: values(added.position),
      }),
    };
  }
  step() { this.world.step(this.stepLength); }
}
