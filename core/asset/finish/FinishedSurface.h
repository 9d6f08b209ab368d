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

/// A finish at a point of an asset (m, in its frame), on a face with a normal, of a material with a linear colour: what
/// finish.glsl computes, as seen from nearby. `courseOrigin`: see BrickCourseFrame. `grainAxis`: x, y or z.
FinishedSurface finishedSurface(const FinishParameters& parameters, Vec3 point, Vec3 normal, Vec3 colour,
                                Vec2 courseOrigin, int grainAxis = 0);

}  // namespace rubble
