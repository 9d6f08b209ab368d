#pragma once

#include <QColor>
#include <QPalette>

#include <cstdint>

namespace rubble {

/// The colours of a canvas, for a light or a dark palette.
struct CanvasColours {
    QColor background, minorGrid, grid, axis, label;
    QColor cell, cellEdge, outline, halo;  // `cell`: for cells without a colouring
    QColor triangle, circle, wholeVoronoi, bond;
    QColor edgeOnScale, triangleOnScale;       // over cells coloured by a scale from dark to light
    QColor anchored, neverBreaks;              // marks of fragments and bonds
    QColor weakBond, neutralBond, strongBond;  // a scale; safe for red-green colour blindness
    QColor added, gone, moved, reshaped;       // since an earlier state; safe for red-green colour blindness
    QColor accent, hover, fault, measure, panel, panelEdge, text;
};
CanvasColours canvasColours(const QPalette& palette);

/// The colour of the seeds of the k-th layer: dark enough to stand out from cells, and distinct from the next layers'.
QColor layerColour(std::size_t layer);

}  // namespace rubble
