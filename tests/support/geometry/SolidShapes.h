#pragma once

#include "core/base/Random.h"
#include "core/geometry/mesh/TriangleMesh.h"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace rubble::test {

/// A sphere of radius 1 with bumps, of n rings and n segments: 2n(n - 1) triangles.
TriangleMesh bumpySphere(int n);
/// A torus of radii 1 and 0.4, of 2 · around · along triangles.
TriangleMesh torus(int around, int along);
/// The boundary of the filled cells of a grid of cubes of size 1; cells that meet only at an edge or a corner share
/// their points there.
TriangleMesh cubes(const std::set<std::array<int, 3>>& filled);
/// A Menger sponge of cubes of size 1: level 1 has 20 cubes, and genus 5.
TriangleMesh mengerSponge(int level);
/// A mesh moved, scaled or turned.
TriangleMesh transformed(TriangleMesh mesh, const Mat3& matrix, Vec3 offset = Vec3(0.0));
/// Both meshes in one.
TriangleMesh together(TriangleMesh a, const TriangleMesh& b);
/// The mesh with all triangles turned over.
TriangleMesh insideOut(TriangleMesh mesh);
/// Uniform in a mesh's box.
std::vector<Vec3> seedsInBox(const TriangleMesh& mesh, int count, std::uint64_t seed);

/// The boundary of some of the tetrahedra of a grid of up to 3 × 3 × 2 cubes: closed, with two triangles at each
/// edge; none where it would have more. With `canTouch`, sometimes of two such solids that touch each other.
TriangleMesh randomLatticeMesh(Random& random, bool canTouch);

}  // namespace rubble::test
