#pragma once

#include "core/geometry/polygon/Polygon.h"

#include <cmath>

namespace rubble {

/// The weld distance of an outline, relative to its extent: four times the largest difference of two constructions of
/// one point.
inline constexpr double kWeldFraction = 0x1p-46;

/// A local origin for constructions, and the distance below which points are welded.
struct LocalFrame {
    Vec2 origin{0.0, 0.0};
    double extent = 0.0;        // m: the largest coordinate of the outline relative to the origin
    double weldDistance = 0.0;  // m: points within it in x and in y are welded

    bool coincide(Vec2 a, Vec2 b) const {
        return std::abs(a.x - b.x) <= weldDistance && std::abs(a.y - b.y) <= weldDistance;
    }
};

/// The frame of an outline. Subtracting its origin from the outline's points is exact.
LocalFrame localFrame(const Polygon& outline);

}  // namespace rubble
