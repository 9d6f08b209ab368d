#pragma once

#include "core/fracture/layer/LayerForward.h"

namespace rubble {

/// Moves the scattered seeds of the layers before it to the centroids of their cells, `rounds` times. Seeds placed by
/// hand or moved by an override stay.
/// Source: Lloyd, "Least squares quantization in PCM", 1982.
struct LloydRelaxation {
    std::uint32_t rounds = 3;

    bool operator==(const LloydRelaxation&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    Status applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const;
    static const LayerKind kKind;
};

}  // namespace rubble
