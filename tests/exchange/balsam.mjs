// Qt Quick 3D converts the GLB files of packs, and PhysX 4 of Qt Quick 3D Physics cooks convex meshes of the fragments:
// node balsam.mjs PACKS BALSAM COOKER.
import {spawnSync} from "node:child_process";
import {mkdtempSync, readdirSync, readFileSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {length, sub} from "./geometry.mjs";
import {meshesOf} from "./meshes.mjs";

const [packs, balsam, cooker] = process.argv.slice(2);
const environment = {...process.env, QT_QPA_PLATFORM: "offscreen"};

/// The places of the models of a converted scene, by the names of their meshes.
function modelsOf(text) {
  const models = new Map();
  for (const [, body] of text.matchAll(/Model \{([^{}]*)\}/g)) {
    const at = ["x", "y", "z"].map((axis) => Number(new RegExp(`^\\s*${axis}: (\\S+)`, "m").exec(body)?.[1] ?? 0));
    models.set(/meshes\/(\w+)\.mesh/.exec(body)[1], at);
  }
  return models;
}

/// How far places are from offsets, m; names have _ for - and .
function placeError(models, bodies) {
  return Math.max(...bodies.map(({name, offset}) => {
    const at = models.get(name.replace(/[-.+]/g, "_"));
    return at ? length(sub(at, offset)) : Infinity;
  }));
}

function faultsOf({path, name, bodies}) {
  const folder = mkdtempSync(join(tmpdir(), "rubble-balsam-"));
  try {
    const converted = spawnSync(balsam, ["-o", folder, path], {env: environment});
    if (converted.status !== 0) throw new Error(String(converted.stderr));
    const scene = readdirSync(folder).find((file) => file.endsWith(".qml"));
    const error = placeError(modelsOf(readFileSync(join(folder, scene), "utf8")), bodies);
    const meshes = join(folder, "meshes");
    const cooked = readdirSync(meshes).filter((mesh) => {
      spawnSync(cooker, [mesh], {cwd: meshes, env: environment});
      return readdirSync(meshes).includes(mesh.replace(/\.mesh$/, ".cooked.cvx"));
    });
    console.log(`balsam and cooker: ${name}: cooked ${cooked.length} of ${bodies.length}, places ${error.toExponential(1)}`);
    return cooked.length === bodies.length && error < 1e-5 ? 0 : 1;
  } finally {
    rmSync(folder, {recursive: true});
  }
}

const faults = meshesOf(packs).reduce((sum, file) => sum + faultsOf(file), 0);
process.exit(faults > 0 ? 1 : 0);
