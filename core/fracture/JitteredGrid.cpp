#include "core/base/MessageText.h"
#include "core/fracture/PairIndex.h"
#include "core/fracture/PatternKind.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kUsualAcross = 6.0;  // cells along the longer side of what a new layer is to fill

bool hasNumber(const LayerParameters& of) { return std::get<JitteredGrid>(of).cells == GridCells::Number; }
bool hasSize(const LayerParameters& of) { return !hasNumber(of); }

constexpr std::array<ParameterChoice, 2> kCells{{{"number", "Columns and rows"}, {"size", "Cells of a size"}}};

constexpr std::array kParameters{
    parameter<&JitteredGrid::cells>({.name = "cells",
                                     .caption = "Grid",
                                     .hint = "So many columns and rows, or cells of a size",
                                     .choices = kCells}),
    parameter<&JitteredGrid::columns>({.name = "columns",
                                       .caption = "Columns",
                                       .hint = "Cells side by side; more keep the names of the earlier seeds",
                                       .range = {1.0, kMostOfPair},
                                       .usual = {1.0, 50.0},
                                       .isUsed = hasNumber}),
    parameter<&JitteredGrid::rows>({.name = "rows",
                                    .caption = "Rows",
                                    .hint = "Cells above each other; more keep the names of the earlier seeds",
                                    .range = {1.0, kMostOfPair},
                                    .usual = {1.0, 50.0},
                                    .isUsed = hasNumber}),
    parameter<&JitteredGrid::cellWidth>({.name = "cellWidth",
                                         .caption = "Cell width",
                                         .hint = "How wide a cell is; the grid stands in the middle of the outline",
                                         .quantity = Quantity::Length,
                                         .range = kAboveZero,
                                         .usual = {0.01, 2.0, true},
                                         .isUsed = hasSize}),
    parameter<&JitteredGrid::cellHeight>({.name = "cellHeight",
                                          .caption = "Cell height",
                                          .hint = "How high a cell is; the grid stands in the middle of the outline",
                                          .quantity = Quantity::Length,
                                          .range = kAboveZero,
                                          .usual = {0.01, 2.0, true},
                                          .isUsed = hasSize}),
    parameter<&JitteredGrid::jitter>({.name = "jitter",
                                      .caption = "Jitter",
                                      .hint = "0: seeds in the middle of their cells; 1: anywhere in them",
                                      .range = {0.0, 1.0},
                                      .usual = {0.0, 1.0}}),
    parameter<&JitteredGrid::domain>(kDomainParameter),
};

/// The cells along one axis.
struct Axis {
    double from = 0.0;  // m
    double step = 0.0;  // m
    double count = 0.0;

    double at(std::uint32_t cell, double share) const { return from + step * (static_cast<double>(cell) + share); }
};

Axis axisOf(double from, double length, std::uint32_t count) {
    return {from, length / count, static_cast<double>(count)};
}

/// As many cells as fill the length best, in its middle.
Axis axisOf(double from, double length, double step) {
    const double count = std::max(1.0, std::floor(length / step + 0.5));
    return {from + (length - step * count) / 2.0, step, count};
}

Error tooManyCells(const LayerContext& context, double count) {
    return {ErrorCode::Limit, context.name() + " has " + messageText(count) + " cells along one side, but " +
                                  std::to_string(kMostOfPair) + " is the most."};
}

}  // namespace

constinit const PatternKind JitteredGrid::kKind{
    .name = "jitteredGrid",
    .caption = "Jittered grid",
    .hint = "One seed in each cell of a grid",
    .role = LayerRole::Scatters,
    .parameters = kParameters,
    .suitedTo = [](const Box2& bounds) -> LayerParameters {
        const Vec2 size = bounds.size();
        const double side = std::max(size.x, size.y) / kUsualAcross;
        const auto cellsAlong = [&](double length) {
            return static_cast<std::uint32_t>(std::max(1.0, std::floor(length / side + 0.5)));
        };
        return JitteredGrid{
            .columns = cellsAlong(size.x), .rows = cellsAlong(size.y), .cellWidth = side, .cellHeight = side};
    }};

Status JitteredGrid::apply(const LayerContext& context, SeedSet& seeds) const {
    const Box2 box = boundsOf(context.outline.outer);
    const Vec2 size = box.size();
    const bool isCounted = cells == GridCells::Number;
    const Axis across = isCounted ? axisOf(box.min.x, size.x, columns) : axisOf(box.min.x, size.x, cellWidth);
    const Axis up = isCounted ? axisOf(box.min.y, size.y, rows) : axisOf(box.min.y, size.y, cellHeight);
    if (const double most = std::max(across.count, up.count); !(most <= kMostOfPair))
        return tooManyCells(context, most);
    if (across.count * up.count > static_cast<double>(kMostSeeds - seeds.size())) return tooManySeeds(context);

    const bool isOutline = domain == ScatterDomain::Outline;
    std::size_t round = 0;
    for (const IndexPair cell :
         pairsBelow(static_cast<std::uint32_t>(across.count), static_cast<std::uint32_t>(up.count))) {
        if (context.isCancelledAt(round++)) return TaskContext::cancelled();
        const std::uint32_t index = cell.index();
        Random random = context.randomOf(index);
        const double x = across.at(cell.first, 0.5 + jitter * (random.unit() - 0.5));
        const double y = up.at(cell.second, 0.5 + jitter * (random.unit() - 0.5));
        if (isOutline && containment(context.outline, {x, y}) == Containment::Outside) continue;
        seeds.add({context.layer.id, index}, {x, y}, false);
    }
    return success();
}

}  // namespace rubble
