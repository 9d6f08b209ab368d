// The example programs of docs/formats break a wall in an engine, at the impulse that pack.md defines:
// node examples.mjs bullet PACKS PROGRAM, or node examples.mjs rapier PACKS PLACE SCRIPT.
import {spawnSync} from "node:child_process";
import {copyFileSync, rmSync} from "node:fs";
import {basename, join, resolve} from "node:path";
import {installed} from "./packages.mjs";
import {readPack} from "./pack.mjs";

const kBall = 100;  // kg, thrown at the centre of mass, so that nothing rotates

const [engine, packs, place, script] = process.argv.slice(2);
let command = [place];
if (engine === "rapier") {
  installed(place, "@dimforge/rapier3d-compat");
  // Modules are looked for from the folder of a script.
  const copy = join(resolve(place), `test-${process.pid}-${basename(script)}`);
  copyFileSync(script, copy);
  process.on("exit", () => rmSync(copy));
  command = [process.execPath, copy];
}

const file = join(packs, "wall", "pack.json");
const pack = readPack(file);
const impulseAt = (speed) => speed / (1 / kBall + 1 / pack.whole.mass);
const slow = 0.9 * pack.threshold / impulseAt(1);
const fast = 1.2 * pack.threshold / impulseAt(1);

function run(speed) {
  const {status, stdout, stderr} = spawnSync(command[0], [...command.slice(1), file, String(speed)], {encoding: "utf8"});
  if (status !== 0) throw new Error(stderr);
  return stdout;
}
function expect(is, what) {
  console.log(`${is ? "" : "FAULT: "}${what}`);
  if (!is) process.exitCode = 1;
}

expect(run(slow) === "", `at ${slow.toFixed(2)} m/s it stands`);
const [first, ...moved] = run(fast).trim().split("\n");
const impulse = Number(/^broke at (\S+) N·s/.exec(first)?.[1]);
expect(Math.abs(impulse / impulseAt(fast) - 1) < 0.01,
       `at ${fast.toFixed(2)} m/s it breaks at ${impulse} N·s, of ${impulseAt(fast).toFixed(1)}`);
const count = pack.whole.children.length;
expect(moved.length === count && moved.every((line) => parseFloat(line) > 0 && parseFloat(line) < 0.2),
       `and ${moved.length} of ${count} fragments move, less than 0.2 m`);
