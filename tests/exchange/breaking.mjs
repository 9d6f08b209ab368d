// Breaks bodies by their impacts, as docs/formats/pack.md says under "The break", in an engine whose contacts are known
// after its step. A body here is {body, handle, threshold, ...} with its pose and velocities from before the step.
import {add, cross, dot, length, product, rotated, scaled, solved, sub} from "./geometry.mjs";

const kLeastSpeed = 0.5;       // m/s
const kRestitutionSpeed = 1;   // m/s
const kImpactDepth = 5e-3;     // m: points that touch this much later belong to the same impact
const kSamePoint = 1e-3;       // m: engines may report a point twice

/// Keeps what the bodies are like before a step.
export function keepMotion(bodies) {
  for (const one of bodies) Object.assign(one, motionOf(one));
}
const motionOf = ({handle}) => ({position: handle.position(), rotation: handle.rotation(),
                                 velocity: handle.velocity(), angularVelocity: handle.angularVelocity()});

/// I^-1 v of a body.
function byInertia({rotation, body}, v) {
  const frame = product(rotation, body.principal.rotation);
  return body.principal.moments.reduce((sum, moment, k) => {
    const axis = rotated(frame, [0, 1, 2].map((i) => (i === k ? 1 : 0)));
    return add(sum, scaled(axis, dot(axis, v) / moment));
  }, [0, 0, 0]);
}
/// What a body adds to the inverse effective mass, 1/kg: 1/mass + (r x n) . I^-1 (r x n). Nothing where it is fixed.
function inverseMassAt(one, point, normal) {
  if (!one) return 0;
  const arm = cross(sub(point, one.position), normal);
  return 1 / one.body.mass + dot(arm, byInertia(one, arm));
}
const velocityAt = (one, point) =>
  (one ? add(one.velocity, cross(one.angularVelocity, sub(point, one.position))) : [0, 0, 0]);
const approachOf = (first, second, point, normal) =>
  dot(sub(velocityAt(first, point), velocityAt(second, point)), normal);

/// The mean of the points of a contact that touch first within the step; undefined where none does.
function pointOfImpact({points, normal}, first, second, step) {
  const approaching = points.map((point) => ({...point, speed: approachOf(first, second, point.position, normal)}))
    .filter(({depth, speed}) => speed > kLeastSpeed && -depth <= speed * step);
  const deepest = Math.max(...approaching.map(({depth}) => depth));
  const near = approaching.filter(({position, depth}, k) => depth >= deepest - kImpactDepth &&
    approaching.every((other, j) => j >= k || length(sub(other.position, position)) > kSamePoint));
  return near.length > 0 ? scaled(near.map(({position}) => position).reduce(add), 1 / near.length) : undefined;
}

/// The impact of a contact, from the velocities before the step; undefined where it does not count.
function impactOf(contact, first, second, step) {
  const {normal} = contact;
  const point = pointOfImpact(contact, first, second, step);
  if (!point) return undefined;
  const approach = approachOf(first, second, point, normal);
  if (approach <= kLeastSpeed) return undefined;
  const inverse = inverseMassAt(first, point, normal) + inverseMassAt(second, point, normal);
  const larger = Math.max(...[first, second].map((one) => one?.body.restitution ?? 0));
  const restitution = approach > kRestitutionSpeed ? larger : 0;
  return {point, normal, approach, inverse, impulse: (1 + restitution) * approach / inverse};
}

/// The largest impact of a step on each body that can break, with a normal away from the impactor, undefined for the
/// ground.
export function largestImpacts(contacts, bodyOf, step) {
  const largest = new Map();
  for (const contact of contacts) {
    const [first, second] = [bodyOf(contact.first), bodyOf(contact.second)];
    const impact = impactOf(contact, first, second, step);
    if (!impact) continue;
    for (const [one, impactor, sign] of [[first, second, -1], [second, first, 1]]) {
      if (!one?.threshold || impact.impulse <= (largest.get(one)?.impulse ?? 0)) continue;
      largest.set(one, {...impact, impactor, normal: scaled(impact.normal, sign)});
    }
  }
  return largest;
}

/// By which an impulse at a point changes the velocity there, m/s: 1/mass J + (I^-1 (r x J)) x r.
function changeAt(one, point, impulse) {
  if (!one) return [0, 0, 0];
  const arm = sub(point, one.position);
  return add(scaled(impulse, 1 / one.body.mass), cross(byInertia(one, cross(arm, impulse)), arm));
}
function applyImpulse(one, point, impulse) {
  if (!one) return;
  const {velocity, angularVelocity} = motionOf(one);
  const turning = byInertia(one, cross(sub(point, one.position), impulse));
  one.handle.setMotion(add(velocity, scaled(impulse, 1 / one.body.mass)), add(angularVelocity, turning));
}

/// Leaves to a whole that breaks the impulse of its threshold. The solver has given it all that stops the impactor, with
/// friction; an impulse between both undoes what is too much.
export function returnExcess(whole, {impactor, point, normal}) {
  const relativeVelocity = (motion) => sub(velocityAt(motion(impactor), point), velocityAt(motion(whole), point));
  const changeOf = (impulse) => add(changeAt(whole, point, impulse), changeAt(impactor, point, impulse));
  const before = relativeVelocity((one) => one);
  const after = relativeVelocity((one) => one && {...motionOf(one), position: one.position});
  const excess = sub(sub(before, changeOf(scaled(normal, whole.threshold))), after);
  if (dot(excess, normal) <= 0) return;
  const impulse = solved([[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(changeOf), excess);
  applyImpulse(impactor, point, impulse);
  applyImpulse(whole, point, scaled(impulse, -1));
}

/// The fragments that replace a body: {fragment, position, rotation, velocity, angularVelocity}.
export function fragmentsOf(one) {
  const {position, rotation, velocity, angularVelocity} = motionOf(one);
  return one.body.children.map((k) => {
    const fragment = one.pack.fragments[k];
    const arm = rotated(rotation, sub(fragment.offset, one.body.offset));
    return {fragment, position: add(position, arm), rotation, velocity: add(velocity, cross(angularVelocity, arm)),
            angularVelocity};
  });
}
