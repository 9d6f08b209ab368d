#pragma once

#include "core/physics/Shape.h"

#include <optional>
#include <string>

namespace rubble {

/// What a solid collides as.
struct BodyShape {
    std::shared_ptr<const Shape> shape;
    std::optional<std::string> simplified;  // how it differs from the solid, as a sentence
};

/// The shape of a solid of given mass, for whatever hulls it has: a hull with more than kMostHullCorners corners becomes that
/// of its farthest ones in many directions; a solid that makeShape() takes for flat becomes a box around it, of at
/// least kThinnest on each side. Mass, centre and inertia stay those given.
///
/// Errors: BadInput for no hulls or mass properties that are not positive and finite.
Result<BodyShape> bodyShape(std::span<const Polytope> hulls, const MassProperties& mass);

inline constexpr double kThinnest = 1e-3;  // m: thinner, and what rests on it is decided by rounding

}  // namespace rubble
