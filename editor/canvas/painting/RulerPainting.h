#pragma once

#include "editor/canvas/painting/CanvasColours.h"
#include "editor/canvas/painting/CanvasView.h"
#include "editor/widgets/numbers/Units.h"

#include <QFontMetrics>
#include <QPainter>
#include <QString>

#include <vector>

namespace rubble {

enum class Ruler { Top, Left };

/// A tick of a ruler.
struct RulerTick {
    double at = 0.0;  // pixels along the ruler
    bool isLabelled = false;
    QString label;      // localized; empty if it would be cut off and could be misread
    double from = 0.0;  // extent of the label, pixels along the ruler
    double to = 0.0;
};
/// The ticks of a ruler in a view: five per label; the labels are 1, 2 or 5 times a power of ten apart.
std::vector<RulerTick> rulerTicks(Ruler ruler, const CanvasView& view, const Units& units, const QFontMetrics& metrics);

/// The font of the rulers: somewhat smaller than that of the window, as far as their width allows.
QFont rulerFont(const QFont& font);

/// Paints rulers along the top and left edges and marks the pointer's position on them; `format` is that of lengths.
void paintRulers(QPainter& painter, const CanvasView& view, const Units& units, const CanvasColours& colours,
                 QPointF pointer);
inline constexpr double kRulerWidth = 22.0;  // pixels

}  // namespace rubble
