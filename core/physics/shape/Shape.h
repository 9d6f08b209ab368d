#pragma once

#include "core/base/Result.h"
#include "core/geometry/hull/MassProperties.h"
#include "core/physics/shape/Hull.h"

#include <memory>
#include <span>
#include <vector>

namespace rubble {

/// The collision shape and mass properties of a body: one or more convex hulls relative to their common centre of mass.
/// Shared by all bodies of this shape.
struct Shape {
    std::vector<Hull> hulls;
    MassProperties mass;          // at density 1 kg/m³, in the frame of the given polytopes
    Mat3 inverseInertia{1.0};     // 1/(kg·m²), at that density
    double surfaceArea = 0.0;     // m²: total surface area of all hulls
    float boundingRadius = 0.0f;  // m: distance from the centre of mass to the farthest vertex
    Vec3f extents{0.0f};          // m: the largest distance of a vertex from the centre of mass along each axis
    float minWidth = 0.0f;        // m: the least width of any hull; a body moving farther in a step may tunnel
};

/// The shape of convex polytopes in one frame. Mass properties are those of the polytopes, or those given, such as
/// those of the exact fragment if the polytopes are simplified.
///
/// Errors: those of makeHull(); BadInput for no polytope, or mass properties that are not positive and finite.
Result<std::shared_ptr<const Shape>> makeShape(std::span<const Polytope> polytopes);
Result<std::shared_ptr<const Shape>> makeShape(std::span<const Polytope> polytopes, const MassProperties& mass);

}  // namespace rubble
