#pragma once

#include "core/geometry/hull/Polytope.h"
#include "core/geometry/polygon/AreaMoments.h"

#include <array>
#include <cstdint>
#include <span>

namespace rubble {

/// The mass properties of a body of density 1 kg/m³: multiply volume and inertia by the density.
struct MassProperties {
    double volume = 0.0;         // m³, which is kg at density 1
    Vec3 centre{0.0, 0.0, 0.0};  // m
    Mat3 inertia{0.0};           // m⁵, about the centre, in the body's axes
};

/// The mass properties of an area extruded to z in [-depth/2, depth/2].
MassProperties massOfPrism(const AreaMoments& moments, double depth);
MassProperties massOfPrism(const Polygon& outline, double depth);

/// The mass properties of a closed polytope. Computed relative to its first vertex.
MassProperties massOf(const Polytope& polytope);

/// The mass properties of what a closed mesh encloses, whose triangles are counter-clockwise from outside. Computed
/// relative to its first point.
MassProperties massOf(std::span<const Vec3> points, std::span<const std::array<std::uint32_t, 3>> triangles);

/// The mass properties of several bodies together, by the parallel-axis theorem.
MassProperties combined(std::span<const MassProperties> parts);
/// The same of some of the bodies, by index.
MassProperties combined(std::span<const MassProperties> bodies, std::span<const std::uint32_t> parts);

}  // namespace rubble
