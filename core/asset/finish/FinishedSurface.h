#pragma once

#include "core/asset/finish/FinishParameters.h"
#include "core/geometry/predicates/Vec.h"

namespace rubble {

/// A point of a surface with a finish.
struct FinishedSurface {
    Vec3 albedo{0.0};  // linear
    double roughness = 0.0;
    double metalness = 0.0;
    double height = 0.0;  // m, along the normal
};

inline constexpr int kUpright = 2;  // y

/// The directions that finishes follow on an asset.
struct FinishFrame {
    Vec2 courseOrigin{0.0};  // m, see BrickCourseFrame
    int grainAxis = 0;       // x, y or z
    int up = kUpright;       // in which courses rise: 1, 2 or 3 for x, y or z; negative: against it
    bool operator==(const FinishFrame&) const = default;
};

/// A finish at a point of an asset (m, in its frame), on a face with a normal, of a material with a linear colour: what
/// finish.glsl computes, as seen from nearby.
FinishedSurface finishedSurface(const FinishParameters& parameters, Vec3 point, Vec3 normal, Vec3 colour,
                                const FinishFrame& frame = {});

}  // namespace rubble
