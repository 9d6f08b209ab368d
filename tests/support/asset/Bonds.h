#pragma once

#include "core/asset/project/Bonding.h"
#include "tests/support/fracture/PatternSamples.h"

#include <string>

namespace rubble {

/// Bonds in which no member has its default value; fragments are those of layer `layer`.
inline Bonding everyBonding(const std::string& layer) {
    return {.impulsePerArea = 1234.5,
            .radius = 0.7,
            .falloff = HitFalloff::Smooth,
            .damageFrom = 1.0 / 3.0,
            .span = 1.25,
            .collapseDelay = 0.75,
            .minimumIsland = 3,
            .strokes = {{.brush = BondBrush::Strength, .strength = 2.5, .radius = 0.2, .points = {{0.25, 1.0 / 3.0}}},
                        {.brush = BondBrush::NeverBreaks,
                         .isErasing = true,
                         .radius = 0.05,
                         .points = {{0.1, 0.2}, {0.3, -0.4}}},
                        {.brush = BondBrush::Anchor, .points = {{0.5, 0.0}, {0.75, 0.0}}}},
            .heightStrengths = {{.height = 0.25, .factor = 3.0}, {.height = 0.5, .factor = 0.125}},
            .strengthImage = StrengthImage{.darkest = 0.25, .brightest = 4.0, .image = fourPixels()},
            .neverBreaks = {layer + ".1", layer + ".4"},
            .clusters = {{.level = 0, .fragments = {layer + ".1", layer + ".2", layer + ".3"}},
                         {.level = 1, .fragments = {layer + ".2", layer + ".3"}}}};
}

}  // namespace rubble
