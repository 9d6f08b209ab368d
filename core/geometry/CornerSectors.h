#pragma once

#include "core/geometry/NumberedCorners.h"

namespace rubble {

/// Where several corners lie on one point, joins their edges anew so that each corner has one sector of the interior to
/// itself, bounded by its own two edges: a hole that touches the outer ring in a point becomes part of it. The edge that
/// starts at a corner still does. False, and the corners undefined, where edges do not alternate around a point, as they
/// do around an interior. Edges must have no more than ends in common.
bool partSectors(NumberedCorners& corners);

}  // namespace rubble
