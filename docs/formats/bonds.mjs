// Reads a scene.json with its packs and breaks the bonds of bonded instances, by the rules of pack.md and scene.md.
// One module, no dependencies. Fragments are numbered in each structure; `fragments[number]` is that of the pack.
import {readFileSync} from "node:fs";
import {join} from "node:path";

const BROKEN = 255;
export const plus = (a, b) => a.map((v, k) => v + b[k]);
export const minus = (a, b) => a.map((v, k) => v - b[k]);
export const times = (a, factor) => a.map((v) => v * factor);
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const length = (a) => Math.hypot(...a);
export function rotated([x, y, z, w], v) {
  const s = cross([x, y, z], v), t = cross([x, y, z], s);
  return v.map((value, k) => value + 2 * (w * s[k] + t[k]));
}
export const unrotated = ([x, y, z, w], v) => rotated([-x, -y, -z, w], v);

/// The instances of a scene; those that break bonded have a structure: bonds, their damage, and the numbers that stand.
export function loadScene(folder) {
  const scene = JSON.parse(readFileSync(join(folder, "scene.json"), "utf8"));
  const packs = new Map(scene.packs.map(({folder: name, physicsHash}) => {
    const pack = JSON.parse(readFileSync(join(folder, name, "pack.json"), "utf8"));
    if (pack.physicsHash !== physicsHash) throw new Error(`${name} is of another export than the scene`);
    return [name, pack];
  }));
  for (const instance of scene.instances) {
    instance.pack = packs.get(instance.pack);
    if (instance.pack.bonding && !instance.unbreakable) instance.structure = structureOf(scene, instance);
  }
  const byId = new Map(scene.instances.map((one) => [one.id, one]));
  for (const joint of scene.joints ?? []) addJoint(joint, joint.instances.map((id) => byId.get(id)));
  breakMortar(scene);
  for (const structure of structuresOf(scene)) {
    const islands = islandsOf(structure, structure.all).sort((a, b) => massOf(b) - massOf(a));
    if (structure.instance.holdsHeaviest) islands[0].isAnchored = true;
    structure.standing = standingOf(islands);
  }
  return scene;
}
/// The numbers of what is anchored, ascending.
export const standingOf = (islands) =>
  islands.filter(({isAnchored}) => isAnchored).flatMap(({numbers}) => numbers).sort((a, b) => a - b);
/// The solids that a body collides as: an instance of which nothing has come off, `isFirst`, as the whole.
export const solidsOf = ({instance: {pack}, fragments, all}, numbers, isFirst) =>
  isFirst && numbers.length === all.length ? [pack.whole] : numbers.map((number) => pack.fragments[fragments[number]]);
export const structuresOf = (scene) => scene.instances.map(({structure}) => structure).filter(Boolean);
export const massOf = ({structure, numbers}) => numbers.reduce((sum, number) => sum + structure.masses[number], 0);

function structureOf(scene, instance) {
  const {pack, anchors = [], bondStrength = 1} = instance, {bonding} = pack;
  const fragments = pack.fragments.map((_, k) => k).filter((k) => pack.fragments[k].parent === null);
  const structure = {instance, rule: bonding, fragments, bonds: [], damage: [], bondsOf: fragments.map(() => []),
                     all: fragments.map((_, number) => number), standing: [],
                     centres: fragments.map((k) => pack.fragments[k].offset),
                     masses: fragments.map((k) => pack.fragments[k].mass),
                     up: unrotated(instance.rotation, times(scene.gravity, -1 / length(scene.gravity)))};
  for (const bond of bonding.fractures.find(({fragment}) => fragment === null)?.bonds ?? [])
    addBond(structure, bond.fragments, {...bond, capacity: (bond.capacity ?? Infinity) * bondStrength});
  for (const anchor of anchors)
    addBond(structure, [anchor.fragment], {...anchor, capacity: anchor.capacity ?? Infinity});
  return structure;
}
function addBond(structure, fragments, {centroid, normal, capacity, clusterLevel = 0}) {
  const ends = fragments.map((fragment) => structure.fragments.indexOf(fragment));
  if (ends.includes(-1)) throw new Error(`${structure.instance.name} has no such fragment`);
  for (const end of ends) structure.bondsOf[end].push(structure.bonds.length);
  structure.damage.push(0);
  structure.bonds.push({structure, index: structure.bonds.length, ends, centroid, normal, capacity, clusterLevel});
  return structure.bonds.at(-1);
}
/// Each half of a joint is a bond to an anchor in the structure of its instance.
function addJoint({fragments, centroid, normal, capacity}, instances) {
  const halves = instances.map(({structure, position, rotation}, side) => addBond(structure, [fragments[side]], {
    centroid: unrotated(rotation, minus(centroid, position)), capacity: capacity ?? Infinity,
    normal: unrotated(rotation, times(normal, side ? -1 : 1))}));
  if (halves.length > 1) [halves[0].other, halves[1].other] = [halves[1], halves[0]];
}

