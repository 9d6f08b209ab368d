#pragma once

#include "core/geometry/polygon/PolygonFaults.h"
#include "editor/canvas/painting/CanvasColours.h"
#include "editor/canvas/painting/CanvasView.h"

#include <QPainter>

#include <vector>

namespace rubble {

/// Why an outline cannot be fractured: its faults, otherwise the first place where it is too narrow. Empty if it is
/// valid.
std::vector<PolygonFault> outlineFaults(const Polygon& outline);

/// Marks the faults of `outline`, with the message of the first one beside it.
void paintFaults(QPainter& painter, const Polygon& outline, const std::vector<PolygonFault>& faults,
                 const CanvasView& view, const CanvasColours& colours);

/// The ring with an index as in PolygonFault: 0 is the outer ring, k is hole k - 1.
const Ring& ringOf(const Polygon& outline, int ring);
Ring& ringOf(Polygon& outline, int ring);
int ringCount(const Polygon& outline);

}  // namespace rubble
