// The USDLoader of three.js loads the USD files of packs: node usd.mjs PACKS PLACE. It has no physics.
import {existsSync, readFileSync, readdirSync} from "node:fs";
import {join, resolve} from "node:path";
import {pathToFileURL} from "node:url";
import {checkObjects} from "./meshes.mjs";
import {leaves, readPack} from "./pack.mjs";
import {installed, skip} from "./packages.mjs";

const [packs, place] = process.argv.slice(2);
const {version, folder} = installed(place, "three");
const load = (file) => import(pathToFileURL(resolve(join(folder, file))).href);
const loader = "examples/jsm/loaders/USDLoader.js";
if (!existsSync(join(folder, loader))) skip(`three ${version} has no USDLoader`);
const {Vector3} = await load("build/three.module.js");
const {USDLoader} = await load(loader);

/// The triangles of the surface of a body, in the frame of the scene.
function trianglesOf(object) {
  const triangles = [];
  object.traverse((mesh) => {
    if (!mesh.isMesh || mesh.name !== "surface") return;
    const {index, attributes} = mesh.geometry;
    const at = (k) => (index ? index.getX(k) : k);
    const point = (k) => new Vector3().fromBufferAttribute(attributes.position, at(k))
      .applyMatrix4(mesh.matrixWorld).toArray();
    const count = index ? index.count : attributes.position.count;
    for (let k = 0; k < count; k += 3) triangles.push([point(k), point(k + 1), point(k + 2)]);
  });
  return triangles;
}

/// The name of a prim, in which each character that is no letter or digit of ASCII is '_'.
const primOf = (name) => name.replace(/[^A-Za-z0-9]/gu, "_");

/// The objects of a file that are bodies, by the pack's names.
function objectsOf(scene, bodies) {
  scene.updateMatrixWorld(true);
  const objects = [];
  scene.traverse((object) => {
    const body = bodies.find(({name}) => primOf(name) === object.name);
    if (body) objects.push({name: body.name, triangles: trianglesOf(object)});
  });
  return objects;
}

let faults = 0;
let files = 0;
const folders = readdirSync(packs, {withFileTypes: true}).filter((entry) => entry.isDirectory());
for (const name of folders.map((entry) => entry.name).sort()) {
  const pack = readPack(join(packs, name, "pack.json"));
  for (const [file, bodies] of [[`${name}.usda`, leaves(pack)], [`${name}-intact.usda`, [pack.whole]]]) {
    const path = join(packs, name, file);
    if (!existsSync(path)) continue;
    ++files;
    const scene = new USDLoader().parse(readFileSync(path, "utf8"));
    faults += checkObjects(`three.js ${version}: ${file}`, objectsOf(scene, bodies), bodies);
  }
}
if (files === 0) throw new Error(`there is no file in ${packs}`);
process.exit(faults > 0 ? 1 : 0);
