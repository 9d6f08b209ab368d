#pragma once

namespace rubble {

/// What the cells' colours say, as in the 3D view; Level: through how many levels the piece is broken again.
enum class CellColouring { None, Piece, Area, Neighbours, Aspect, Level, Volume, Mass, Threshold };

/// What a canvas shows beside the outline.
struct CanvasLayers {
    bool hasGrid = true;
    bool hasCells = true;
    bool hasSeeds = true;
    bool hasTriangles = false;     // Delaunay's, and the circle around the hovered one
    bool hasWholeVoronoi = false;  // the cells' edges beyond the outline
    bool hasBonds = false;         // lines between cells that touch, as wide as the edge they share
    bool hasLegend = true;
    CellColouring colouring = CellColouring::Piece;
    bool operator==(const CanvasLayers&) const = default;
};

}  // namespace rubble
