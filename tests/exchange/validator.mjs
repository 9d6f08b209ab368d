// gltf-validator finds no error and no warning in the GLB files of packs: node validator.mjs PACKS PLACE
// [physics|compact|baked]. It says which extensions it does not know: those of physics, and that of compression. Baked
// files have three images each, in them or beside them.
import {readFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {meshesOf} from "./meshes.mjs";
import {installed, loaderFrom} from "./packages.mjs";

const [packs, place, kind] = process.argv.slice(2);
const {version} = installed(place, "gltf-validator");
const {default: validator} = await loaderFrom(place)("gltf-validator");
let faults = 0;
for (const {path, name} of meshesOf(packs)) {
  const externalResourceFunction = async (uri) => new Uint8Array(readFileSync(join(dirname(path), uri)));
  const {issues, info} = await validator.validateBytes(new Uint8Array(readFileSync(path)), {externalResourceFunction});
  const {numErrors, numWarnings, numInfos} = issues;
  console.log(`gltf-validator ${version}: ${name}: errors ${numErrors}, warnings ${numWarnings}, infos ${numInfos}`);
  for (const {severity, code, message} of issues.messages) {
    if (severity < 2) console.log(`  ${code}: ${message}`);
  }
  faults += numErrors + numWarnings;
  const images = info.resources.filter(({image}) => image).map(({image}) => image);
  if (kind === "baked" && !(images.length === 3 && images.every(({width, height}) => width === 512 && height === 512))) {
    console.log(`  FAULT: ${images.length} images of 512 x 512`);
    ++faults;
  }
  const unknown = issues.messages.filter(({code}) => code === "UNSUPPORTED_EXTENSION").length;
  if (unknown !== ({physics: 4, compact: 1}[kind] ?? 0)) {
    console.log(`  FAULT: ${unknown} extensions that it does not know`);
    ++faults;
  }
}
process.exit(faults > 0 ? 1 : 0);
