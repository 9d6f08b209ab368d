// Stands the instances of a scene.json in an engine, as wholes, for 5 s: node scene.mjs ENGINE PACKS PLACE. Exits with 1
// if one moves further than its joints can close, 77 where the engine is not installed.
import {readFileSync} from "node:fs";
import {join} from "node:path";
import {add, length, product, rotated, sub} from "./geometry.mjs";
import {installed, loaderFrom} from "./packages.mjs";
import {readPack} from "./pack.mjs";

const kStep = 1 / 60;  // s
const kSteps = 300;

const [engineName, packs, place] = process.argv.slice(2);
const adapter = await import(`./engines/${engineName}.mjs`);
const {version, folder} = installed(place, adapter.packageName);
const engine = await adapter.start(loaderFrom(place), folder);

const scene = JSON.parse(readFileSync(join(packs, "scene.json"), "utf8"));
if (scene.format !== "rubble-scene" || scene.version !== 1) throw new Error("no scene of version 1");
const packOf = new Map(scene.packs.map((pack) => [pack.folder, readPack(join(packs, pack.folder, "pack.json"))]));
const bodies = scene.instances.map((instance) => {
  const {whole} = packOf.get(instance.pack);
  return {...whole, name: instance.name, rotation: instance.rotation,
          position: add(instance.position, rotated(instance.rotation, whole.offset)),
          principalPose: product(instance.rotation, whole.principal.rotation)};
});

const world = engine.world(scene.gravity, kStep, adapter.settings.at(-1));
world.addFloor(scene.ground.height, scene.ground.friction);
const added = bodies.map((body) => world.add(body));
world.finish?.();
for (let step = 0; step < kSteps; ++step) world.step();
const moved = added.map((body, k) => length(sub(body.position(), bodies[k].position)));
const most = Math.max(...moved);
const first = bodies[moved.indexOf(most)].name;
// Six layers of stones, each of which may sink by the gaps of two insets, and roofs that slide down their slope by them.
const limit = 0.01;
console.log(`${adapter.program} ${engine.version ?? version}: ${bodies.length} instances stand for 5 s, and move by at ` +
            `most ${(most * 1000).toFixed(2)} mm (${first})`);
if (!(most < limit)) {
  console.log(`  FAULT: ${limit * 1000} mm is the most`);
  process.exitCode = 1;
}
