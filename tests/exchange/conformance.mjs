// What every engine is asked: whether it has the bodies of a pack, whether they stay where they are when they take the
// place of the whole (quiet swap), and whether they stand.
import {identity, length, principalOf, product, rotated, solidOf, sub} from "./geometry.mjs";

const kStep = 1 / 60;  // s
const kStanding = 5;  // s

/// The places of bodies in the world. A pane of 5 mm lies on the floor: loose, it would not stand on its edge.
export function posed(bodies, lies = false) {
  const rotation = lies ? [-Math.SQRT1_2, 0, 0, Math.SQRT1_2] : identity;
  return bodies.map((body) => ({
    ...body,
    position: rotated(rotation, body.offset),
    rotation,
    // For engines with a diagonal of inertia only: the body in the frame of its principal axes.
    principalPose: product(rotation, body.principal.rotation),
  }));
}

function lowest(bodies) {
  return Math.min(...bodies.flatMap((body) => body.hulls.flatMap((hull) =>
    hull.vertices.map((vertex) => body.position[1] + rotated(body.rotation, vertex)[1]))));
}

const relative = (is, should) => Math.abs(is - should) / Math.abs(should);
const largest = (values) => values.reduce((most, value) => (value > most || Number.isNaN(value) ? value : most), 0);

/// How far what an engine has is from the pack: lengths in m, others relative; undefined what it does not report.
export function errorsOf(found, bodies) {
  const over = (key, error) => {
    const known = bodies.filter((_, k) => found[k][key] !== undefined);
    return known.length === 0 ? undefined : largest(known.map((body) => error(found[bodies.indexOf(body)][key], body)));
  };
  const volumeOf = (body) => body.hulls.reduce((sum, hull) => sum + solidOf(hull).volume, 0);
  return {
    mass: over("mass", (mass, body) => relative(mass, body.mass)),
    centre: over("centre", (centre, body) => length(sub(centre, body.centreOfMass))),
    inertia: over("moments", (moments, body) => largest(
      [...moments].sort((a, b) => b - a).map((moment, k) => relative(moment, body.principal.moments[k])))),
    volume: over("volume", (volume, body) => relative(volume, volumeOf(body))),
    friction: over("friction", (friction, body) => Math.abs(friction - body.friction)),
    pose: over("position", (position, body) => length(sub(position, body.position))),
  };
}

/// Bodies in a world of an engine: their properties; after `seconds` their largest speed, m/s, and displacement, m; and
/// how far they moved in the second half of it, m. `afterStep`, if any, gets the world and the number of each step.
export function run(engine, setting, bodies, {gravity, seconds, hasFloor, afterStep}) {
  const world = engine.world([0, gravity, 0], kStep, setting);
  if (hasFloor) world.addFloor(lowest(bodies), bodies[0].friction);
  const added = bodies.map((body) => world.add(body));
  world.finish?.();
  const found = added.map((body) => body.properties());
  const steps = Math.round(seconds / kStep);
  const halfway = [];
  for (let step = 0; step < steps; ++step) {
    world.step();
    afterStep?.(world, step);
    if (step === steps >> 1) halfway.push(...added.map((body) => body.position()));
  }
  const drift = largest(added.map((body, k) => length(sub(body.position(), halfway[k]))));
  const displacement = largest(added.map((body, k) => length(sub(body.position(), bodies[k].position))));
  // Engines may also move bodies without giving them a velocity.
  const speed = Math.max(largest(added.map((body) => length(body.velocity()))), displacement / seconds);
  world.end?.();
  return {found, speed, displacement, drift};
}

/// A row of measured figures: {count, errors, swap in m/s, standing and drift in m}.
export function measure(engine, setting, fragments, lies) {
  const bodies = posed(fragments, lies);
  const swap = run(engine, setting, bodies, {gravity: 0, seconds: kStep, hasFloor: false});
  const standing = run(engine, setting, bodies, {gravity: -9.81, seconds: kStanding, hasFloor: true});
  return {count: swap.found.length, errors: errorsOf(swap.found, bodies), swap: swap.speed,
          standing: standing.displacement, drift: standing.drift};
}

/// Such a row of what a program in C++ has printed.
export function rowOf(report, fragments, lies) {
  const found = report.found.map((body) => ({...body, moments: body.inertia && principalOf(body.inertia).moments}));
  return {...report, count: found.length, errors: errorsOf(found, posed(fragments, lies))};
}
