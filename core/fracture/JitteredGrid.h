#pragma once

#include "core/fracture/PatternKindForward.h"
#include "core/fracture/ScatterDomain.h"

namespace rubble {

/// By what a grid is told: so many cells over the outline's bounding box, or cells of a size in its middle.
enum class GridCells { Number, Size };

/// One seed in each cell of a grid, in its middle or anywhere in it. A seed keeps its index, and its place within the cell, when
/// columns or rows are added.
struct JitteredGrid {
    GridCells cells = GridCells::Number;
    std::uint32_t columns = 6;  // these two for GridCells::Number
    std::uint32_t rows = 6;
    double cellWidth = 0.2;                         // m; these two for GridCells::Size
    double cellHeight = 0.2;                        // m
    double jitter = 0.5;                            // 0: in the middle; 1: anywhere in the cell
    ScatterDomain domain = ScatterDomain::Outline;  // seeds outside are left out

    bool operator==(const JitteredGrid&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    static const PatternKind kKind;
};

}  // namespace rubble
