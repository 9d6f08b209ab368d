#pragma once

#include "core/geometry/predicates/Vec.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace rubble {

/// A triangle of the mesh that an asset was imported from, in the prism's frame.
struct SurfaceTriangle {
    std::array<Vec3, 3> corners;  // m, counter-clockwise from outside
    std::array<Vec2, 3> uvs;
    std::uint32_t material = 0;  // index into Surface::materials
    bool operator==(const SurfaceTriangle&) const = default;
};

/// u = a·x + b·y + c and v = d·x + e·y + f on a cap.
struct AffineUv {
    std::array<double, 6> coefficients{};
    bool operator==(const AffineUv&) const = default;
};

/// The source of the UVs of one cap: an affine map, or the nearest source triangles.
struct CapUv {
    bool isAffine = false;
    AffineUv map;
    std::uint32_t material = 0;
    bool operator==(const CapUv&) const = default;
};

/// The outside surface of an imported asset: materials and UVs of the source mesh, for export and rendering.
struct Surface {
    std::vector<std::string> materials;  // names, in the source's order
    CapUv front;                         // z = +depth/2
    CapUv back;
    std::vector<SurfaceTriangle> triangles;
    bool operator==(const Surface&) const = default;
};

}  // namespace rubble
