#pragma once

#include "core/fracture/layer/LayerForward.h"

#include <cstdint>

namespace rubble {

/// Like LloydRelaxation, but with centroids weighted by the density of the image and impact layers before it: cells
/// become regular, small where the density is high and large elsewhere. Without such layers it equals LloydRelaxation.
/// Seeds placed by hand or moved by an override stay.
///
/// Source: Du, Faber, Gunzburger, "Centroidal Voronoi tessellations", 1999. The weight is the square of the target
/// density, because the density of relaxed seeds follows the root of the weight (Gersho 1979).
struct WeightedLloyd {
    std::uint32_t rounds = 10;

    bool operator==(const WeightedLloyd&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    static const LayerKind kKind;
};

}  // namespace rubble
