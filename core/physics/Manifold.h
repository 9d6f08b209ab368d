#pragma once

#include "core/physics/SeparatingAxis.h"

#include <array>

namespace rubble {

inline constexpr int kMostManifoldPoints = 4;

/// Where two hulls touch or nearly do, in the first hull's frame.
struct Manifold {
    struct Point {
        Vec3f place{0.0f, 0.0f, 0.0f};  // m, halfway between the hulls
        float separation = 0.0f;        // m, negative where they overlap
        std::uint32_t feature = 0;      // the same as long as the same corner or edges make it
    };
    Vec3f normal{0.0f, 1.0f, 0.0f};  // from first to second, length 1
    int count = 0;
    std::array<Point, kMostManifoldPoints> points;
};

/// What a look at two hulls gave.
struct Look {
    Manifold manifold;  // in the first hull's frame
    SeparatingAxis axis;
    Vec3f offset{0.0f, 0.0f, 0.0f};  // m: where the second's centre is then, in the first's frame
    bool isSwept = false;            // the manifold is of where they will meet
};

/// The points along an axis that are nearer than `margin`: of a face, the other hull's facing face clipped to it and reduced to
/// the four that span most; of edges, the point between them, or none where the lines meet beyond their ends.
/// Source: Gregorius 2015, "Robust contact creation".
Manifold manifoldAlong(const SeparatingAxis& axis, const Hull& first, const Hull& second, const RelativePlace& place,
                       float margin);

/// The same of hulls that are known to touch along the axis: where the clipping leaves no point, the corner that touches.
Manifold touchingAlong(const SeparatingAxis& axis, const Hull& first, const Hull& second, const RelativePlace& place,
                       float margin);

}  // namespace rubble
