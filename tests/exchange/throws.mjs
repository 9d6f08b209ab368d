// Plays the saved throws of the demo house in an engine, by its scene.json and pack.json alone, and compares what breaks
// with what rubble-cli simulates: node throws.mjs ENGINE PACKS PLACE CLI [SECONDS]. Exits with 1 where they differ by more
// than docs/exchange.md says, 77 where the engine is not installed.
import {spawnSync} from "node:child_process";
import {readFileSync} from "node:fs";
import {join} from "node:path";
import {fileURLToPath} from "node:url";
import {fragmentsOf, keepMotion, largestImpacts, returnExcess} from "./breaking.mjs";
import {add, cross, dot, identity, length, product, quaternionOf, rotated, scaled, sub, tensorOf} from "./geometry.mjs";
import {installed, loaderFrom} from "./packages.mjs";
import {readPack} from "./pack.mjs";

const kRate = 240;          // Hz: so a fast projectile is not deep in what it hits
const kProjectileFriction = 0.6;
const kHit = 2 / 60;        // s: breaks of the first hit; later ones are by debris, and differ with every small change
const kHardest = 0.05;      // relative: the hardest impact of a hit
const kOthers = 0.4;        // the others, which depend on what the projectile hit before
const kNear = 1.2;          // thresholds: impacts below may break in one program and not in another
const kLater = 2.5;         // times as many instances, or as few

const [engineName, packs, place, cli, seconds = 5] = process.argv.slice(2);
const adapter = await import(`./engines/${engineName}.mjs`);
const {version, folder} = installed(place, adapter.packageName);
const engine = await adapter.start(loaderFrom(place), folder);
const setting = {...adapter.settings.at(-1), substeps: 1};
const project = fileURLToPath(new URL("../../projects/house.rubble", import.meta.url));

const scene = JSON.parse(readFileSync(join(packs, "scene.json"), "utf8"));
const packOf = new Map(scene.packs.map((pack) => [pack.folder, readPack(join(packs, pack.folder, "pack.json"))]));

const posed = (body, position, rotation) =>
  ({...body, position, rotation, principalPose: product(rotation, body.principal.rotation)});

/// The rotation of a projectile: its z axis is opposite to its path, its x axis horizontal.
function facing(path) {
  const back = scaled(path, -1 / length(path));
  const side = [back[2], 0, -back[0]];
  const right = length(side) > 0 ? scaled(side, 1 / length(side)) : [1, 0, 0];
  return quaternionOf([right, cross(back, right), back]);
}

/// The box or ball of a throw, at its start.
function projectileOf({projectile, size, mass, from, to}) {
  if (!["box", "plank", "ball"].includes(projectile)) throw new Error(`no projectile: ${projectile}`);
  const radius = projectile === "ball" ? size[0] / 2 : undefined;
  const moments = [0, 1, 2].map((k) => (radius ? 0.4 * mass * radius ** 2 : mass / 12 * (dot(size, size) - size[k] ** 2)));
  const signs = [[-1, 1], [-1, 1], [-1, 1]].reduce((all, both) => all.flatMap((some) => both.map((s) => [...some, s])), [[]]);
  const hulls = [{vertices: signs.map((corner) => corner.map((sign, k) => sign * size[k] / 2))}];
  const body = {mass, hulls, radius, centreOfMass: [0, 0, 0], principal: {moments, rotation: identity},
                inertia: tensorOf({moments, rotation: identity}), friction: kProjectileFriction, restitution: 0,
                isFast: true};
  return posed(body, from, facing(sub(to, from)));
}

