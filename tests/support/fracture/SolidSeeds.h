#pragma once

#include "core/base/math/Trigonometry.h"
#include "core/fracture/pattern/Pattern.h"
#include "core/fracture/sampling/SolidDomain.h"
#include "tests/support/geometry/SolidShapes.h"

#include <map>
#include <utility>
#include <vector>

namespace rubble::test {

inline SolidDomain domainOf(const TriangleMesh& mesh) { return SolidDomain::of(mesh).value(); }

/// An axis-aligned box of 12 triangles.
inline TriangleMesh boxMeshOf(Vec3 min, Vec3 max) {
    const Vec3 size = max - min;
    return transformed(cubes({{0, 0, 0}}), Mat3(size.x, 0, 0, 0, size.y, 0, 0, 0, size.z), min);
}

/// A rotation about no axis of the coordinates.
inline Mat3 obliqueTurn() {
    const double c = cosine(0.7), s = sine(0.7);
    return Mat3(Vec3(c, s, 0), Vec3(-s, c, 0), Vec3(0, 0, 1)) * Mat3(Vec3(1, 0, 0), Vec3(0, c, s), Vec3(0, -s, c));
}

/// A closed shell: a sphere of radius 1 with a hollow, `thickness` below its surface.
inline TriangleMesh hollowSphere(double thickness) {
    const TriangleMesh sphere = bumpySphere(24);
    return together(sphere, insideOut(transformed(sphere, Mat3(1.0 - thickness))));
}

/// Solids of many shapes, thin ones among them, at small and large scales.
inline std::vector<std::pair<const char*, TriangleMesh>> solidShapes() {
    const TriangleMesh u = cubes({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}, {0, 2, 0}, {2, 2, 0}});
    const TriangleMesh plate = boxMeshOf({0, 0, 0}, {1, 1, 1e-3}), foil = boxMeshOf({0, 0, 0}, {1, 1, 1e-6});
    return {{"cube", boxMeshOf({0, 0, 0}, {1, 1, 1})},
            {"sphere", bumpySphere(24)},
            {"torus", torus(24, 16)},
            {"thin ring", transformed(torus(24, 16), Mat3(1, 0, 0, 0, 1, 0, 0, 0, 0.01))},
            {"U", u},
            {"plate", plate},
            {"tilted plate", transformed(plate, obliqueTurn())},
            {"tilted foil", transformed(foil, obliqueTurn())},
            {"hollow sphere", hollowSphere(1e-3)},
            {"tiny U", transformed(u, Mat3(1e-6))},
            {"far torus", transformed(torus(24, 16), Mat3(1e-2), {1e4, -1e4, 1e4})},
            {"huge torus", transformed(torus(24, 16), Mat3(1e6))}};
}

/// The seeds of a pattern of one layer in a mesh.
inline Result<Seeds> layerSeedsIn(LayerParameters parameters, const SolidDomain& domain, std::uint64_t randomSeed = 1) {
    return seedsOf(Pattern{{{.id = 1, .randomSeed = randomSeed, .parameters = std::move(parameters)}}}, domain);
}

inline std::vector<Vec3> positionsOf(const Seeds& seeds) {
    std::vector<Vec3> positions;
    for (std::size_t k = 0; k < seeds.ids.size(); ++k) positions.push_back(seeds.at(k));
    return positions;
}

/// The positions of seeds of one layer by their indices in it.
inline std::map<std::uint32_t, Vec3> placesByIndex(const Seeds& seeds) {
    std::map<std::uint32_t, Vec3> places;
    for (std::size_t k = 0; k < seeds.ids.size(); ++k) places[seeds.ids[k].index] = seeds.at(k);
    return places;
}

}  // namespace rubble::test
