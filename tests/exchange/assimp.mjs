// assimp reads the GLB and OBJ files of packs: node assimp.mjs PACKS PROGRAM, which is programs/Assimp.cpp.
import {spawnSync} from "node:child_process";
import {checkObjects, meshesOf} from "./meshes.mjs";

const [packs, program] = process.argv.slice(2);
let faults = 0;
for (const ending of [".glb", ".obj"]) {
  for (const {path, name, bodies} of meshesOf(packs, ending)) {
    const {status, stdout, stderr} = spawnSync(program, [path], {maxBuffer: 1 << 28});
    if (status !== 0) throw new Error(`${name}: ${stderr}`);
    faults += checkObjects(`assimp: ${name}`, JSON.parse(stdout), bodies);
  }
}
process.exit(faults > 0 ? 1 : 0);
