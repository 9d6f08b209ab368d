#pragma once

#include "editor/canvas/painting/CanvasPainting.h"

namespace rubble {

/// The factors of strength at the ends of the colour scale; others have the colours of its ends.
inline constexpr double kWeakestShown = 0.1, kStrongestShown = 10.0;

/// The colour of a bond whose strength is multiplied by a factor, on a logarithmic scale; infinite: it never breaks.
QColor bondColour(double factor, const CanvasColours& colours);

/// Paints CanvasContents::bondMarks: what is anchored and what never breaks, and the bonds by their strength.
void paintBondMarks(QPainter& painter, const CanvasView& view, const CanvasContents& contents,
                    const CanvasColours& colours);

/// The symbol of an anchored fragment: an anchor.
void paintAnchorSymbol(QPainter& painter, QPointF centre, const CanvasColours& colours);
/// The symbol of a fragment that never breaks: a shield.
void paintShieldSymbol(QPainter& painter, QPointF centre, const CanvasColours& colours);

}  // namespace rubble
