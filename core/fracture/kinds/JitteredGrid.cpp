#include "core/fracture/kinds/JitteredGrid.h"

#include "core/base/MessageText.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "core/fracture/sampling/PairIndex.h"
#include "core/fracture/sampling/ScatterArea.h"
#include "core/fracture/sampling/SolidScatterDomain.h"
#include "core/geometry/polygon/ContainmentIndex.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kDefaultGridColumns = 6.0;  // cells along the longer side in a new layer

bool hasNumber(const JitteredGrid& grid) { return grid.cells == GridCells::Number; }
bool hasSize(const JitteredGrid& grid) { return grid.cells == GridCells::Size; }

constexpr std::array<ParameterOption, 2> kCells{{{"number", "Columns and rows"}, {"size", "Cell size"}}};

constexpr std::array kJitteredGridParameters{
    parameter<&JitteredGrid::cells>({.name = "cells",
                                     .caption = "Grid",
                                     .hint = "Set the number of columns and rows, or the cell size",
                                     .options = kCells}),
    parameter<&JitteredGrid::columns>({.name = "columns",
                                       .caption = "Columns",
                                       .hint = "Number of columns; adding more keeps the names of existing seeds",
                                       .range = {1.0, kMaxPairNumber},
                                       .sliderRange = {1.0, 50.0},
                                       .usedIf = usedIf<JitteredGrid, hasNumber>}),
    parameter<&JitteredGrid::rows>({.name = "rows",
                                    .caption = "Rows",
                                    .hint = "Number of rows; adding more keeps the names of existing seeds",
                                    .range = {1.0, kMaxPairNumber},
                                    .sliderRange = {1.0, 50.0},
                                    .usedIf = usedIf<JitteredGrid, hasNumber>}),
    parameter<&JitteredGrid::cellWidth>({.name = "cellWidth",
                                         .caption = "Cell width",
                                         .hint = "Width of a cell; the grid is centred on the outline",
                                         .quantity = Quantity::Length,
                                         .range = kAboveZero,
                                         .sliderRange = {0.01, 2.0, true},
                                         .usedIf = usedIf<JitteredGrid, hasSize>}),
    parameter<&JitteredGrid::cellHeight>({.name = "cellHeight",
                                          .caption = "Cell height",
                                          .hint = "Height of a cell; the grid is centred on the outline",
                                          .quantity = Quantity::Length,
                                          .range = kAboveZero,
                                          .sliderRange = {0.01, 2.0, true},
                                          .usedIf = usedIf<JitteredGrid, hasSize>}),
    parameter<&JitteredGrid::jitter>({.name = "jitter",
                                      .caption = "Jitter",
                                      .hint = "0: seeds at the centres of their cells; 1: anywhere in them",
                                      .range = {0.0, 1.0},
                                      .sliderRange = {0.0, 1.0}}),
    parameter<&JitteredGrid::domain>(kDomainParameter),
    parameter<&JitteredGrid::layers>({.name = "layers",
                                      .caption = "Layers",
                                      .hint = "Number of layers along z; adding more keeps the names of existing seeds",
                                      .range = {1.0, kMaxTripleNumber},
                                      .sliderRange = {1.0, 50.0},
                                      .usedIf = usedIf<JitteredGrid, hasNumber>,
                                      .isSpatial = true}),
    parameter<&JitteredGrid::cellDepth>({.name = "cellDepth",
                                         .caption = "Cell depth",
                                         .hint = "Size of a cell along z; the grid is centred on the mesh",
                                         .quantity = Quantity::Length,
                                         .range = kAboveZero,
                                         .sliderRange = {0.01, 2.0, true},
                                         .usedIf = usedIf<JitteredGrid, hasSize>,
                                         .isSpatial = true}),
};

/// The cells along one axis.
struct Axis {
    double from = 0.0;  // m
    double step = 0.0;  // m
    double count = 0.0;

    double at(double cell, double fraction) const { return from + step * (cell + fraction); }
    /// The number of cells that cover [low, high], too, if they are enumerated from the first to the last and then
    /// alternately beyond these.
    double countCovering(double low, double high) const {
        const double after = std::ceil((high - from) / step) - count, before = std::ceil((from - low) / step);
        return count + 2.0 * std::max({after, before, 0.0});
    }
    /// The position of a cell in the row by its number in that enumeration.
    double cellOf(std::uint32_t number) const {
        const double beyond = number - count;
        if (beyond < 0.0) return number;
        const double half = std::floor(beyond / 2.0);
        return beyond == 2.0 * half ? count + half : -1.0 - half;
    }
};

Axis axisOf(double from, double length, std::uint32_t count) {
    return {from, length / count, static_cast<double>(count)};
}

/// The number of cells that fits the length best, centred.
Axis axisOf(double from, double length, double step) {
    const double count = std::max(1.0, std::floor(length / step + 0.5));
    return {from + (length - step * count) / 2.0, step, count};
}

Error tooManyCells(const LayerContext& context, double count) {
    return {ErrorCode::Limit, context.name() + " has " + messageText(count) + " cells along one side, but " +
                                  std::to_string(kMaxPairNumber) + " is the maximum."};
}

}  // namespace

constinit const LayerKind JitteredGrid::kKind{.name = "jitteredGrid",
                                              .caption = "Jittered grid",
                                              .hint = "One seed in each cell of a grid",
                                              .icon = "layer-grid",
                                              .role = LayerRole::Scatters,
                                              .parameters = kJitteredGridParameters,
                                              .isRandom = true,
                                              .fillsOutline = true};

