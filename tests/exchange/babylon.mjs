// The glTF loader of Babylon.js loads the GLB files of packs: node babylon.mjs PACKS PLACE [physics]. It ignores
// their physics.
import {readFileSync} from "node:fs";
import {join, resolve} from "node:path";
import {pathToFileURL} from "node:url";
import {checkObjects, meshesOf} from "./meshes.mjs";
import {installed} from "./packages.mjs";

const [packs, place] = process.argv.slice(2);
const core = installed(place, "@babylonjs/core");
const loaders = installed(place, "@babylonjs/loaders");
const load = ({folder}, file) => import(pathToFileURL(resolve(join(folder, file))).href);
const {NullEngine} = await load(core, "Engines/nullEngine.js");
const {Scene} = await load(core, "scene.js");
const {ImportMeshAsync} = await load(core, "Loading/sceneLoader.js");
const {Vector3} = await load(core, "Maths/math.vector.js");
await load(loaders, "glTF/index.js");

/// The triangles of a mesh in the frame of the file: the scene is left-handed, so x changes its sign, and faces wind the
/// other way round.
function trianglesOf(mesh) {
  const positions = mesh.getVerticesData("position");
  const toScene = mesh.computeWorldMatrix(true);
  const point = (k) => {
    const {x, y, z} = Vector3.TransformCoordinates(Vector3.FromArray(positions, 3 * k), toScene);
    return [-x, y, z];
  };
  const indices = mesh.getIndices();
  const triangles = [];
  for (let k = 0; k < indices.length; k += 3) triangles.push([0, 1, 2].map((i) => point(indices[k + i])));
  return triangles;
}

let faults = 0;
const scene = new Scene(new NullEngine());
for (const {path, name, bodies} of meshesOf(packs)) {
  const url = `data:model/gltf-binary;base64,${readFileSync(path).toString("base64")}`;
  const {meshes} = await ImportMeshAsync(url, scene, {pluginExtension: ".glb"});
  // A mesh of two materials is a node with a child for each.
  const objects = new Map();
  for (const mesh of meshes) {
    if (mesh.getTotalVertices() === 0) continue;
    // With physics, the mesh is a child of the body.
    const owner = mesh.name.replace(/_primitive\d+$/, "").replace(/_mesh$/, "");
    objects.set(owner, [...(objects.get(owner) ?? []), ...trianglesOf(mesh)]);
  }
  const list = [...objects].map(([owner, triangles]) => ({name: owner, triangles}));
  faults += checkObjects(`Babylon.js ${core.version}: ${name}`, list, bodies);
}
process.exit(faults > 0 ? 1 : 0);
