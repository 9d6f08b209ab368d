#pragma once

#include "core/fracture/layer/LayerForward.h"

namespace rubble {

/// A grain, as in wood: distances along it are divided by `ratio`, so that the cells of all seeds of the pattern are
/// elongated. Cuts and the positions of seeds do not change. In a closed mesh the grain has any direction in space.
struct Grain {
    double angle = 0.0;  // rad, counter-clockwise from the x axis
    double ratio = 3.0;  // >= 1: elongation of the cells
    double tilt = 0.0;   // rad, of a closed mesh's grain: out of the xy plane, towards z

    bool operator==(const Grain&) const = default;
    static const LayerKind kKind;
};

}  // namespace rubble
