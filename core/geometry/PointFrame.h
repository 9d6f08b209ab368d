#pragma once

#include "core/geometry/Polygon.h"

#include <cmath>

namespace rubble {

/// Points of an outline's pieces are one where they are nearer than this part of its reach: four times what two
/// constructions of one point can be off.
inline constexpr double kJoinedPart = 0x1p-46;

/// Where points are measured from, and how far they lie from there.
struct PointFrame {
    Vec2 origin{0.0, 0.0};
    double reach = 0.0;         // the outline's largest coordinate relative to the origin
    double joinDistance = 0.0;  // points that are nearer in x and in y are one

    bool areOne(Vec2 a, Vec2 b) const {
        return std::abs(a.x - b.x) <= joinDistance && std::abs(a.y - b.y) <= joinDistance;
    }
};

/// The frame for an outline. Subtracting its origin from the outline's points does not round.
PointFrame frameOf(const Polygon& outline);

}  // namespace rubble
