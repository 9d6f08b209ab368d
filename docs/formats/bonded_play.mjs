// What stands of a bonded scene and what comes off, in any engine: beside bonds.mjs, which has the rules of hits.
import {breakMortar, breakOff, breakingLevel, dot, hit, isAnchor, isBroken, islandsOf, length, linksOf, massOf, minus,
        otherEnd, standingOf, structuresOf, times, withClusters} from "./bonds.mjs";

const STANDS_ON = 0.5, CORBEL = Math.tan(Math.PI / 6);
const spanOf = ({rule, instance}) => (instance.holdsHeaviest ? 0 : rule.span);
const sideways = ({up}, v) => length(minus(v, times(up, dot(v, up))));
/// Where support goes from a fragment over a bond, and how far, as a fraction of the span; nowhere over what hangs.
function stepOver(bond, number) {
  const {structure, other} = bond, next = otherEnd(bond, number);
  const span = spanOf(next === undefined && other ? other.structure : structure);
  const along = dot(bond.normal, structure.up) * (bond.ends[0] === number ? 1 : -1), isUp = along >= STANDS_ON;
  if (next === undefined) {
    if (!other || along <= -STANDS_ON) return {};
    const arm = (half) => sideways(half.structure, minus(half.centroid, half.structure.centres[half.ends[0]]));
    const step = span > 0 ? (arm(bond) + arm(other)) / span : 0;
    return {to: other.structure, there: other.ends[0], step, isAnew: isUp};
  }
  const apart = minus(structure.centres[next], structure.centres[number]), side = sideways(structure, apart);
  const step = isUp ? Math.max(0, side - CORBEL * dot(apart, structure.up)) : side;
  return {to: structure, there: next, step: span > 0 ? step / span : 0};
}
/// How far what stands is from its support, as a fraction of its span, by structure and number; of the rest, nothing.
function supportOf(standing, isIntact, limits) {
  const found = new Map([...standing.keys()].map((one) => [one, new Map()])), queue = [];
  const holds = (bond) => (isIntact ? bond.capacity > 0 : !isBroken(bond));
  const reach = (structure, number, fraction) => {
    const limit = limits ? Math.max(1, limits.get(structure).get(number) ?? Infinity) : Infinity;
    const known = found.get(structure).get(number) ?? Infinity;
    if (!standing.get(structure).has(number) || !(fraction < known) || fraction > limit) return;
    found.get(structure).set(number, fraction);
    queue.push({structure, number, fraction});
  };
  for (const structure of standing.keys()) {
    for (const number of spanOf(structure) > 0 ? [] : structure.all) reach(structure, number, 0);
    for (const bond of structure.bonds) if (isAnchor(bond) && holds(bond)) reach(structure, bond.ends[0], 0);
  }
  while (queue.length > 0) {  // Dijkstra's search
    const nearest = queue.reduce((best, one, k) => (one.fraction < queue[best].fraction ? k : best), 0);
    const [{structure, number, fraction}] = queue.splice(nearest, 1);
    for (const bond of linksOf(structure, number)) {
      if (!holds(bond) || (bond.other && !holds(bond.other))) continue;
      const {to, there, step, isAnew} = stepOver(bond, number);
      if (to) reach(to, there, isAnew ? 0 : fraction + step);
    }
  }
  return found;
}

/// The fragments that stand and have lost their support, by structure; they come off after `collapseDelay`.
export function unsupported(scene) {
  const structures = structuresOf(scene);
  scene.limits ??= supportOf(new Map(structures.map((one) => [one, new Set(one.all)])), true);
  const held = supportOf(new Map(structures.map((one) => [one, new Set(one.standing)])), false, scene.limits);
  return new Map(structures.filter((one) => spanOf(one) > 0).map((one) => {
    const supported = withClusters(one, one.standing, [...held.get(one).keys()], breakingLevel(one, one.standing));
    return [one, one.standing.filter((number) => !supported.has(number))];
  }));
}

/// The bodies of a scene: {structure, numbers, isFixed, handle}. The engine gives remove(body) and
/// add(structure, numbers, isFixed, whole): a handle, which moves as `whole` does, the body that it comes off.
export class BondedPlay {
  constructor(scene, engine) {
    Object.assign(this, {scene, engine, bodies: new Set(), collapses: new Map(), time: 0});
    for (const structure of structuresOf(scene)) {
      const standing = new Set(structure.standing);
      for (const {numbers} of islandsOf(structure, structure.all))
        this.add(structure, numbers, standing.has(numbers[0]));
    }
  }
  add(structure, numbers, isFixed, whole) {
    this.bodies.add({structure, numbers, isFixed, handle: this.engine.add(structure, numbers, isFixed, whole)});
  }
  /// Hits a body at points in the asset's frame, by an impulse in N s. Returns what bonds took of it, which broke, and
  /// the fragments of each island that came off, in the pack.
  hit(body, points, impulse) {
    const {structure} = body, outcome = hit(structure, body.numbers, points, impulse), before = new Set(this.bodies);
    if (outcome.broken.length > 0) this.split();
    const off = [...this.bodies].filter((one) => one.structure === structure && !one.isFixed && !before.has(one));
    return {...outcome, islands: off.map(({numbers}) => numbers.map((number) => structure.fragments[number]))};
  }
  /// Replaces bodies by what bonds still hold together, and plans when what has lost its support comes off.
  split() {
    breakMortar(this.scene);
    for (const body of [...this.bodies]) this.splitBody(body);
    for (const [structure, lost] of unsupported(this.scene)) {
      const isNew = lost.length > 0 && !this.collapses.has(structure);
      if (isNew) this.collapses.set(structure, this.time + structure.rule.collapseDelay);
    }
  }
  splitBody(body) {
    const {structure, numbers, isFixed} = body, isHeaviest = structure.instance.holdsHeaviest && isFixed;
    const islands = islandsOf(structure, numbers);
    if (isHeaviest) islands.sort((a, b) => massOf(b) - massOf(a))[0].isAnchored = true;
    if (islands.length === 1 && islands[0].isAnchored === isFixed) return;
    const parts = islands.flatMap((one) => {
      if (one.isAnchored || one.numbers.length >= structure.rule.minimumIsland) return [one];
      breakOff(structure, one.numbers);
      return one.numbers.map((number) => ({numbers: [number], isAnchored: false}));
    });
    this.bodies.delete(body);
    for (const part of parts) this.add(structure, part.numbers, part.isAnchored, body);
    this.engine.remove(body);
    if (isFixed) structure.standing = standingOf(parts);
  }
  /// To be called after each step: lets come off what has lost its support for long enough.
  advance(time) {
    this.time = time;
    const due = [...this.collapses].filter(([, when]) => when <= time).map(([structure]) => structure);
    for (const structure of due) {
      this.collapses.delete(structure);
      breakOff(structure, unsupported(this.scene).get(structure));
    }
    if (due.length > 0) this.split();
  }
}
