#pragma once

#include "core/geometry/AreaMoments.h"
#include "core/geometry/Polytope.h"

#include <span>

namespace rubble {

/// How matter of density 1 kg/m^3 is spread over a body: multiply volume and inertia by the density.
struct MassProperties {
    double volume = 0.0;         // m^3, which is kg at density 1
    Vec3 centre{0.0, 0.0, 0.0};  // m
    Mat3 inertia{0.0};           // m^5, about the centre, in the body's axes
};

/// The mass of an area extruded to z in [-depth/2, depth/2].
MassProperties massOfPrism(const AreaMoments& moments, double depth);
MassProperties massOfPrism(const Polygon& outline, double depth);

/// The mass of any closed polytope, relative to its first vertex.
MassProperties massOf(const Polytope& polytope);

/// Several bodies as one, by the parallel-axis theorem.
MassProperties combined(std::span<const MassProperties> parts);

}  // namespace rubble
