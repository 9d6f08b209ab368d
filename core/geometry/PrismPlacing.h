#pragma once

#include "core/geometry/AxisView.h"
#include "core/geometry/PrismFinder.h"

#include <optional>

namespace rubble {

/// The frame turned about its z so that the outline's longest edge (the first of equally long ones) lies along its x or
/// y; nothing where some edge does so already.
std::optional<ViewFrame> frameAlongEdge(const ViewFrame& frame, const Polygon& outline, double tolerance);

/// The prism of an outline in a view's frame, as deep as the view, with the middle of the outline's box as origin.
/// Numbers are made multiples of a power of ten, a hundredth of the tolerance or less, so that files hold 0.2 and
/// not 0.19999999999999998.
///
/// Errors: those of validated(Polygon).
Result<FoundPrism> placedPrism(const AxisView& view, Polygon outline, double tolerance);

}  // namespace rubble
