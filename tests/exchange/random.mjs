// Random assets through every writer, and into every reader of meshes that is installed:
// node random.mjs RUBBLE_CLI PLACE ASSIMP COUNT [SEED]. Each is exported twice, on one thread and on three: the bytes are
// the same. `rubble-cli check` finds nothing in the packs.
import {execFileSync, spawnSync} from "node:child_process";
import {mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";

const [cli, place, assimp, count, seed = "1"] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const kInProject = 25;  // assets

/// A generator of numbers in [0, 1): the same on every machine (mulberry32).
function randomOf(state) {
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
const random = randomOf(Number(seed));
const between = (low, high) => low + (high - low) * random();
const whole = (low, high) => Math.floor(between(low, high + 1));
const oneOf = (list) => list[whole(0, list.length - 1)];
const isChance = (part) => random() < part;

/// A star-shaped ring around a point, counter-clockwise.
function ring(x, y, radius, corners) {
  const angles = Array.from({length: corners}, (_, k) => (2 * Math.PI * (k + 0.6 * random())) / corners);
  return angles.map((angle) => {
    const r = radius * between(0.6, 1);
    return [x + r * Math.cos(angle), y + r * Math.sin(angle)];
  });
}

let nextId = 10;
const id = () => nextId++;
const scatter = (most) => ({id: id(), on: true, randomSeed: whole(0, 1000), kind: "uniform", overrides: [],
  parameters: {count: whole(1, most), domain: "outline"}});
const lloyd = () => ({id: id(), on: true, randomSeed: 0, kind: "lloyd", parameters: {rounds: whole(1, 3)}, overrides: []});

function asset(number, materials) {
  const size = 10 ** between(-1.5, 0.3);
  const [x, y] = isChance(0.3) ? [between(-size, size), between(-size, size)] : [0, 0];
  const corners = whole(3, 12);
  const holes = corners > 5 && isChance(0.5) ? [ring(x, y, 0.15 * size, whole(3, 6)).reverse()] : [];
  return {
    id: id(),
    name: oneOf(["wall", "old wall", "Wand Ω", "floor.2", "front_wheel", "a-b"]) + " " + number,
    material: oneOf(materials).id,
    threshold: between(10, 1e4),
    contactTime: null,
    insideUvScale: between(0.1, 4),
    insideMaterial: isChance(0.3) ? oneOf(materials).id : null,
    prism: {depth: size * between(0.05, 1), outline: ring(x, y, size, corners), holes},
    pattern: isChance(0.5) ? [scatter(30)] : [scatter(30), lloyd()],
    shaping: {
      smallPieces: {rule: oneOf(["keep", "merge"]), measure: "partOfMean", limit: 0.2},
      gap: isChance(0.3) ? size * between(0, 0.005) : 0,
      roughness: {amplitude: 0, frequency: between(1, 5) / size, octaves: 2, randomSeed: 3},
    },
    levels: isChance(0.3) ? [{pattern: [scatter(4)], minimumVolume: 0}] : [],
    leaves: [],
    edits: [],
    cutAtImpact: null,
    intents: [],
    surface: null,
  };
}

function project(first, assets) {
  const colour = () => [random(), random(), random()];
  const materials = ["stone", "glass"].map((name) => ({id: id(), name, density: between(500, 8000), friction: between(0, 1),
    restitution: between(0, 1), tensileStrength: 1e6, fractureToughness: 150000, youngsModulus: 4e9, outside: colour(),
    inside: colour(), opacity: name === "glass" ? 0.5 : 1}));
  const list = Array.from({length: assets}, (_, k) => asset(first + k, materials));
  return {format: "rubble-project", version: 5, nextId: nextId + 1, materials, assets: list, instances: [],
    ground: {on: true, height: 0, friction: 0.6, restitution: 0}, gravity: [0, -9.81, 0],
    damage: {rule: "impact", thesis: false, thesisThreshold: 1000}, debris: {lifetime: null, fade: 1, mostPieces: null},
    shots: [], playTests: []};
}

function filesIn(folder) {
  return readdirSync(folder, {recursive: true, withFileTypes: true}).filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name)).sort();
}

const folder = mkdtempSync(join(tmpdir(), "rubble-random-"));
const kinds = {
  plain: ["--format", "both"],
  physics: ["--glb", "physics", "--format", "glb", "--usd", "--mjcf"],
  compact: ["--glb", "compact", "--format", "glb"],
  named: ["--glb", "ucx", "--format", "glb"],
};
const readers = {
  plain: [["assimp.mjs", assimp]],
  physics: [["three.mjs", place, "physics"], ["validator.mjs", place, "physics"], ["usd.mjs", place], ["mjcf.mjs", place]],
  compact: [["three.mjs", place, "compact"], ["validator.mjs", place, "compact"]],
  named: [["validator.mjs", place]],
};
let faults = 0;
function fail(text) {
  console.log(`FAULT: ${text}`);
  ++faults;
}

console.log(`seed ${seed}`);
for (let first = 0; first < Number(count); first += kInProject) {
  const file = join(folder, "project.rubble");
  writeFileSync(file, JSON.stringify(project(first, Math.min(kInProject, Number(count) - first))));
  for (const [kind, options] of Object.entries(kinds)) {
    const [one, three] = ["1", "3"].map((threads) => {
      const out = join(folder, `${kind}-${threads}`);
      execFileSync(cli, ["export", file, "--out", out, "--threads", threads, "-q", ...options]);
      return out;
    });
    const files = filesIn(one);
    const others = filesIn(three);
    if (files.length !== others.length) fail(`${kind}: ${files.length} files, and ${others.length} on three threads`);
    files.forEach((path, k) => {
      if (!readFileSync(path).equals(readFileSync(others[k]))) fail(`${kind}: ${path} differs from ${others[k]}`);
    });
    const check = spawnSync(cli, ["check", one, "-q"], {encoding: "utf8"});
    if (check.status !== 0) fail(`check of ${kind}: ${check.stdout}${check.stderr}`);
    for (const [script, ...args] of readers[kind]) {
      const {status, stdout, stderr} = spawnSync(process.execPath, [join(here, script), one, ...args],
        {encoding: "utf8", maxBuffer: 1 << 28});
      if (status === 77) continue;
      if (status !== 0) fail(`${script} ${kind} from asset ${first} on:\n${stdout}${stderr}`);
    }
    rmSync(one, {recursive: true});
    rmSync(three, {recursive: true});
  }
  console.log(`${Math.min(first + kInProject, Number(count))} assets`);
}
if (faults === 0) rmSync(folder, {recursive: true});
process.exit(faults > 0 ? 1 : 0);
