// Puts the fragments of the demo's sculptures, closed meshes, in the place of the whole: node sculptures.mjs ENGINE PACKS
// PLACE. Each alone, and all in one world, without gravity, for 30 steps. Exits with 1 where the engine lacks a convex
// hull of the packs, a figure is beyond its limit, or a limit has a reason that is no longer so; 77 where the engine is
// not installed.
import {join} from "node:path";
import {errorsOf, posed, run} from "./conformance.mjs";
import {add, scaled} from "./geometry.mjs";
import {fragmentsOfWhole, leaves, readPack} from "./pack.mjs";
import {installed, loaderFrom} from "./packages.mjs";

const kSteps = 30;
const kStep = 1 / 60;  // s
/// Parts of masses, moments and volumes; m; the depth of the deepest contact after a step, m, of hulls with a gap of
/// two insets, which are less for thin hulls; m/s.
const kLimits = {mass: 1e-6, centre: 1e-6, inertia: 1e-5, volume: 1e-5, pose: 1e-6, overlap: -1e-4, swap: 1e-3};

const kMaxCorners = 64;  // of a hull: those that PhysX collides on the GPU have no more

const [engineName, packs, place] = process.argv.slice(2);
const adapter = await import(`./engines/${engineName}.mjs`);
const {version, folder} = installed(place, adapter.packageName);
const engine = await adapter.start(loaderFrom(place), folder);

/// A body with lengths in other units, and masses as they are.
function inUnits(body, perMetre) {
  const square = perMetre ** 2;
  return {
    ...body,
    offset: scaled(body.offset, perMetre),
    inertia: body.inertia.map((row) => scaled(row, square)),
    principal: {...body.principal, moments: scaled(body.principal.moments, square)},
    hulls: body.hulls.map((hull) => ({...hull, vertices: hull.vertices.map((vertex) => scaled(vertex, perMetre))})),
  };
}

/// The depth of the deepest contact, negative where all are apart.
const deepest = (contacts) => Math.max(-Infinity, ...contacts.flatMap(({points}) => points.map(({depth}) => depth)));

/// A row of figures, in metres, of fragments that replace the whole.
function swapOf(setting, fragments) {
  const perMetre = setting.perMetre ?? 1;
  const bodies = posed(fragments.map((body) => inUnits(body, perMetre)));
  let overlap;
  const afterStep = (world, step) => { if (step === 0) overlap = deepest(world.contacts()) / perMetre; };
  const {found, speed, displacement} =
    run(engine, setting, bodies, {gravity: 0, seconds: kSteps * kStep, hasFloor: false, afterStep});
  const hulls = found.reduce((sum, body) => sum + body.hulls, 0);
  const {mass, centre, inertia, volume, pose} = errorsOf(found, bodies);
  return {mass, centre: centre / perMetre, inertia, volume, pose: pose / perMetre, hulls, overlap,
          swap: speed / perMetre, moved: displacement / perMetre};
}

function fault(text) {
  console.log(`  FAULT: ${text}`);
  process.exitCode = 1;
}

const inMillimetres = (value) => (Number.isFinite(value) ? (value * 1000).toFixed(3) : "none");
/// Prints a row, and what is beyond its limit; returns the names of the figures that are.
function check(name, fragments, row, limits) {
  const hulls = fragments.reduce((sum, body) => sum + body.hulls.length, 0);
  console.log(`  ${name}: bodies ${fragments.length}, hulls ${row.hulls} of ${hulls}, volume ${row.volume.toExponential(1)}, ` +
              `deepest contact ${inMillimetres(row.overlap)} mm, after ${kSteps} steps ${inMillimetres(row.swap)} mm/s, ` +
              `moved ${inMillimetres(row.moved)} mm`);
  const corners = Math.max(...fragments.flatMap((body) => body.hulls.map(({vertices}) => vertices.length)));
  if (corners > kMaxCorners) fault(`a hull has ${corners} corners`);
  if (row.hulls !== hulls) fault(`${hulls - row.hulls} hulls are missing`);
  const beyond = Object.keys(kLimits).filter((what) => !(row[what] <= kLimits[what]));
  for (const what of beyond) {
    const [limit, reason] = limits[what] ?? [kLimits[what]];
    if (row[what] <= limit) console.log(`    ${what} ${row[what].toExponential(1)}: ${reason}`);
    else fault(`${what} is ${row[what].toExponential(1)}, and ${limit} is the most`);
  }
  return beyond;
}

const packOf = (asset) => readPack(join(packs, asset, "pack.json"));
const column = packOf("column");
const sets = {"column, drums": fragmentsOfWhole(column), "column, all": leaves(column), vase: leaves(packOf("vase")),
              head: leaves(packOf("head"))};
sets.together = ["column, all", "vase", "head"].flatMap((name, k) =>
  sets[name].map((body) => ({...body, offset: add(body.offset, [2 * k, 0, 0])})));

for (const setting of [...adapter.settings, ...(adapter.variants ?? [])]) {
  console.log(`${adapter.program} ${engine.version ?? version}, ${setting.name}:`);
  const limits = setting.round ?? {};  // those that are looser for these, each with its reason
  const beyond = Object.entries(sets).flatMap(([name, fragments]) =>
    check(name, fragments, swapOf(setting, fragments), limits));
  for (const what of Object.keys(limits).filter((one) => !beyond.includes(one)))
    fault(`${what} is never beyond the limit of others: its reason is no longer so`);
}
process.exit();
