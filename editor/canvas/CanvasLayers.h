#pragma once

namespace rubble {

/// What the cells' colours say. Those by piece and by area are the same as in the 3D view.
enum class CellColouring { None, Piece, Area, Neighbours, Aspect };

/// What a canvas shows beside the outline.
struct CanvasLayers {
    bool hasGrid = true;
    bool hasCells = true;
    bool hasSeeds = true;
    bool hasTriangles = false;     // Delaunay's, and the circle around the hovered one
    bool hasWholeVoronoi = false;  // the cells' edges beyond the outline
    bool hasLegend = true;
    CellColouring colouring = CellColouring::Piece;
    bool operator==(const CanvasLayers&) const = default;
};

}  // namespace rubble
