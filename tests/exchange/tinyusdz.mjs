// tinyusdz parses the USD files of packs: node tinyusdz.mjs PACKS PLACE [baked]. Compares the physics and the meshes of
// the layer, as it prints it, with the pack. Of baked files, all materials have textures.
import {readFileSync} from "node:fs";
import {join} from "node:path";
import {add, length, sub, tensorOf} from "./geometry.mjs";
import {checkObjects, primOf, usdFilesOf} from "./meshes.mjs";
import {asInBrowser, installed, loaderFrom} from "./packages.mjs";

const kRounding = 1e-6;  // relative: attributes are in single precision

const [packs, place, kind] = process.argv.slice(2);
const {version, folder} = installed(place, "tinyusdz");
const wasm = readFileSync(join(folder, "tinyusdz.wasm"));
const {default: start} = await loaderFrom(place)("tinyusdz");
const {TinyUSDZLoaderNative} = await asInBrowser(() => start(), wasm);

/// A file as a layer, or composed to a scene.
function loaded(path, file, method) {
  const loader = new TinyUSDZLoaderNative();
  if (!loader[method](readFileSync(path), file)) throw new Error(`${file}: ${loader.error()}`);
  return loader;
}

/// The bodies of a layer by the names of their prims: their attributes, lists of numbers, and those of their surfaces.
function bodiesOf(layer) {
  const bodies = new Map();
  let body, prim;
  for (const line of layer.split("\n")) {
    const [, type, name] = /^\s*def (\w+) "(\w+)"/.exec(line) ?? [];
    if (type === "Xform") bodies.set(name, body = {});
    if (type) prim = type === "Xform" ? body : name === "surface" ? body.surface = {} : {};
    const [, key, value] = /^\s*\S+ ([\w:]+) = ([\[(\d.-].*)$/.exec(line) ?? [];
    if (key) prim[key] = value.match(/-?\d[-+.\de]*/g)?.map(Number);
  }
  return new Map([...bodies].filter(([, one]) => one["physics:mass"]));
}

/// The triangles of a surface, as fans of its faces. Those of a concave face have the right sum, with their signs.
function trianglesOf({points, faceVertexCounts, faceVertexIndices}, offset) {
  const corners = faceVertexIndices.map((k) => add(points.slice(3 * k, 3 * k + 3), offset));
  let first = 0;
  return faceVertexCounts.flatMap((count) => {
    const face = corners.slice(first, first += count);
    return face.slice(2).map((corner, k) => [face[0], face[k + 1], corner]);
  });
}

/// Which attributes of a prim are not those of the body.
function differencesOf(prim, body) {
  const [w, x, y, z] = prim["physics:principalAxes"];
  const inertia = tensorOf({moments: prim["physics:diagonalInertia"], rotation: [x, y, z, w]}).flat();
  const largest = Math.max(...body.principal.moments);
  const checks = {
    mass: Math.abs(prim["physics:mass"][0] / body.mass - 1) < kRounding,
    centre: length(prim["physics:centerOfMass"]) === 0,
    inertia: length(sub(inertia, body.inertia.flat())) < kRounding * largest,
    place: length(sub(prim["xformOp:translate"], body.offset)) < 1e-12,
  };
  return Object.keys(checks).filter((key) => !checks[key]);
}

/// Whether the materials, of which a whole shows that of the outside only, have a texture each for colour, normals,
/// roughness and metalness.
function hasTextures(scene, bodies) {
  return [0, 1].slice(0, bodies.length).every((number) => {
    const material = scene.getMaterial(number);
    const textures = ["diffuseColor", "normal", "roughness", "metallic"].map((of) => material[`${of}TextureId`]);
    return textures.every((id) => id !== undefined) && new Set(textures).size === 4;
  });
}

function checkBodies(title, found, bodies) {
  const objects = [...found].map(([name, prim]) => {
    const body = bodies.find((one) => primOf(one.name) === name);
    return {name: body?.name, triangles: body ? trianglesOf(prim.surface, body.offset) : []};
  });
  const faults = [];
  for (const body of bodies) {
    const prim = found.get(primOf(body.name));
    const different = prim ? differencesOf(prim, body) : ["all"];
    if (different.length > 0) faults.push(`${body.name}: ${different.join(", ")}`);
  }
  const count = checkObjects(title, objects, bodies);
  for (const fault of faults) console.log(`  FAULT: ${fault}`);
  return count + faults.length;
}

let faults = 0;
for (const {path, file, bodies} of usdFilesOf(packs)) {
  const layer = loaded(path, file, "loadAsLayerFromBinary").layerToString();
  faults += checkBodies(`tinyusdz ${version}: ${file}`, bodiesOf(layer), bodies);
  // The meshes of its scenes lack faces of more than four corners.
  const expected = bodies.reduce((sum, {hulls}) => sum + 1 + hulls.length, 0);
  const scene = loaded(path, file, "loadFromBinary");
  const count = scene.numMeshes();
  if (count !== expected) console.log(`  FAULT: ${count} meshes of ${expected}`);
  const isBaked = kind !== "baked" || hasTextures(scene, bodies);
  if (!isBaked) console.log("  FAULT: a material without textures");
  faults += Number(count !== expected) + Number(!isBaked);
}
process.exit(faults > 0 ? 1 : 0);
