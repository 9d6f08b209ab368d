#pragma once

#include "core/asset/mesh/OutlineInterval.h"
#include "core/asset/mesh/SurfaceUv.h"
#include "core/asset/project/Project.h"
#include "core/geometry/mesh/Mesh.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// A side face over the edge between two corners of the outline; corners are numbered through its rings.
struct ExtrudedSide {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    FaceSide side = FaceSide::Outside;
    OutlineInterval outline;  // of an outside face: its position along the asset's outline
    double start = 0.0;       // m along its cut, of an inside face
};

/// An outline with its sides, extruded to z in [-depth/2, depth/2].
struct ExtrudedSolid {
    Polygon outline;                  // m, relative to `offset`; neighbouring corners differ
    std::vector<ExtrudedSide> sides;  // one per corner
    double depth = 0.0;               // m
    Vec3 offset{0.0, 0.0, 0.0};       // m, of its origin in the prism's frame
    bool isConvex = true;             // then each cap is one face
};

/// The closed surface of the solid in its own frame: a front and a back vertex per corner, shared by caps and sides;
/// caps (outside) as one face or as convex parts, then outside sides, then inside sides; with a surface, those of the
/// outside by material. Of an outline that touches itself, which cannot be decomposed, each ring is a face. UVs
/// outside: from the asset's surface, or in metres (x and y on caps, length along the outline and z on sides). UVs
/// inside: (length along the cut, z) times the asset's inside scale.
///
/// `surface`: the surface of the asset; null without an imported surface.
Mesh extrudedMesh(const ExtrudedSolid& solid, const Asset& asset, const SurfaceIndex* surface);

}  // namespace rubble