/// The scene in the engine: `bodies` by the adapter's handles.
class Play {
  constructor() {
    this.world = engine.world(scene.gravity, 1 / kRate, setting);
    this.bodies = new Map();
    this.breaks = [];
    this.impacts = new Map();  // the hardest by instances, N s
    this.world.addFloor(scene.ground.height, scene.ground.friction);
    for (const instance of scene.instances) {
      const pack = packOf.get(instance.pack);
      const position = add(instance.position, rotated(instance.rotation, pack.whole.offset));
      const threshold = instance.unbreakable ? undefined : instance.threshold ?? pack.threshold;
      this.add(posed(pack.whole, position, instance.rotation), {name: instance.name, pack, threshold});
    }
    this.world.finish?.();
  }
  add(body, more) {
    const handle = this.world.add(body);
    this.bodies.set(handle, {body, handle, ...more});
    return handle;
  }
  throwOne({name, action}) {
    const path = sub(action.to, action.from);
    this.add(projectileOf(action), {name}).setMotion(scaled(path, action.speed / length(path)), [0, 0, 0]);
  }
  /// Fragments that break again would have thresholds of their own; those of the house do not.
  swap(one) {
    const fragments = fragmentsOf(one);
    this.world.remove(one.handle);
    this.bodies.delete(one.handle);
    for (const {fragment, position, rotation, velocity, angularVelocity} of fragments) {
      this.add(posed(fragment, position, rotation), {name: `${one.name} (a fragment)`, pack: one.pack})
        .setMotion(velocity, angularVelocity);
    }
  }
  step(number) {
    keepMotion(this.bodies.values());
    this.world.step();
    const impacts = largestImpacts(this.world.contacts(), (handle) => this.bodies.get(handle), 1 / kRate);
    for (const [one, {impulse}] of impacts) this.impacts.set(one.name, Math.max(impulse, this.impacts.get(one.name) ?? 0));
    const broken = [...impacts].filter(([one, {impulse}]) => impulse >= one.threshold);
    for (const [one, impact] of broken) {
      this.breaks.push({step: number, body: one.name, impact: impact.impulse});
      returnExcess(one, impact);
    }
    for (const [one] of broken) this.swap(one);
  }
}

/// The scene after a throw.
function play(shot) {
  const played = new Play();
  const start = Math.ceil(shot.time * kRate - 1e-6);
  for (let step = 0; step < seconds * kRate; ++step) {
    if (step === start) played.throwOne(shot);
    played.step(step + 1);
  }
  played.world.end?.();
  return played;
}

/// What breaks in the editor, with steps of the same length.
function simulate(shot) {
  const run = spawnSync(cli, ["simulate", project, "--quiet", "--shot", shot.name, "--dt", String(1 / kRate), "--steps",
                              String(seconds * kRate)], {encoding: "utf8"});
  if (run.status !== 0) throw new Error(run.stderr ?? run.error.message);
  return JSON.parse(run.stdout).breaks;
}

function check(is, what) {
  if (is) return;
  console.log(`  FAULT: ${what}`);
  process.exitCode = 1;
}
const textOf = ({body, step, impact}) => `${body} at ${(step / kRate).toFixed(3)} s by ${impact.toFixed(0)} N s`;

/// Compares the breaks of the first hit, with all that the editor breaks in it. What hits several bodies at once shares
/// its impulse among them in the editor; here each contact is measured alone, so that only what breaks is compared, of
/// the bodies that share it.
function compareHit(expected, {breaks, impacts}) {
  const end = expected[0].step / kRate + kHit;
  const ofHit = (all) => all.filter(({step}) => step / kRate <= end);
  const hit = ofHit(expected), found = ofHit(breaks);
  console.log(`  editor: ${hit.map(textOf).join(", ")}`);
  console.log(`  engine: ${found.map(textOf).join(", ")}`);
  const first = hit.filter(({step}) => step === hit[0].step), isShared = first.length > 1;
  for (const {body, impact, threshold} of isShared ? first : hit) {
    const match = found.find((one) => one.body === body);
    const is = match?.impact ?? impacts.get(body) ?? 0;
    if (!match) console.log(`  ${body} does not break by ${is.toFixed(0)} N s`);
    check(match || impact < kNear * threshold, `${body} does not break`);
    check(isShared || Math.abs(is / impact - 1) < kOthers, `the impact on ${body} is ${is} N s`);
  }
  for (const {body} of found) check(hit.some((one) => one.body === body), `${body} does not break in the editor`);
  const [hardest, should] = [found, hit].map((all) => Math.max(...all.map(({impact}) => impact)));
  const [limit] = setting.looser?.hardest ?? [kHardest];
  check(isShared || Math.abs(hardest / should - 1) < limit, `the hardest impact is ${hardest} N s`);
  check(Math.abs(found[0]?.step - hit[0].step) <= kHit * kRate, "the first break is at another time");
}

for (const shot of scene.shots.filter(({kind}) => kind === "throw")) {
  const expected = simulate(shot);
  const found = play(shot);
  const both = found.breaks.filter(({body}) => expected.some((one) => one.body === body));
  console.log(`${adapter.program} ${engine.version ?? version}, ${shot.name}, ${seconds} s: ${expected.length} instances ` +
              `break in the editor, ${found.breaks.length} here, ${both.length} of them in both`);
  if (expected.length > 0) compareHit(expected, found);
  else check(found.breaks.length === 0, found.breaks.map(textOf).join(", "));
  const [less, more] = [expected.length, found.breaks.length].sort((a, b) => a - b);
  check(more <= kLater * less, "too many or too few instances break");
}
