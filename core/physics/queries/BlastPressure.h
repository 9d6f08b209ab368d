#pragma once

#include "core/physics/queries/ShadowVolume.h"

namespace rubble {

/// A blast with its centre at the origin: impulse per area at the centre, falling linearly to 0 at the radius.
struct BlastPressure {
    double impulse = 0.0;  // N·s/m²
    double radius = 0.0;   // m, > 0
};

/// The sum of the impulses on faces. Each points away from the centre of the blast, so the sum acts along a line
/// through it: applied anywhere on this line, it rotates a body as all of them do.
struct BlastSum {
    Vec3 impulse{0.0, 0.0, 0.0};        // N·s
    double size = 0.0;                  // N·s: the sum of their lengths
    Vec3 weightedPoint{0.0, 0.0, 0.0};  // N·m·s: the sum of their points, each times the length
};

/// Adds the impulses on a visible part of a face: for each small area dA, seen at the distance d < radius under the
/// angle θ to its normal, impulse · (1 - d / radius) · cos θ · dA away from the centre.
///
/// The part is divided into triangles with edges shorter than a quarter of their distance, and shorter still at the
/// radius: errors are below 0.2 %. Their number grows with the logarithm of radius / distance.
void addBlastOn(const FacePolygon& part, const BlastPressure& blast, BlastSum& sum);

}  // namespace rubble