const char* JitteredGrid::summary() const {
    const bool hasCellSize = cells == GridCells::Size;
    return hasCellSize ? "{cellWidth} × {cellHeight}" : "{columns} × {rows}";
}

JitteredGrid JitteredGrid::defaultsFor(const Box3& bounds) {
    const Vec3 size = bounds.max - bounds.min;
    const double side = std::max({size.x, size.y, size.z}) / kDefaultGridColumns;
    const auto cellsAlong = [&](double length) {
        return static_cast<std::uint32_t>(std::max(1.0, std::floor(length / side + 0.5)));
    };
    JitteredGrid grid{.columns = cellsAlong(size.x), .rows = cellsAlong(size.y), .cellWidth = side, .cellHeight = side};
    if (size.z > 0.0) grid.layers = cellsAlong(size.z), grid.cellDepth = side;
    return grid;
}

Status JitteredGrid::apply(const LayerContext& context, SeedSet& seeds) const {
    const Box2 box = boundsOf(context.scatterOutline().outer), now = boundsOf(context.outline.outer);
    const Vec2 size = box.size();
    const bool isByNumber = cells == GridCells::Number;
    const Axis horizontal = isByNumber ? axisOf(box.min.x, size.x, columns) : axisOf(box.min.x, size.x, cellWidth);
    const Axis vertical = isByNumber ? axisOf(box.min.y, size.y, rows) : axisOf(box.min.y, size.y, cellHeight);
    const bool isEdited = context.scatteredIn != nullptr;  // the outline; the grid stays and is continued
    const double columnCount = isEdited ? horizontal.countCovering(now.min.x, now.max.x) : horizontal.count;
    const double rowCount = isEdited ? vertical.countCovering(now.min.y, now.max.y) : vertical.count;
    if (const double max = std::max(columnCount, rowCount); !(max <= kMaxPairNumber)) return tooManyCells(context, max);
    if (columnCount * rowCount > static_cast<double>(kMaxSeeds - seeds.size())) return tooManySeeds(context);

    const bool isOutline = domain == ScatterDomain::Outline;
    const ContainmentIndex outline(ScatterArea::domain(context.outline, domain));
    std::size_t round = 0;
    for (const IndexPair cell :
         pairsBelow(static_cast<std::uint32_t>(columnCount), static_cast<std::uint32_t>(rowCount))) {
        if (context.isCancelledAt(round++)) return TaskContext::cancelled();
        const std::uint32_t index = cell.index();
        Random random = context.randomOf(index);
        const double x = horizontal.at(horizontal.cellOf(cell.first), 0.5 + jitter * (random.unit() - 0.5));
        const double y = vertical.at(vertical.cellOf(cell.second), 0.5 + jitter * (random.unit() - 0.5));
        if ((isOutline || isEdited) && outline.of({x, y}) == Containment::Outside) continue;
        seeds.add({context.layerId, index}, {x, y}, false);
    }
    return success();
}

double JitteredGrid::estimatedPieces(double area) const {
    if (cells == GridCells::Number) return static_cast<double>(columns) * rows;
    return area / cellWidth / cellHeight;
}

Status JitteredGrid::applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const {
    const SolidScatterDomain filled{context.domain, domain};
    const Vec3 from = context.domain.bounds().min, size = filled.size();
    const bool isByNumber = cells == GridCells::Number;
    const std::uint32_t numbers[] = {columns, rows, layers};
    const double sides[] = {cellWidth, cellHeight, cellDepth};
    Axis axes[3];
    for (int k = 0; k < 3; ++k) {
        axes[k] = isByNumber ? axisOf(from[k], size[k], numbers[k]) : axisOf(from[k], size[k], sides[k]);
        if (!(axes[k].count <= kMaxTripleNumber)) return tooManyNumbers(context, "cells along one side", axes[k].count);
    }
    if (axes[0].count * axes[1].count * axes[2].count > static_cast<double>(kMaxSeeds - seeds.size()))
        return tooManySeeds(context);
    const auto count = [&](int axis) { return static_cast<std::uint32_t>(axes[axis].count); };
    std::vector<IndexedPlace> places;
    std::size_t round = 0;
    for (std::uint32_t layer = 0; layer < count(2); ++layer) {
        for (const IndexPair cell : pairsBelow(count(0), count(1))) {
            if (context.isCancelledAt(round++)) return TaskContext::cancelled();
            const std::uint32_t index = tripleIndex(cell.first, cell.second, layer);
            Random random = context.randomOf(index);
            const double x = axes[0].at(cell.first, 0.5 + jitter * (random.unit() - 0.5));
            const double y = axes[1].at(cell.second, 0.5 + jitter * (random.unit() - 0.5));
            const double z = axes[2].at(layer, 0.5 + jitter * (random.unit() - 0.5));
            if (filled.contains({x, y, z})) places.push_back({index, {x, y, z}});
        }
    }
    addByIndex(places, context, seeds);
    return success();
}

double JitteredGrid::estimatedPiecesIn(const SolidDomain& solid) const {
    if (cells == GridCells::Number) return static_cast<double>(columns) * rows * layers;
    return SolidScatterDomain{solid, domain}.volume() / cellWidth / cellHeight / cellDepth;
}

}  // namespace rubble
