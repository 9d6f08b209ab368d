#pragma once

#include "core/geometry/prism/AxisView.h"
#include "core/geometry/prism/PrismFit.h"

#include <optional>

namespace rubble {

/// The frame rotated about its z so that the longest edge of the outer ring, the first of several equal ones, is along
/// its x or y; nothing if any edge of that ring is already.
std::optional<ViewFrame> frameAlongEdge(const ViewFrame& frame, const Polygon& outline, double tolerance);

/// The prism of an outline in a view's frame, with the view's depth and the centre of the outline's bounding box as
/// origin. Numbers are rounded to a power of ten of at most a hundredth of the tolerance, so that files contain 0.2
/// instead of 0.19999999999999998.
///
/// Errors: those of validated(Polygon).
Result<PrismFit> placedPrism(const AxisView& view, Polygon outline, double tolerance);

}  // namespace rubble
