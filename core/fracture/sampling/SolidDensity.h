#pragma once

#include "core/geometry/search/Box3.h"

#include <functional>

namespace rubble {

/// A density of seeds in space, in any unit: at a point, and an upper bound of it in a box, which has to come close to
/// it as the box gets small. Without functions: constant.
struct SolidDensity {
    std::function<double(Vec3)> at = nullptr;
    std::function<double(const Box3&)> maxIn = nullptr;

    bool isConstant() const { return !at; }
};

}  // namespace rubble