export const isBroken = ({structure, index, capacity}) => structure.damage[index] === BROKEN || !(capacity > 0);
export const isAnchor = ({ends, other}) => ends.length === 1 && !other;
export const otherEnd = ({ends}, number) => (ends[0] === number ? ends[1] : ends[0]);
export const linksOf = (structure, number) => structure.bondsOf[number].map((bond) => structure.bonds[bond]);

export function breakingLevel(structure, body) {
  const isIn = new Set(body);
  const levels = structure.bonds.filter((bond) => bond.ends.length === 2 && bond.ends.every((end) => isIn.has(end)) &&
    !isBroken(bond) && bond.capacity < Infinity).map(({clusterLevel}) => clusterLevel);
  return Math.min(Infinity, ...levels);
}
/// With the rest of the clusters that these fragments are of.
export function withClusters(structure, body, numbers, level) {
  const isIn = new Set(body), found = new Set(numbers), queue = [...numbers];
  while (queue.length > 0) {
    const number = queue.pop();
    for (const bond of linksOf(structure, number)) {
      const next = otherEnd(bond, number);
      if (!isIn.has(next) || found.has(next) || isBroken(bond) || bond.clusterLevel <= level) continue;
      found.add(next);
      queue.push(next);
    }
  }
  return found;
}

/// How a projectile starts: its z axis is opposite to its path, its x axis horizontal.
export function throwOf({from, to, speed}) {
  const path = minus(to, from), z = times(path, -1 / length(path)), side = [z[2], 0, -z[0]], across = length(side);
  const x = across > 0 ? times(side, 1 / across) : [1, 0, 0], y = cross(z, x);
  const w = Math.sqrt(Math.max(0, 1 + x[0] + y[1] + z[2])) / 2;  // above 0: x is horizontal
  const rotation = [(y[2] - z[1]) / (4 * w), (z[0] - x[2]) / (4 * w), (x[1] - y[0]) / (4 * w), w];
  return {rotation, velocity: times(z, -speed)};
}

/// Of contacts {hull, point, distance}, those at most 5 mm behind the first, as one for each hull, at the mean point:
/// what touches at the same time is one hit of several points.
export function firstTouches(contacts) {
  const first = Math.min(...contacts.map(({distance}) => distance)) + 0.005, hulls = new Map();
  for (const one of contacts.filter(({distance}) => distance <= first))
    hulls.set(one.hull, [...(hulls.get(one.hull) ?? []), one]);
  const mean = (all) => times(all.map(({point}) => point).reduce(plus), 1 / all.length);
  return [...hulls.values()].map((all) => ({...all[0], point: mean(all)}));
}

