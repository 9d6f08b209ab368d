#pragma once

#include "core/fracture/layer/LayerForward.h"
#include "core/fracture/sampling/ScatterDomain.h"

namespace rubble {

/// The definition of a grid: a number of cells over the outline's bounding box, or cells of a given size, centred in
/// it.
enum class GridCells { Number, Size };

/// One seed in each cell of a grid, displaced from the centre at random. A seed keeps its index, and its position in
/// the cell, when columns or rows are added.
struct JitteredGrid {
    GridCells cells = GridCells::Number;
    std::uint32_t columns = 6;  // columns and rows: for GridCells::Number
    std::uint32_t rows = 6;
    double cellWidth = 0.2;                         // m; width and height: for GridCells::Size
    double cellHeight = 0.2;                        // m
    double jitter = 0.5;                            // 0: at the centre; 1: anywhere in the cell
    ScatterDomain domain = ScatterDomain::Outline;  // seeds outside are omitted

    // In a closed mesh: the grid along z.
    std::uint32_t layers = 1;
    double cellDepth = 0.2;  // m

    bool operator==(const JitteredGrid&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    Status applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const;
    double estimatedPieces(double area) const;
    double estimatedPiecesIn(const SolidDomain& domain) const;
    static const LayerKind kKind;
    const char* summary() const;
    static JitteredGrid defaultsFor(const Box3& bounds);
};

}  // namespace rubble
