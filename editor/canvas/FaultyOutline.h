#pragma once

#include "core/geometry/PolygonFaults.h"
#include "editor/canvas/CanvasColours.h"
#include "editor/canvas/CanvasView.h"

#include <QPainter>

#include <vector>

namespace rubble {

/// What keeps an outline from being cut: its faults, or else the first place where it is too narrow. Empty where it is sound.
std::vector<PolygonFault> outlineFaults(const Polygon& outline);

/// Paints the edges and places of an outline's faults, and the sentence of the first one beside it. `outline` has them.
void paintFaults(QPainter& painter, const Polygon& outline, const std::vector<PolygonFault>& faults,
                 const CanvasView& view, const CanvasColours& colours);

/// The ring with a number as faults count them: 0 the outer one, k hole k - 1.
const Ring& ringOf(const Polygon& outline, int ring);
Ring& ringOf(Polygon& outline, int ring);
int ringCount(const Polygon& outline);

}  // namespace rubble