/// Breaks and damages the bonds of a body by an impulse, N s, at points in the asset's frame.
export function hit(structure, body, points, impulse) {
  const {rule, bonds, damage} = structure, isIn = new Set(body), level = breakingLevel(structure, body);
  const nearest = (point) => body.reduce((best, number) => (
    length(minus(structure.centres[number], point)) < length(minus(structure.centres[best], point)) ? number : best));
  const struck = withClusters(structure, body, new Set(points.map(nearest)), level);
  const fall = {constant: () => 1, linear: (x) => 1 - x, smooth: (x) => 1 - x * x * (3 - 2 * x)}[rule.falloff];
  const loaded = bonds
    .filter((bond) => bond.ends.every((end) => isIn.has(end)) && !isBroken(bond) && bond.clusterLevel <= level)
    .map((bond) => {
      const distance = Math.min(...points.map((point) => length(minus(bond.centroid, point))));
      const x = distance / rule.falloffRadius;
      const fraction = bond.ends.some((end) => struck.has(end)) ? 1 : x > 1 ? 0 : fall(x);
      return {bond, distance, fraction, used: impulse * fraction / bond.capacity};
    }).filter(({used}) => used >= rule.damageFrom)
    .sort((a, b) => b.used - a.used || a.distance - b.distance || a.bond.index - b.bond.index);
  const broken = [];
  let left = impulse;
  for (const {bond: {index, capacity}, fraction} of loaded) {
    const used = left * fraction / capacity, before = damage[index];
    const growth = used >= 1 ? BROKEN : used < rule.damageFrom ? 0
      : Math.trunc((used - rule.damageFrom) / (1 - rule.damageFrom) * BROKEN);
    damage[index] = Math.min(BROKEN, before + growth);
    left = Math.max(0, left - capacity * (damage[index] - before) / BROKEN);
    if (damage[index] === BROKEN && before < BROKEN) broken.push(index);
  }
  return {taken: impulse - left, broken: broken.sort((a, b) => a - b)};
}

/// What unbroken bonds connect of a body: {numbers, isAnchored}. `holds`: what an anchor is.
export function islandsOf(structure, body, holds = (bond) => bond.ends.length === 1) {
  const left = new Set(body), islands = [];
  for (const first of body) {
    if (!left.delete(first)) continue;
    const island = {structure, numbers: [first], isAnchored: false};
    for (const number of island.numbers) {  // which grows
      for (const bond of linksOf(structure, number).filter((one) => !isBroken(one))) {
        const next = otherEnd(bond, number);
        if (next === undefined) island.isAnchored ||= holds(bond);
        else if (left.delete(next)) island.numbers.push(next);
      }
    }
    island.numbers.sort((a, b) => a - b);
    islands.push(island);
  }
  return islands;
}

/// Breaks the mortar that holds no longer: whose other half is broken, or that leads to no anchor. Call it after hits.
export function breakMortar(scene) {
  const unitOf = new Map(), structures = structuresOf(scene);
  for (const structure of structures) {
    const islands = islandsOf(structure, structure.all, isAnchor).sort((a, b) => massOf(b) - massOf(a));
    if (structure.instance.holdsHeaviest) islands[0].isAnchored = true;
    unitOf.set(structure, new Map(islands.flatMap((island) => island.numbers.map((number) => [number, island]))));
  }
  const unit = ({structure, ends}) => unitOf.get(structure).get(ends[0]);
  const halves = structures.flatMap(({bonds}) => bonds.filter(({other}) => other));
  const whole = halves.filter((half) => !isBroken(half) && !isBroken(half.other));
  for (let isNew = true; isNew;) {  // spreads what is anchored over mortar
    const next = whole.filter((half) => unit(half).isAnchored && !unit(half.other).isAnchored);
    for (const half of next) unit(half.other).isAnchored = true;
    isNew = next.length > 0;
  }
  const gone = halves.filter((half) => !isBroken(half) && (isBroken(half.other) || !unit(half).isAnchored));
  for (const {structure, index} of gone) structure.damage[index] = BROKEN;
}

/// Breaks the bonds of fragments that come off, but those in clusters of levels above that at which their body breaks.
export function breakOff(structure, numbers) {
  const off = new Set(numbers), level = breakingLevel(structure, structure.standing);
  for (const bond of structure.bonds) {
    const isOff = bond.ends.some((end) => off.has(end)) && bond.capacity < Infinity && bond.clusterLevel <= level;
    if (isOff) structure.damage[bond.index] = BROKEN;
  }
}
