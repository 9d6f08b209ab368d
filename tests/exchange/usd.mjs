// The USDLoader of three.js loads the USD files of packs: node usd.mjs PACKS PLACE. It has no physics.
import {existsSync, readFileSync} from "node:fs";
import {join, resolve} from "node:path";
import {pathToFileURL} from "node:url";
import {checkObjects, primOf, usdFilesOf} from "./meshes.mjs";
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
for (const {path, file, bodies} of usdFilesOf(packs)) {
  const scene = new USDLoader().parse(readFileSync(path, "utf8"));
  faults += checkObjects(`three.js ${version}: ${file}`, objectsOf(scene, bodies), bodies);
}
process.exit(faults > 0 ? 1 : 0);
