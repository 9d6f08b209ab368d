// The GLTFLoader of three.js loads the GLB files of packs: node three.mjs PACKS PLACE [physics|compact]. With physics,
// the extensions are in userData; compact files have one skinned mesh with a bone for each body.
import {readFileSync} from "node:fs";
import {join, resolve} from "node:path";
import {pathToFileURL} from "node:url";
import {checkObjects, checkPhysics, meshesOf} from "./meshes.mjs";
import {installed} from "./packages.mjs";

const [packs, place, kind] = process.argv.slice(2);
const {version, folder} = installed(place, "three");
const load = (file) => import(pathToFileURL(resolve(join(folder, file))).href);
const {Vector3} = await load("build/three.module.js");
const {GLTFLoader} = await load("examples/jsm/loaders/GLTFLoader.js");

const {MeshoptDecoder} = await load("examples/jsm/libs/meshopt_decoder.module.js");

/// The bodies of compact files: {name, triangles} for each bone that a vertex is bound to.
function bodiesOfBones(scene) {
  const bodies = new Map();
  scene.traverse((mesh) => {
    if (!mesh.isSkinnedMesh) return;
    const {index, attributes} = mesh.geometry;
    const point = (k) => mesh.localToWorld(mesh.getVertexPosition(index.getX(k), new Vector3())).toArray();
    for (let k = 0; k < index.count; k += 3) {
      const {name, userData} = mesh.skeleton.bones[attributes.skinIndex.getX(index.getX(k))];
      const body = userData.name ?? name;
      if (!bodies.has(body)) bodies.set(body, []);
      bodies.get(body).push([point(k), point(k + 1), point(k + 2)]);
    }
  });
  return [...bodies].map(([name, triangles]) => ({name, triangles}));
}

/// The triangles of the meshes below an object, in the frame of the scene.
function trianglesOf(object) {
  const triangles = [];
  object.traverse((mesh) => {
    if (!mesh.isMesh) return;
    const {index, attributes} = mesh.geometry;
    const point = (k) => new Vector3().fromBufferAttribute(attributes.position, index.getX(k))
      .applyMatrix4(mesh.matrixWorld).toArray();
    for (let k = 0; k < index.count; k += 3) triangles.push([point(k), point(k + 1), point(k + 2)]);
  });
  return triangles;
}

let faults = 0;
for (const {path, name, pack, bodies} of meshesOf(packs)) {
  const bytes = readFileSync(path);
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const {scene} = await new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).parseAsync(buffer, "");
  scene.updateMatrixWorld(true);
  if (kind === "compact") {
    // Each coordinate is off by 1 / 65,534 of the largest one at most: 20 um for the whole pane, which is 5 mm thick.
    faults += checkObjects(`three.js ${version}: ${name}`, bodiesOfBones(scene), bodies, {volume: 5e-3, centre: 1e-4, rounding: 1e-4});
    continue;
  }
  // Names lose their periods; the original is in userData.
  const objects = scene.children.map((child) => ({name: child.userData.name ?? child.name, triangles: trianglesOf(child)}));
  faults += checkObjects(`three.js ${version}: ${name}`, objects, bodies);
  if (kind !== "physics") continue;
  const nodes = scene.children.map(({name, userData, children}) =>
    ({name: userData.name ?? name, extensions: userData.gltfExtensions, extras: userData.rubble,
      children: children.map((child) => child.userData.gltfExtensions)}));
  faults += checkPhysics(nodes, bodies, pack);
}
process.exit(faults > 0 ? 1 : 0);
