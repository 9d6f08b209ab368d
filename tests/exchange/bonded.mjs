// The programs of docs/formats that stand bonded scenes in an engine break the same bonds as rubble-cli simulates:
// node bonded.mjs ENGINE EXPORTS CLI PLACE [PROGRAM]. Without PROGRAM, the script of the engine runs in PLACE, beside
// its packages. Exits with 1 where a first break differs, 77 where the engine is not installed.
import {spawnSync} from "node:child_process";
import {copyFileSync, mkdtempSync, readFileSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join, resolve} from "node:path";
import {fileURLToPath} from "node:url";
import {installed} from "./packages.mjs";

const kRate = 240;      // Hz
const kRest = Number(process.env.RUBBLE_REST ?? 1);  // s
const kSame = 0.8;      // of the bonds that break in one of both: what touches first may be another fragment
const kPackages = {rapier: "@dimforge/rapier3d-compat", mujoco: "@mujoco/mujoco"};
/// Throws by demo. Those that land on the ground before, hit several instances at once, or break through several parts
/// within a step break others of the bonds.
const kThrows = {
  "two-storey-house": {"ball at the front wall": true, "block at the pier": false, "ball through the roof": true},
  arcade: {"ball at a spandrel": true},
  dam: {"ball through the middle": true, "block low at the foot": false},
  "joined-house": {"box at the door": true, "block under the roof": false, "ball at the gable": true},
  "rock-face": {"boulder on the overhang": false},
};

const [engine, folder, cli, place, program] = process.argv.slice(2);
const fileOf = (path) => fileURLToPath(new URL(`../../${path}`, import.meta.url));
let command = [program];
if (!program) {
  installed(place, kPackages[engine]);
  const copies = mkdtempSync(join(resolve(place), "bonded-"));  // modules are looked for from the folder of a script
  process.on("exit", () => rmSync(copies, {recursive: true}));
  for (const file of ["bonds.mjs", "bonded_play.mjs", `${engine}_scene_example.mjs`])
    copyFileSync(fileOf(`docs/formats/${file}`), join(copies, file));
  command = [process.execPath, join(copies, `${engine}_scene_example.mjs`)];
}

const files = mkdtempSync(join(tmpdir(), "bonded-"));
process.on("exit", () => rmSync(files, {recursive: true}));
const linesOf = (text) => text.trim().split("\n").map((line) => JSON.parse(line));
function playHere(demo, shot, seconds) {
  const [name, ...rest] = [...command, join(folder, demo), shot, String(seconds)];
  const {status, stdout, stderr} = spawnSync(name, rest, {encoding: "utf8"});
  if (status !== 0) throw new Error(stderr);
  return linesOf(stdout);
}

/// The first bonds that a throw breaks in the editor, by instance.
function firstInEditor(demo, shot) {
  const file = join(files, "events.jsonl");
  const played = spawnSync(cli, ["simulate", fileOf(`projects/${demo}.rubble`), "--quiet", "--dt", String(1 / kRate),
                                 "--steps", "300", "--shot", shot, "--events", file], {encoding: "utf8"});
  if (played.status !== 0) throw new Error(played.stderr);
  const events = linesOf(readFileSync(file, "utf8"));
  const first = events.find(({kind, impulse}) => kind === "bonds" && impulse > 0);
  const inStep = (name) => events.filter(({kind, step}) => kind === name && step === first.step);
  const broken = new Map(inStep("damaged").map(({instance, broken: bonds}) => [instance, bonds]));
  return {time: first.step / kRate, broken, islands: inStep("detached").filter(({fixed}) => !fixed).map(({fragments}) => fragments)};
}

function expect(is, what) {
  console.log(`${is ? "  " : "  FAULT: "}${what}`);
  if (!is) process.exitCode = 1;
}
/// Islands as paths of fragments, in any order.
function islandsHere(demo, {instance, islands}) {
  const read = (file) => JSON.parse(readFileSync(join(folder, demo, file), "utf8"));
  const {fragments} = read(`${read("scene.json").instances.find(({id}) => id === instance).pack}/pack.json`);
  return islands.map((island) => island.map((fragment) => fragments[fragment].id.split("/").slice(1).join("/")));
}
const sorted = (islands) => JSON.stringify(islands.map((island) => [...island].sort()).sort());
for (const [demo, throws] of Object.entries(kThrows)) {
  console.log(`${engine}, ${demo}`);
  expect(playHere(demo, "", kRest).at(-1).free === 0, "nothing comes off by itself");
  for (const [shot, isDirect] of Object.entries(throws)) {
    const editor = firstInEditor(demo, shot), [here] = playHere(demo, shot, editor.time + 0.05);
    const bonds = new Set(editor.broken.get(here.instance) ?? []);
    const both = here.broken.filter((bond) => bonds.has(bond)).length;
    const same = both / (bonds.size + here.broken.length - both), late = Math.abs(here.time - editor.time) * kRate;
    if (same === 1)
      expect(sorted(islandsHere(demo, here)) === sorted(editor.islands), `${shot}: the same islands come off`);
    expect(late < (isDirect ? 1.5 : 3.5) && bonds.size > 0 && (!isDirect || same >= kSame),
           `${shot}: at ${here.time.toFixed(4)} s, in the editor ${editor.time.toFixed(4)}; ${here.broken.length} bonds, ` +
           `of ${bonds.size} in the editor ${both}`);
  }
}
