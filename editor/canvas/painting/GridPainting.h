#pragma once

#include "editor/canvas/painting/CanvasColours.h"
#include "editor/canvas/painting/CanvasView.h"
#include "editor/widgets/numbers/Units.h"

#include <QPainter>

#include <cmath>

namespace rubble {

/// The spacing of the grid lines in a view, m: 1, 2 or 5 times a power of ten of metres or feet, wide enough on screen
/// to point at.
double gridStep(const CanvasView& view, const Units& units);

/// Paints the grid into `part`: minor lines, every fourth or fifth one stronger, and the axes.
void paintGrid(QPainter& painter, const QRectF& part, const CanvasView& view, const Units& units,
               const CanvasColours& colours);

/// Moves a coordinate to the centre of its pixel. Lines are one pixel wide; equal coordinates up to rounding share a
/// pixel.
double onPixel(double coordinate);

/// Calls `visit` with each integer k for which k * step is in [from, to].
template <class Visit>
void forEachGridLine(double from, double to, double step, Visit visit) {
    const double first = std::ceil(from / step), last = std::floor(to / step);
    for (double k = first; k <= last; k += 1.0) visit(k);
}

}  // namespace rubble
