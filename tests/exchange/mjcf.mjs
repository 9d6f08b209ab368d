// MuJoCo loads the models of packs (.mjcf.xml) unmodified: node mjcf.mjs PACKS PLACE. Compares the bodies with the pack.
import {existsSync, readFileSync, readdirSync} from "node:fs";
import {basename, join} from "node:path";
import {length, sub, tensorOf} from "./geometry.mjs";
import {leaves, readPack} from "./pack.mjs";
import {installed, loaderFrom} from "./packages.mjs";

const [packs, place] = process.argv.slice(2);
const {version, folder} = installed(place, "@mujoco/mujoco");
const {default: loadMujoco} = await loaderFrom(place)("@mujoco/mujoco");
const mujoco = await loadMujoco({wasmBinary: readFileSync(join(folder, "mujoco.wasm"))});

/// The largest errors of the bodies of a model: relative ones, and of places in m.
function errorsOf(model, fragments) {
  const errors = {mass: 0, inertia: 0, centre: 0, pose: 0};
  const worse = (what, error) => { errors[what] = Math.max(errors[what], Number.isFinite(error) ? error : Infinity); };
  const of = (values, k, count) => [...values.subarray(count * k, count * k + count)];
  fragments.forEach((body, index) => {
    const k = index + 1;  // 0 is the world
    const [w, x, y, z] = of(model.body_iquat, k, 4);
    const inertia = tensorOf({moments: of(model.body_inertia, k, 3), rotation: [x, y, z, w]}).flat();
    const expected = body.inertia.flat();
    worse("mass", Math.abs(model.body_mass[k] / body.mass - 1));
    const least = 1e-14;  // kg m^2, that is written
    worse("inertia", Math.max(0, length(sub(inertia, expected)) - Math.sqrt(3) * least) / length(expected));
    worse("centre", length(of(model.body_ipos, k, 3)));
    worse("pose", length(sub(of(model.qpos0, index, 7), [...body.offset, 1, 0, 0, 0])));
  });
  return errors;
}

let faults = 0;
let files = 0;
const folders = readdirSync(packs, {withFileTypes: true}).filter((entry) => entry.isDirectory());
for (const name of folders.map((entry) => entry.name).sort()) {
  const path = join(packs, name, `${name}.mjcf.xml`);
  if (!existsSync(path)) continue;
  ++files;
  const fragments = leaves(readPack(join(packs, name, "pack.json")));
  const hulls = fragments.reduce((sum, {hulls: own}) => sum + own.length, 0);
  const model = mujoco.MjModel.from_xml_string(readFileSync(path, "utf8"));
  const errors = errorsOf(model, fragments);
  console.log(`MuJoCo ${version}: ${basename(path)}: bodies ${model.nbody - 1}, hulls ${model.ngeom - 1}, ` +
    Object.entries(errors).map(([what, error]) => `${what} ${error.toExponential(1)}`).join(", "));
  const wrong = Object.entries(errors).filter(([, error]) => !(error < 1e-9)).map(([what]) => `${what} differs`);
  if (model.nbody - 1 !== fragments.length) wrong.push(`${fragments.length} bodies expected`);
  if (model.ngeom - 1 !== hulls) wrong.push(`${hulls} hulls expected`);
  for (const fault of wrong) console.log(`  FAULT: ${fault}`);
  faults += wrong.length;
  model.delete();
}
if (files === 0) throw new Error(`there is no file in ${packs}`);
process.exit(faults > 0 ? 1 : 0);
