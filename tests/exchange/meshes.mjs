// The mesh files of packs, and whether what an importer has of one is what the pack says.
import {existsSync, readdirSync} from "node:fs";
import {join} from "node:path";
import {add, length, scaled, sub} from "./geometry.mjs";
import {leaves, readPack} from "./pack.mjs";

/// The mesh files of all packs with an ending: {path, name, pack, bodies}, with the bodies that a file holds.
export function meshesOf(packs, ending = ".glb") {
  const files = [];
  const folders = readdirSync(packs, {withFileTypes: true}).filter((entry) => entry.isDirectory());
  for (const folder of folders.map(({name}) => name).sort()) {
    const pack = readPack(join(packs, folder, "pack.json"));
    for (const {file, bodies} of pack.meshes) {
      if (!file.endsWith(ending)) continue;
      files.push({path: join(packs, folder, file), name: file, pack, bodies: bodiesOf(pack, file, bodies)});
    }
  }
  return files;
}

/// The USD files of all packs: {path, file, bodies}.
export function usdFilesOf(packs) {
  const files = [];
  const folders = readdirSync(packs, {withFileTypes: true}).filter((entry) => entry.isDirectory());
  for (const folder of folders.map(({name}) => name).sort()) {
    const pack = readPack(join(packs, folder, "pack.json"));
    for (const [file, bodies] of [[`${folder}.usda`, leaves(pack)], [`${folder}-intact.usda`, [pack.whole]]]) {
      const path = join(packs, folder, file);
      if (existsSync(path)) files.push({path, file, bodies});
    }
  }
  if (files.length === 0) throw new Error(`there is no file in ${packs}`);
  return files;
}
/// The name of a prim, in which each character that is no letter or digit of ASCII is '_'.
export const primOf = (name) => name.replace(/[^A-Za-z0-9]/gu, "_");

function bodiesOf(pack, file, bodies) {
  if (bodies === "whole") return [pack.whole];
  const {level} = pack.meshes.find((mesh) => mesh.file === file);
  return pack.fragments.filter(({children, level: own}) =>
    (level === null ? children.length === 0 : children.length > 0 && own === level));
}

/// The volume, m^3, and centroid of a closed mesh: a list of triangles of three points each.
export function solidOfTriangles(triangles) {
  let volume = 0;
  let centroid = [0, 0, 0];
  for (const [a, b, c] of triangles) {
    const part = (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                  a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
    volume += part;
    centroid = add(centroid, scaled(add(a, add(b, c)), part / 4));
  }
  return {volume, centroid: scaled(centroid, 1 / volume)};
}

/// Compares objects {name, triangles in the asset's frame} with the bodies of a file; returns the number of faults.
/// `errors`: parts of a volume, and m, by which they may be off. The rounding of positions, as a part of the
/// farthest one, changes the volume of a small or thin body by more: by that ÷ its size.
export function checkObjects(title, objects, bodies, errors = {volume: 5e-6, centre: 1e-6, rounding: 1e-6}) {
  let volumeError = 0;
  let centreError = 0;
  const different = [];
  const missing = bodies.filter(({name}) => !objects.some((object) => object.name === name)).map(({name}) => name);
  for (const {name, triangles} of objects) {
    const body = bodies.find((one) => one.name === name);
    if (!body) continue;
    const {volume, centroid} = solidOfTriangles(triangles.map((triangle) => triangle.map((p) => sub(p, body.offset))));
    const error = Math.abs(volume / body.volume - 1);
    const farthest = Math.max(...triangles.flat().map(length));
    if (!(error < errors.volume + errors.rounding * farthest / Math.cbrt(body.volume))) different.push(name);
    volumeError = Math.max(volumeError, error);
    centreError = Math.max(centreError, length(centroid));
  }
  console.log(`${title}: objects ${objects.length}, volume ${volumeError.toExponential(1)}, ` +
    `centre ${centreError.toExponential(1)}`);
  const faults = [];
  if (missing.length > 0) faults.push(`${missing.join(", ")} missing`);
  if (objects.length !== bodies.length) faults.push(`${bodies.length} bodies expected`);
  if (different.length > 0) faults.push(`volumes differ: ${different.join(", ")}`);
  if (!(centreError < errors.centre)) faults.push("centres differ");
  for (const fault of faults) console.log(`  FAULT: ${fault}`);
  return faults.length;
}

/// Compares the physics of nodes {name, extensions, extras, children: their extensions} with the bodies of a file;
/// returns the number of faults.
export function checkPhysics(nodes, bodies, pack) {
  const faults = [];
  for (const body of bodies) {
    const {extensions, extras, children} = nodes.find(({name}) => name === body.name) ?? {};
    const bodyFaults = extensions ? faultsOfPhysics(extensions, extras, children, body, pack) : ["no physics"];
    faults.push(...bodyFaults.map((fault) => `${body.name}: ${fault}`));
  }
  for (const fault of faults) console.log(`  FAULT: ${fault}`);
  return faults.length;
}

function faultsOfPhysics(extensions, extras, children, body, pack) {
  const {mass, inertiaDiagonal, inertiaOrientation} = extensions.KHR_physics_rigid_bodies.motion;
  const {mass: omiMass, type} = extensions.OMI_physics_body.motion;
  const isSame = (a, b) => a.every((value, k) => value === b[k]);
  const parent = body === pack.whole ? null : body.parent === null ? pack.whole.id : pack.fragments[body.parent].id;
  const colliders = children.filter((child) => child?.KHR_physics_rigid_bodies?.collider.geometry.convexHull);
  const shapes = children.filter((child) => child?.OMI_physics_body?.collider);
  const checks = {
    mass: mass === body.mass && omiMass === body.mass && type === "dynamic",
    inertia: isSame(inertiaDiagonal, body.principal.moments) && isSame(inertiaOrientation, body.principal.rotation),
    extras: extras.id === body.id && extras.parent === parent && extras.level === body.level,
    threshold: extras.threshold === (body === pack.whole ? pack.threshold : body.threshold ?? undefined),
    colliders: colliders.length === body.hulls.length && shapes.length === body.hulls.length,
  };
  return Object.keys(checks).filter((key) => !checks[key]);
}
