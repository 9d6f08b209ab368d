// Reads pack.json, version 1 and 2, as an engine would, without the header for C++.
import {readFileSync, writeFileSync} from "node:fs";
import {inset, principalOf} from "./geometry.mjs";

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
    level: body.parent === null ? 0 : undefined,
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

/// Its hulls moved inwards by d, m, where those of the file are not already.
export function withInset(pack, d) {
  if (pack.inset > 0) return pack;
  const moved = (body) => ({...body, hulls: body.hulls.map((hull) => inset(hull, d))});
  return {...pack, inset: d, whole: moved(pack.whole), fragments: pack.fragments.map(moved)};
}

/// A hull as in a file, with edges and signed edges.
function withEdges({vertices, faces, planes}) {
  const numbers = new Map();
  const edges = [];
  const signedEdges = faces.map((face) => face.map((a, k) => {
    const b = face[(k + 1) % face.length];
    const key = `${Math.min(a, b)} ${Math.max(a, b)}`;
    if (!numbers.has(key)) numbers.set(key, edges.push([a, b]) - 1);
    const number = numbers.get(key);
    return [number, edges[number][0] === a ? 1 : -1];
  }));
  return {vertices, edges, faces, signedEdges, planes};
}

/// Writes a copy of a file whose hulls are moved inwards by d, m.
export function writeInset(from, to, d) {
  const pack = JSON.parse(readFileSync(from, "utf8"));
  for (const body of [pack.whole, ...pack.fragments]) {
    body.hulls = body.hulls.map((hull) => withEdges(inset(hull, d)));
  }
  writeFileSync(to, JSON.stringify(pack));
}

/// The fragments into which the whole breaks.
export const fragmentsOfWhole = (pack) => pack.whole.children.map((k) => pack.fragments[k]);

/// What there is when all has broken.
export const leaves = (pack) => pack.fragments.filter((fragment) => fragment.children.length === 0);
