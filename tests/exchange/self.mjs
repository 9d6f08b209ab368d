// Checks what the suite itself computes: insets, principal axes, and packs of both versions. node self.mjs PACKS
import assert from "node:assert/strict";
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {dot, inset, principalOf, solidOf, tensorOf} from "./geometry.mjs";
import {fragmentsOfWhole, leaves, readPack} from "./pack.mjs";

const [packs] = process.argv.slice(2);
const pathOf = (asset) => join(packs, asset, "pack.json");
const near = (is, should, tolerance) => assert.ok(Math.abs(is - should) <= tolerance, `${is} is not ${should}`);

// A box of 2 x 4 x 6 m loses 1 cm on each side, and a box of 2 cm all.
const box = (x, y, z) => ({
  vertices: [[-x, -y, -z], [x, -y, -z], [x, y, -z], [-x, y, -z], [-x, -y, z], [x, -y, z], [x, y, z], [-x, y, z]],
  faces: [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]],
  planes: [[0, 0, -1, z], [0, 0, 1, z], [0, -1, 0, y], [1, 0, 0, x], [0, 1, 0, y], [-1, 0, 0, x]],
});
near(solidOf(box(1, 2, 3)).volume, 48, 1e-12);
near(solidOf(inset(box(1, 2, 3), 0.01)).volume, 1.98 * 3.98 * 5.98, 1e-9);
assert.equal(inset(box(0.01, 1, 1), 0.02).vertices.length, 0);

for (const asset of ["roof", "wall", "pane", "terraces", "two_levels"]) {
  const pack = readPack(pathOf(asset));
  const touching = readPack(join(`${packs}-touching`, asset, "pack.json"));
  assert.equal(touching.inset, 0);
  assert.equal(pack.inset, 1e-4);
  pack.fragments.forEach((fragment, k) => {
    // Principal axes give the tensor again, and are those that are computed here.
    const tensor = tensorOf(fragment.principal).flat();
    fragment.inertia.flat().forEach((moment, i) => near(tensor[i], moment, 1e-12 * fragment.principal.moments[0]));
    const [a, b, c] = fragment.principal.moments;
    assert.ok(a >= b && b >= c && c > 0 && a <= (b + c) * (1 + 1e-9), fragment.name);
    principalOf(fragment.inertia).moments.forEach((moment, i) => near(moment, [a, b, c][i], 1e-12 * a));
    near(dot(fragment.principal.rotation, fragment.principal.rotation), 1, 1e-12);
    // Hulls are closed, and those that touch less their inset.
    fragment.hulls.forEach((hull, h) => {
      const edges = hull.faces.reduce((sum, face) => sum + face.length, 0) / 2;
      assert.equal(hull.vertices.length - edges + hull.faces.length, 2, fragment.name);
      assert.ok(hull.inset > 0 && hull.inset <= 1e-4, fragment.name);
      const expected = solidOf(inset(touching.fragments[k].hulls[h], hull.inset)).volume;
      near(solidOf(hull).volume / expected, 1, 1e-6);
    });
  });
}

// Levels, children and leaves.
const levels = readPack(pathOf("two_levels"));
assert.ok(fragmentsOfWhole(levels).every((fragment) => fragment.level === 0 && fragment.parent === null));
assert.ok(leaves(levels).some((fragment) => fragment.level === 1));
near(leaves(levels).reduce((sum, fragment) => sum + fragment.mass, 0), levels.whole.mass, 1e-6 * levels.whole.mass);

// Both versions of a pack say the same.
const folder = mkdtempSync(join(tmpdir(), "rubble-exchange-"));
process.on("exit", () => rmSync(folder, {recursive: true}));
const other = join(folder, "pack.json");
const text = JSON.parse(readFileSync(pathOf("wall"), "utf8"));
const {principal, ...body} = text.whole;
writeFileSync(other, JSON.stringify({...text, version: 1, material: text.materials[0], whole: body}));
const earlier = readPack(other);
assert.equal(earlier.material.friction, readPack(pathOf("wall")).material.friction);
near(earlier.whole.principal.moments[0], principal.moments[0], 1e-9 * principal.moments[0]);
writeFileSync(other, JSON.stringify({...text, version: 3}));
assert.throws(() => readPack(other), /version 3/);
console.log("insets, principal axes and versions of packs are as expected");
