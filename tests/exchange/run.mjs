// Loads packs into an engine and checks what it has and does: node run.mjs ENGINE PACKS PLACE. Prints a row for each
// pack, and before it for the same with hulls that touch, in PACKS-touching; checks the former. Exits with 0, 1 where a figure is
// beyond its limit, 77 where the engine is not installed.
import {join} from "node:path";
import {fragmentsOfWhole, leaves, readPack} from "./pack.mjs";
import {measure, rowOf} from "./conformance.mjs";
import {installed, loaderFrom} from "./packages.mjs";

/// Packs by folder; which of their fragments; whether they lie on the floor; and how far they may settle, m, where that
/// is more than for others: in high stacks the gaps of many fragments close, one after the other.
const kCases = [
  {asset: "roof", of: "whole"},
  {asset: "wall", of: "whole"},
  {asset: "pane", of: "whole", lies: true},
  {asset: "terraces", of: "whole", standing: 5e-3},
  {asset: "two_levels", of: "leaves", standing: 5e-3},
];
/// Errors as in errorsOf(); m/s; m. Engines count in single precision.
const kLimits = {mass: 1e-6, centre: 1e-6, inertia: 1e-5, volume: 1e-5, friction: 1e-6, pose: 1e-6, swap: 1e-3,
                 standing: 2e-3, drift: 2e-4};

const [engineName, packs, place, extent] = process.argv.slice(2);
if (!place) {
  console.error("usage: node run.mjs ENGINE PACKS PLACE [long]; PLACE: the folder with node_modules, or the program");
  process.exit(2);
}
const adapter = await import(`./engines/${engineName}.mjs`);

const rounded = (value) => (value === undefined ? "–" : value === 0 ? "0" : value.toExponential(1));
const inMillimetres = (value) => (value * 1000).toFixed(value < 1e-2 ? 2 : 0);
function print(row) {
  const widths = [14, 10, 11, 6, 6, 8, 8, 8, 8, 8, 8, 10, 9];
  console.log(row.map((cell, k) => String(cell).padEnd(widths[k] ?? 0)).join(" ").trimEnd());
}

let faults = 0;
/// Says what is beyond its limit.
function check({asset, standing}, {looser = {}}, row) {
  const {swap, drift} = row;
  for (const [what, is] of Object.entries({...row.errors, swap, standing: row.standing, drift})) {
    const usual = (what === "standing" && standing) || kLimits[what];
    const [limit, reason] = looser[`${asset} ${what}`] ?? looser[what] ?? [usual];
    if (is > usual && is <= limit) console.log(`  ${what} ${is.toExponential(1)}: ${reason}`);
    if (is === undefined || is <= limit) continue;
    ++faults;
    console.log(`  FAULT: ${what} is ${is.toExponential(1)}, and ${limit} is the most`);
  }
}

/// What an engine does with fragments of a pack; nothing where it aborts, which is a fault where hulls do not touch.
function rowFor(engine, setting, one, pack, fragments) {
  if (!engine.report) return measure(engine, setting, fragments, one.lies);
  const report = engine.report(pack, one, setting);
  if (report) return rowOf(report, fragments, one.lies);
  print([adapter.program, engine.version, one.asset, pack.inset > 0 ? "inset" : "touch", "aborts"]);
  if (pack.inset > 0) ++faults;
}

/// Measures an asset with hulls that touch, and as it is exported.
function measureAsset(engine, version, setting, one) {
  for (const folder of [`${packs}-touching`, packs]) {
    const form = readPack(join(folder, one.asset, "pack.json"));
    const fragments = (one.of === "leaves" ? leaves : fragmentsOfWhole)(form);
    const row = rowFor(engine, setting, one, form, fragments);
    if (!row) continue;
    print([adapter.program, version, one.asset, form.inset > 0 ? "inset" : "touch", row.count,
           ...["mass", "centre", "inertia", "volume", "friction", "pose"].map((key) => rounded(row.errors[key])),
           ...[row.swap, row.standing, row.drift].map(inMillimetres)]);
    if (row.count !== fragments.length) throw new Error(`${row.count} bodies of ${fragments.length}`);
    if (form.inset > 0) check(one, setting, row);
  }
}

const {version, folder} = adapter.packageName ? installed(place, adapter.packageName) : {folder: place};
const engine = await adapter.start(loaderFrom(place), folder);
print(["program", "version", "asset", "hulls", "count", "mass", "centre", "inertia", "volume", "friction", "pose",
       "swap mm/s", "stand mm", "drift mm"]);
for (const setting of adapter.settings) {
  console.log(`${setting.name}:`);
  for (const one of kCases) {
    if (extent !== "long" && adapter.slow?.includes(one.asset)) continue;
    measureAsset(engine, engine.version ?? version, setting, one);
  }
}
process.exit(faults > 0 ? 1 : 0);
