#pragma once

#include "core/physics/shape/Shape.h"

#include <optional>
#include <string>

namespace rubble {

/// The collision shape of a solid.
struct BodyShape {
    std::shared_ptr<const Shape> shape;
    std::optional<std::string> simplified;  // how it differs from the solid, as a sentence
};

/// The shape of a solid of given mass. A hull with more than kMaxHullCorners corners keeps those that span the most,
/// see simplifiedHull(); a solid that makeShape() rejects as flat becomes its bounding box, at least kMinThickness on
/// each side. Mass, centre and inertia stay as given.
///
/// Errors: BadInput without hulls, or for mass properties that are not positive and finite.
Result<BodyShape> bodyShape(std::span<const Polytope> hulls, const MassProperties& mass);

inline constexpr double kMinThickness = 1e-3;  // m: rounding decides how thinner bodies rest

}  // namespace rubble
