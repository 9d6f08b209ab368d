#pragma once

#include "core/fracture/PatternKindForward.h"

#include <cstdint>
#include <numbers>

namespace rubble {

/// Straight cuts right across, at equal distances but for what varies. A piece is called by the number of cuts that lie before it:
/// on its left where they are upright, above it where they are level.
struct Slices {
    std::uint32_t cuts = 5;
    double angle = std::numbers::pi / 2.0;  // rad: of the cuts, counter-clockwise from the x axis
    double offsetVariation = 0.3;           // 0: at equal distances; 1: anywhere up to half way to the neighbouring cut
    double angleVariation = 0.1;            // rad: how far a cut is turned either way at most

    bool operator==(const Slices&) const = default;
    Status cut(const LayerContext& context, CutSet& cuts) const;
    static const PatternKind kKind;
};

}  // namespace rubble
