// Reads pack.json, version 1 and 2, as an engine would, without the header for C++.
import {readFileSync} from "node:fs";
import {principalOf} from "./geometry.mjs";

/// The pack of a file: {name, threshold, whole, fragments}. A body has, beside its keys in the file, `level`,
/// `principal` {moments descending, rotation [x, y, z, w]}, `friction`, `restitution` and `children`, indices.
/// Throws where it is no pack of version 1 or 2.
export function readPack(path) {
  const pack = JSON.parse(readFileSync(path, "utf8"));
  if (pack.format !== "rubble-pack") throw new Error(`${path}: no pack`);
  if (!(pack.version === 1 || pack.version === 2)) throw new Error(`${path}: version ${pack.version}`);
  const material = pack.version === 1 ? pack.material : pack.materials[pack.material];
  const complete = (body) => ({
    ...body,
    level: body.level ?? (body.parent === null ? 0 : undefined),
    principal: body.principal ?? principalOf(body.inertia),
    friction: material.friction,
    restitution: material.restitution,
    children: [],
  });
  const whole = complete(pack.whole);
  const fragments = pack.fragments.map(complete);
  fragments.forEach((fragment, k) => {
    const parent = fragment.parent === null ? whole : fragments[fragment.parent];
    parent.children.push(k);
    fragment.level ??= parent.level + 1;
  });
  return {version: pack.version, name: pack.asset.name, threshold: pack.threshold, material, whole, fragments,
          inset: pack.collision?.inset ?? 0, meshes: pack.meshes, path};
}

/// The fragments into which the whole breaks.
export const fragmentsOfWhole = (pack) => pack.whole.children.map((k) => pack.fragments[k]);

/// What there is when all has broken.
export const leaves = (pack) => pack.fragments.filter((fragment) => fragment.children.length === 0);
