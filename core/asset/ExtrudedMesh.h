#pragma once

#include "core/asset/OutlineStretch.h"
#include "core/asset/Project.h"
#include "core/geometry/Mesh.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// A side over the edge between two corners of the outline, which are numbered through its rings.
struct ExtrudedSide {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    FaceSide side = FaceSide::Outside;
    OutlineStretch stretch;  // where an outside one lies along the asset's outline
    double start = 0.0;      // m: where an inside one begins along its cut
};

/// What a mesh is made from: an outline with its sides, extruded to z in [-depth/2, depth/2].
struct ExtrudedSolid {
    Polygon outline;                  // m, less `offset`; neighbouring corners differ
    std::vector<ExtrudedSide> sides;  // one a corner
    double depth = 0.0;               // m
    Vec3 offset{0.0, 0.0, 0.0};       // of its origin in the prism's frame, m
    bool isConvex = true;             // then each cap is one face
};

/// The closed surface of the solid in its own frame: a vertex at the front and at the back of every corner, shared by
/// caps and sides; caps (outside) as one face or as convex parts, then outside sides, then inside sides. Texture
/// coordinates: outside from the asset's surface, or else in metres (x and y on caps, length along the outline and z on
/// sides); inside (length along the cut, z) times the asset's inside scale.
Mesh extrudedMesh(const ExtrudedSolid& solid, const Asset& asset);

}  // namespace rubble
