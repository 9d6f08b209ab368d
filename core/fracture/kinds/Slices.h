#pragma once

#include "core/fracture/layer/LayerForward.h"

#include <cstdint>
#include <numbers>

namespace rubble {

/// Straight parallel cuts at equal distances, with random variation. A cell is named by the number of cuts before it:
/// on its left if they are vertical, above it if they are horizontal.
///
/// In a closed mesh, a seed is placed in each slice, along their normal through the middle of the mesh's box, so that
/// the cells of this layer alone are slices: the cuts are half-way between neighbouring seeds, and rotated as far as
/// the step from one to the next is.
struct Slices {
    std::uint32_t cuts = 5;
    double angle = std::numbers::pi / 2.0;  // rad: of the cuts, counter-clockwise from the x axis
    double offsetVariation = 0.3;           // 0: equidistant; 1: up to halfway to the neighbouring cut
    double angleVariation = 0.1;            // rad: maximum rotation of a cut in either direction

    double tilt = 0.0;  // rad, in a closed mesh: of the cuts about their direction; π/2: horizontal

    bool operator==(const Slices&) const = default;
    Status cut(const LayerContext& context, CutSet& cuts) const;
    Status applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const;
    double estimatedPiecesIn(const SolidDomain& domain) const;
    static const LayerKind kKind;
};

}  // namespace rubble
