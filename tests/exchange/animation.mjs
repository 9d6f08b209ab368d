// gltf-validator and three.js read the animations of a simulation, GLB and USD, and have every body where it was:
// node animation.mjs CLI PROJECT PACKS PLACE. PACKS are those of the project.
import {execFileSync} from "node:child_process";
import {existsSync, mkdtempSync, readFileSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join, resolve} from "node:path";
import {pathToFileURL} from "node:url";
import {add, length, rotated, sub} from "./geometry.mjs";
import {readPack} from "./pack.mjs";
import {installed, loaderFrom, skip} from "./packages.mjs";

const kStep = 1 / 60;  // s
const kSteps = 120;
const kTolerance = 2e-4;  // m: that of what is written, and of single precision
const kShot = "box at the door";

const [cli, project, packs, place] = process.argv.slice(2);
const {version, folder} = installed(place, "three");
const load = (file) => import(pathToFileURL(resolve(join(folder, file))).href);
const usdLoader = "examples/jsm/loaders/USDLoader.js";
if (!existsSync(join(folder, usdLoader))) skip(`three ${version} has no USDLoader`);
const {AnimationMixer, LoopOnce, Quaternion, Vector3} = await load("build/three.module.js");
const {GLTFLoader} = await load("examples/jsm/loaders/GLTFLoader.js");
const {USDLoader} = await load(usdLoader);

const work = mkdtempSync(join(tmpdir(), "rubble-animation-"));
process.on("exit", () => rmSync(work, {recursive: true}));
const simulate = (steps, ...options) => JSON.parse(execFileSync(
  cli, ["simulate", project, "--steps", String(steps), "--shot", kShot, ...options], {encoding: "utf8"}));

const scene = JSON.parse(readFileSync(join(packs, "scene.json"), "utf8"));
const packOf = new Map(scene.instances.map(({name, pack}) => [name, readPack(join(packs, pack, "pack.json"))]));
const identifier = (name) => name.replace(/[-. ]/gu, "_");

/// The node of a body, and where the origin of its mesh is in its frame.
function nodeOf(name) {
  const [instance, fragment] = name.split("/");
  const pack = packOf.get(instance);
  if (!pack) return {node: `${identifier(instance)}_thrown`, origin: [0, 0, 0]};  // a projectile
  if (fragment) return {node: `${identifier(instance)}_f${identifier(fragment)}`, origin: [0, 0, 0]};
  return {node: `${identifier(instance)}_whole`, origin: pack.whole.offset};
}

let faults = 0;
function check(is, what) {
  console.log(`${is ? "" : "FAULT: "}${what}`);
  if (!is) ++faults;
}

/// Compares the nodes of an animation with the bodies of the simulation, after some of its steps. Of the nodes with
/// `names`, those are hidden whose scale is 0.
function compare(name, root, clip, names = []) {
  const nodes = new Map();
  root.traverse((object) => nodes.set(object.userData.name ?? object.name, object));
  const mixer = new AnimationMixer(root);
  const action = mixer.clipAction(clip).setLoop(LoopOnce);  // the last frame is not the first
  action.clampWhenFinished = true;
  action.play();
  let largest = 0;
  let compared = 0;
  let shown = 0;
  for (const step of [0, 1, 30, 36, 40, 50, 62, 90, kSteps]) {
    mixer.setTime(Math.fround(step * kStep));
    root.updateMatrixWorld(true);
    const {bodies} = simulate(step);
    for (const {name: body, position, orientation: [w, x, y, z]} of bodies) {
      const {node, origin} = nodeOf(body);
      const object = nodes.get(node);
      if (!object) throw new Error(`${name} has no node ${node}`);
      const at = [new Vector3(), new Quaternion(), new Vector3()];
      object.matrixWorld.decompose(...at);
      if (names.length > 0 && Math.abs(at[2].x - 1) > 1e-5) throw new Error(`${node} is hidden in step ${step}`);
      const rotation = [x, y, z, w];
      for (const corner of [[0, 0, 0], [1, 0, 0], [0, 1, 0]]) {
        const then = add(position, rotated(rotation, add(origin, corner)));
        const now = add(at[0].toArray(), rotated(at[1].toArray(), corner));
        largest = Math.max(largest, length(sub(then, now)));
      }
      ++compared;
    }
    shown += names.filter((node) => nodes.get(node).scale.x > 0).length;
  }
  check(largest < kTolerance, `${name}: ${compared} poses, of which the farthest is off by ${(largest * 1e3).toFixed(3)} mm`);
  return {compared, shown};
}

const glb = join(work, "hit.glb");
const {bodies, breaks} = simulate(kSteps, "--animation", glb);
check(breaks.length > 0, `${breaks.length} bodies break, and ${bodies.length} are there at the end`);
const {default: validator} = await loaderFrom(place)("gltf-validator");
const {issues} = await validator.validateBytes(new Uint8Array(readFileSync(glb)));
for (const {severity, code, message} of issues.messages) if (severity < 2) console.log(`  ${code}: ${message}`);
check(issues.numErrors + issues.numWarnings === 0, `gltf-validator: ${issues.numErrors} errors, ${issues.numWarnings} warnings`);

const bytes = readFileSync(glb);
const gltf = await new GLTFLoader().parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength), "");
const {compared, shown} = compare(`three.js ${version}, GLB`, gltf.scene, gltf.animations[0],
                                  gltf.parser.json.nodes.map((node) => node.name));
check(compared === shown, `${shown} nodes are shown, ${compared} bodies are there`);

const usda = join(work, "hit.usda");
simulate(kSteps, "--animation", usda);
const usd = new USDLoader().parse(readFileSync(usda, "utf8"));
compare(`three.js ${version}, USD`, usd, usd.animations[0]);
process.exit(faults > 0 ? 1 : 0);
