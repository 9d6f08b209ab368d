#pragma once

#include "core/geometry/polygon/IndexedCorners.h"

namespace rubble {

/// Relinks the edges at each point with several corners, so that each corner bounds one sector of the interior by its
/// own two edges: a hole that touches the outer ring at a point becomes part of it. Each edge still starts at the same
/// corner. Returns false, with undefined corners, if incoming and outgoing edges do not alternate around a point. Edges
/// must intersect only at their ends.
bool splitTouchingCorners(IndexedCorners& corners);

}  // namespace rubble
