#pragma once

#include <QColor>
#include <QPalette>

#include <cstdint>

namespace rubble {

/// The colours of a canvas, for a light or a dark palette.
struct CanvasColours {
    QColor background, fineGrid, grid, axis, label;
    QColor cell, cellEdge, outline, halo;  // `cell`: where cells are not coloured
    QColor triangle, circle, wholeVoronoi, bond;
    QColor edgeOnScale, triangleOnScale;  // over cells whose colours show a value, from dark to light
    QColor added, gone, moved,
        reshaped;  // since an earlier state; told apart by people who see no red or no green, too
    QColor accent, hover, fault, measure, panel, panelEdge, text;
};
CanvasColours canvasColours(const QPalette& palette);

/// The colour of the seeds of the k-th layer: dark enough for cells, told apart from the next ones.
QColor layerColour(std::size_t layer);

}  // namespace rubble
