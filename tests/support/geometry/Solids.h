#pragma once

#include "core/geometry/mesh/TriangleMesh.h"
#include "core/geometry/polygon/ConvexParts.h"

#include <glm/gtc/quaternion.hpp>

namespace rubble {

/// The prism of an outline, z in [-depth/2, depth/2], closed, welded, counter-clockwise from outside. The points
/// of the bottom come first, in the order of the outline's.
inline TriangleMesh prismSolid(const Polygon& outline, double depth) {
    TriangleMesh solid;
    std::vector<Ring> rings{outline.outer};
    rings.insert(rings.end(), outline.holes.begin(), outline.holes.end());
    std::uint32_t count = 0;
    for (const Ring& ring : rings) count += static_cast<std::uint32_t>(ring.size());
    for (const double z : {-depth / 2.0, depth / 2.0})
        for (const Ring& ring : rings)
            for (const Vec2 corner : ring) solid.points.emplace_back(corner.x, corner.y, z);
    const Result<IndexLoops> cap = triangles(outline);
    RUBBLE_ASSERT(cap.hasValue());
    for (const auto& loop : *cap) {
        solid.triangles.push_back({loop[2], loop[1], loop[0]});
        solid.triangles.push_back({loop[0] + count, loop[1] + count, loop[2] + count});
    }
    std::uint32_t first = 0;
    for (const Ring& ring : rings) {
        const auto size = static_cast<std::uint32_t>(ring.size());
        for (std::uint32_t i = 0; i < size; ++i) {
            const std::uint32_t a = first + i, b = first + (i + 1) % size;
            solid.triangles.push_back({a, b, b + count});
            solid.triangles.push_back({a, b + count, a + count});
        }
        first += size;
    }
    return solid;
}

/// The same mesh where a pose puts it.
inline TriangleMesh placed(TriangleMesh mesh, const Pose& pose) {
    for (Vec3& point : mesh.points) point = pose.position + pose.orientation * point;
    return mesh;
}

/// Both meshes in one.
inline TriangleMesh joined(TriangleMesh first, const TriangleMesh& second) {
    const auto count = static_cast<std::uint32_t>(first.points.size());
    first.points.insert(first.points.end(), second.points.begin(), second.points.end());
    for (const auto& [a, b, c] : second.triangles) first.triangles.push_back({a + count, b + count, c + count});
    return first;
}

/// A bent open sheet whose ends, 1 m apart along z, meet in a point if seen along z: the silhouette touches itself
/// there. Along x and y it does not.
inline TriangleMesh touchingInProjection() {
    return {{{0, 0, 0},
             {-2, -1, 0},
             {-2, 2, 0},
             {-1, 2, 0},
             {-2, 3, 0},  // from the point to the left, at z = 0
             {0, 0, 1},
             {2, -1, 1},
             {2, 2, 1},
             {1, 2, 1},
             {2, 3, 1}},  // to the right, at z = 1
            {{0, 3, 2}, {0, 2, 1}, {2, 3, 4}, {3, 8, 4}, {8, 9, 4}, {8, 7, 9}, {5, 6, 7}, {5, 7, 8}}};
}

}  // namespace rubble
