#pragma once

namespace rubble {

/// The quantity that cells are coloured by, as in the 3D view. Level: the number of further levels that fracture the
/// piece.
enum class CellColouring { None, Fragment, Area, Neighbours, Aspect, Level, Volume, Mass, Threshold, Cluster };

/// Whether cells are coloured by a number, on a scale.
inline bool isQuantity(CellColouring colouring) {
    return colouring != CellColouring::None && colouring != CellColouring::Fragment &&
           colouring != CellColouring::Cluster;
}

/// The elements that a canvas shows besides the outline.
struct CanvasOverlays {
    bool hasGrid = true;
    bool hasCells = true;
    bool hasSeeds = true;
    bool hasTriangles = false;      // of the Delaunay triangulation, and the circumcircle of the hovered one
    bool hasWholeVoronoi = false;   // cell edges beyond the outline
    bool hasBonds = false;          // lines between neighbouring cells, as wide as the shared edge is long
    bool hasBondStrengths = false;  // bonds of an asset that breaks as bonded, coloured by their strength
    bool hasDeeperLevels = false;   // edges of the fragments of the fragments
    bool hasLegend = true;
    CellColouring colouring = CellColouring::Fragment;
    bool operator==(const CanvasOverlays&) const = default;
};

}  // namespace rubble
