#pragma once

#include "core/base/Result.h"
#include "core/geometry/MassProperties.h"
#include "core/physics/Hull.h"

#include <memory>
#include <span>
#include <vector>

namespace rubble {

/// What a body is made of, shared by all bodies of this form: one or more convex hulls about their common centre of mass.
struct Shape {
    std::vector<Hull> hulls;
    MassProperties mass;       // at density 1 kg/m^3, in the frame that the hulls were given in
    Mat3 inverseInertia{1.0};  // 1/(kg m^2), at that density
    double surface = 0.0;      // m^2: of all hulls, where they touch each other, too
    float reach = 0.0f;        // m: the farthest vertex from the centre of mass
    float breadth = 0.0f;  // m: the least width of any hull; what moves farther than that in a step may pass through
};

/// The shape of convex polytopes in one frame. Mass properties are those of the polytopes together, or those given, as of
/// the exact piece where the polytopes are simpler than it.
///
/// Errors: BadInput for no polytope, one of more corners than kMostHullCorners, one without volume, or mass properties that
/// are not positive and finite.
Result<std::shared_ptr<const Shape>> makeShape(std::span<const Polytope> polytopes);
Result<std::shared_ptr<const Shape>> makeShape(std::span<const Polytope> polytopes, const MassProperties& mass);

}  // namespace rubble
