#pragma once

#include "tests/support/asset/Projects.h"

namespace rubble {

/// A box of 1 x 1 x 0.5 m with two placed halves, each fractured into quarters.
inline Asset layeredBox() {
    Asset asset = boxAsset(3, 5, PlacedSeeds{{{0, {0.125, 0.5}}, {1, {0.875, 0.5}}}});
    const Vec2 corner{0.25, 0.25};  // in the frame of a half, about its centre
    const PlacedSeeds quarters{{{0, -corner}, {1, {corner.x, -corner.y}}, {2, {-corner.x, corner.y}}, {3, corner}}};
    asset.levels = {{.pattern = {{{.id = 6, .parameters = quarters}}}, .minimumVolume = 0.0}};
    return asset;
}

}  // namespace rubble
