#pragma once

#include "core/fracture/PatternKindForward.h"

#include <cstdint>

namespace rubble {

/// Moves the scattered seeds of the layers before it as LloydRelaxation does, but to where the layers of density images and impacts
/// among those want them: cells become even in shape, small where these are dense and large elsewhere. Without such layers it does
/// the same as LloydRelaxation. Seeds placed by hand or moved by an override stay where they are.
///
/// Source: Du, Faber, Gunzburger 1999; a cell's weight is the square of the wished density, as relaxed cells follow the root of
/// their weight (Gersho 1979).
struct WeightedLloyd {
    std::uint32_t rounds = 10;

    bool operator==(const WeightedLloyd&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    static const PatternKind kKind;
};

}  // namespace rubble
